#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <core/numbers.hpp>
#include <core/scenario/motion/laws.hpp>
#include <core/text/text.hpp>
#include <limits>

namespace pmreport::scenario {
namespace {

using mechanics::Break;
using Derivatives = std::array<double, 3>;  // value, rate, acceleration

Derivatives at(const Law& law, double t) {
  const Jet<double> x = law.at(t);
  return {x.value, x.rate, x.acceleration};
}

// What the law does away from its switches: how far its value goes, and the largest rate and acceleration.
struct Scales {
  Derivatives size{};  // of the value its span
  double largest = 0;  // magnitude of the value
};
Scales scales_of(const Law& law) {
  Scales out;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  // Between two switches that are closer than the steps it may do all that it does.
  std::vector<double> ends = law.steps;
  for (const Switch& s : law.switches) ends.push_back(s.time());
  std::sort(ends.begin(), ends.end());
  // At two places between, aside from the middle, where the rate of what comes and goes is zero.
  for (std::size_t i = 1; i < ends.size(); ++i)
    for (const double share : {0.25, 0.7}) {
      const Derivatives x = at(law, ends[i - 1] + share * (ends[i] - ends[i - 1]));
      if (!std::isfinite(x[0] + x[1] + x[2])) continue;
      low = std::min(low, x[0]), high = std::max(high, x[0]);
      for (const std::size_t k : {1, 2}) out.size[k] = std::max(out.size[k], std::abs(x[k]));
      out.largest = std::max(out.largest, std::abs(x[0]));
    }
  out.size[0] = std::max(high - low, 0.0);
  return out;
}

// How much each derivative wavers over a few neighbouring numbers on one side: what rounding makes of it there.
Derivatives noise(const Law& law, double t, double away) {
  const Derivatives here = at(law, t);
  Derivatives out{};
  for (int i = 0; i < 3; ++i) {
    t = std::nextafter(std::nextafter(t, away), away);
    const Derivatives x = at(law, t);
    for (std::size_t k = 0; k < 3; ++k) out[k] = std::max(out[k], std::abs(x[k] - here[k]));
  }
  return out;
}

}  // namespace

std::vector<Break> breaks_of(const Law& law) {
  constexpr double share = 1e-9;     // of a scale: less is no jump that anybody would feel
  constexpr double boundless = 1e5;  // times a scale, so near beside the place that it has none there
  constexpr double nothing = 1e-12;  // of the value, a step long: where only rounding moves
  std::vector<Break> out;
  if (law.switches.empty()) return out;
  const Scales scales = scales_of(law);
  const double pace = static_cast<double>(law.steps.size()) / (law.steps.back() - law.steps.front());
  for (const Switch& s : law.switches) {
    const Derivatives before = at(law, s.before), after = at(law, s.after), left = noise(law, s.before, -infinity),
                      right = noise(law, s.after, infinity);
    for (std::size_t k = 0; k < 3; ++k) {
      const double floor = nothing * scales.largest * std::pow(pace, static_cast<double>(k));
      const double scale = std::max(scales.size[k], floor), beside = std::max(std::abs(before[k]), std::abs(after[k]));
      const double jump = std::abs(after[k] - before[k]);
      const bool unbounded = !std::isfinite(jump) || beside > boundless * (scale + (k == 0 ? scales.largest : 0));
      // Beside a touch the sides are a little apart, and what is smooth moves on from one to the other.
      const double moves = k < 2 ? std::max(std::abs(before[k + 1]), std::abs(after[k + 1])) : pace * scale;
      const double rounding = 10 * (left[k] + right[k]) + (k == 0 ? 64 * std::numeric_limits<double>::epsilon() * beside : 0) +
                              10 * moves * (s.after - s.before);
      if (!unbounded && !(jump > std::max(share * scale, rounding))) continue;
      out.push_back({static_cast<Break::Of>(k), law.name, law.unit, s.time(), unbounded ? infinity : jump});
      break;
    }
  }
  return out;
}

bool bounded(const Law& law, const std::vector<Break>& breaks, Diagnostics& diagnostics) {
  constexpr const char* words[] = {"value", "rate", "acceleration"};
  for (const Break& b : breaks) {
    if (std::isfinite(b.jump)) continue;
    diagnostics.add(law.place,
                    fmt::format("{} has no finite {} at t = {} s", law.name, words[static_cast<int>(b.of)], format_number(b.time, 9)));
    return false;
  }
  return true;
}

}  // namespace pmreport::scenario
