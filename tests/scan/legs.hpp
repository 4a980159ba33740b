// A platform on three to six legs of bounded length and tilt, written over any scalar: recorded for a proof, in extended precision for the
// attack on it.
#pragma once

#include <tests/scan/closed_sets.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace pmreport::scan {

// Coordinates: the position, then angles of turns about x, y and z, as many as there are. The reach first.
template <class T>
std::vector<T> leg_margins(const std::vector<T>& x, int legs = 6) {
  using std::sqrt, std::sin, std::cos;
  std::vector<T> out{T(1.0)};
  for (int i = 0; i < legs; ++i) {
    const double a = 2 * M_PI * i / legs + (i % 2 ? 0.5 : -0.5), b = 2 * M_PI * i / legs + (i % 2 ? -0.3 : 0.3);
    std::array<T, 3> p{T(0.6 * std::cos(b)), T(0.6 * std::sin(b)), T(0.05)};
    for (std::size_t turn = 3; turn < x.size(); ++turn) {
      const T s = sin(x[turn]), c = cos(x[turn]);
      T &u = p[(turn - 2) % 3], &v = p[(turn - 1) % 3];
      const T turned = c * u - s * v;
      v = s * u + c * v;
      u = turned;
    }
    const T dx = p[0] + x[0] - T(std::cos(a)), dy = p[1] + x[1] - T(std::sin(a)), dz = p[2] + x[2];
    const T square = dx * dx + dy * dy + dz * dz;
    out.push_back(square - T(0.9 * 0.9));
    out.push_back(T(1.4 * 1.4) - square);
    out.push_back(dz - T(std::cos(0.75)) * sqrt(square));
  }
  return out;
}

inline PoseSet leg_set(int inputs, int legs = 6) {
  program::Recorder recorder(inputs);
  std::vector<Recorded> x;
  for (int i = 0; i < inputs; ++i) x.push_back(recorder.input(i));
  const std::vector<Recorded> margins = leg_margins(x, legs);
  return {recorder.finish(margins), std::vector<double>(margins.size(), 1e-14), {}};
}

// The least margin of a pose, and which it is.
inline std::pair<long double, int> least_margin(const std::vector<long double>& x, int legs = 6) {
  const std::vector<long double> margins = leg_margins(x, legs);
  const auto least = std::min_element(margins.begin(), margins.end());
  return {*least, static_cast<int>(least - margins.begin())};
}

// Position about (0, 0, 1), then turns about nothing.
inline Scan leg_scan(int inputs, double reach = 0.6, double turn = 0.7) {
  Scan scan;
  scan.at.assign(static_cast<std::size_t>(inputs), 0.0);
  scan.at[2] = 1;
  for (int i = 0; i < inputs; ++i) {
    const double half = i < 3 ? reach : turn, c = scan.at[static_cast<std::size_t>(i)];
    scan.points.push_back({i, c - half, c + half, 1});
  }
  return scan;
}

}  // namespace pmreport::scan
