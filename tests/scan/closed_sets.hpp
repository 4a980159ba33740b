// Sets of poses whose volume is a closed form.
#pragma once

#include <core/program/recorder.hpp>
#include <core/scan/pose_set.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace pmreport::scan {

// `record` fills the margins behind the reach, from a recorder of so many inputs.
template <class F>
PoseSet recorded_set(int inputs, F&& record) {
  program::Recorder recorder(inputs);
  std::vector<Recorded> margins{Recorded(1.0)};
  record(recorder, margins);
  return {recorder.finish(margins), std::vector<double>(margins.size(), 0.0), {}};
}

// [-half, half]^d and a bit to one side, so that no symmetry of the set is one of the boxes.
inline Scan off_centre(int axes, double half, double shift = 0.0137) {
  Scan scan;
  scan.at.assign(static_cast<std::size_t>(axes), 0.0);
  for (int a = 0; a < axes; ++a) scan.points.push_back({a, -half + shift * (a + 1), half + shift * (a + 1), 1});
  return scan;
}

inline Recorded square_distance(program::Recorder& r, const std::vector<double>& from) {
  Recorded sum(0.0);
  for (std::size_t a = 0; a < from.size(); ++a) {
    const Recorded d = r.input(static_cast<int>(a)) - Recorded(from[a]);
    sum = sum + d * d;
  }
  return sum;
}

// Volume of the unit ball in d dimensions.
inline double unit_ball(int d) { return std::pow(M_PI, 0.5 * d) / std::tgamma(0.5 * d + 1); }

}  // namespace pmreport::scan
