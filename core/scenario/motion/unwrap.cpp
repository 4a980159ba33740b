#include <cmath>
#include <core/scenario/motion/unwrap.hpp>
#include <numbers>

namespace pmreport::scenario {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double nearly = turn * 60 / 360;  // how near to a whole turn a step looks like one

}  // namespace

// The rate on the way to the point before, or else that beyond this one, foretells the step. Whoever turns fast, 350 degrees a row, has
// steps that are foretold as they are. Two points foretell nothing.
std::optional<std::size_t> wrapped_at(const std::vector<double>& times, const std::vector<double>& angles) {
  const auto rate = [&](std::size_t i) { return (angles[i] - angles[i - 1]) / (times[i] - times[i - 1]); };
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double step = angles[i] - angles[i - 1], shorter = step - std::copysign(turn, step);
    if (!(std::abs(shorter) < nearly) || (i == 1 && angles.size() == 2)) continue;
    const double foretold = (times[i] - times[i - 1]) * rate(i > 1 ? i - 1 : i + 1);
    if (std::abs(shorter - foretold) < std::abs(step - foretold)) return i;
  }
  return std::nullopt;
}

void unwrap(std::vector<double>& angles) {
  double turns = 0, before = angles.empty() ? 0 : angles.front();
  for (double& angle : angles) {
    turns -= std::round((angle - before) / turn);
    before = angle;
    angle += turns * turn;
  }
}

}  // namespace pmreport::scenario
