// A hexapod on six legs with balls at both ends, whose joints are cones about the legs' directions at home, at a fixed orientation: twelve
// stroke and twelve cone margins, as squares and cosines. The measure of scans and proofs.
#pragma once

#include <core/program/recorder.hpp>
#include <core/scan/pose_set.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace pmreport::bench {

inline scan::PoseSet six_ups() {
  constexpr double degree = std::numbers::pi / 180, least = 0.72, most = 0.98, home = 0.8;
  constexpr std::array<double, 6> base{15, 105, 135, 225, 255, 345}, platform{45, 75, 165, 195, 285, 315};
  program::Recorder recorder(3);
  std::vector<Recorded> strokes{Recorded(1.0)}, cones;  // the reach has no bounds
  for (std::size_t i = 0; i < 6; ++i) {
    const double x = 0.2 * std::cos(platform[i] * degree) - 0.3 * std::cos(base[i] * degree);
    const double y = 0.2 * std::sin(platform[i] * degree) - 0.3 * std::sin(base[i] * degree);
    const double length = std::sqrt(x * x + y * y + home * home);
    const Recorded dx = recorder.input(0) + Recorded(x), dy = recorder.input(1) + Recorded(y), dz = recorder.input(2);
    const Recorded square = dx * dx + dy * dy + dz * dz,
                   along = (Recorded(x) * dx + Recorded(y) * dy + Recorded(home) * dz) / Recorded(length);
    strokes.push_back(square - Recorded(least * least));
    strokes.push_back(Recorded(most * most) - square);
    for (const double angle : {30.0, 25.0}) cones.push_back(along - Recorded(std::cos(angle * degree)) * sqrt(square));
  }
  strokes.insert(strokes.end(), cones.begin(), cones.end());
  return {recorder.finish(strokes), std::vector<double>(strokes.size(), 1e-14), {}};
}

inline scan::Scan six_ups_range() { return {{0, 0, 0.8}, {{0, -0.7, 0.7, 1}, {1, -0.7, 0.7, 1}, {2, 0.1, 1.5, 1}}, {}, {}}; }

}  // namespace pmreport::bench
