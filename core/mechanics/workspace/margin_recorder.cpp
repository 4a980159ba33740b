#include <core/mechanics/workspace/margin_recorder.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace pmreport::mechanics {

namespace {

// The digits of a number that the geometry gives are good to about this, relative to one metre, or one radian.
constexpr double digits = 1e-12;
// Of a number of that size itself, such as a cosine.
constexpr double least_rounding = 1e-15;

Recorded least_of(const Recorded& a, const Recorded& b) { return choose(a < b, a, b); }
Recorded most_of(const Recorded& a, const Recorded& b) { return choose(a < b, b, a); }

// v >= min by sine and cosine; see the header.
Recorded at_least(const Recorded& s, const Recorded& c, double min) {
  const Recorded beyond = s * std::cos(min) - c * std::sin(min);
  return min <= 0 ? most_of(s, beyond) : least_of(s, beyond);
}

// The same where s is the root of `square`, and so never negative, by squares: x |x| rises with x. The limit is to lie where both cosine
// and sine of it count.
bool tells_by_squares(double end) { return end > 0 && end < std::numbers::pi && std::sin(end) > 0.05 && std::abs(std::cos(end)) > 0.05; }
Recorded beyond_by_squares(const Recorded& square, const Recorded& c, double end) {
  const double by_sine = std::sin(end), by_cosine = std::cos(end);
  return square * (by_cosine * std::abs(by_cosine)) - c * abs(c) * (by_sine * by_sine);
}

double scale_of(double end) { return std::max(1.0, std::abs(end)); }

}  // namespace

int MarginRecorder::begin(PoseLimit limit) {
  out_.limits.push_back(std::move(limit));
  return static_cast<int>(out_.limits.size()) - 1;
}

void MarginRecorder::margin(int limit, bool upper, const Recorded& value, double rounding) {
  out_.margins.push_back(
      {limit, upper, out_.limits[static_cast<std::size_t>(limit)].name + (upper ? ">" : "<"), std::max(rounding, least_rounding)});
  outputs.push_back(value);
}

// A number that is an angle of atan2, turned over or shifted by constants.
std::optional<MarginRecorder::ShiftedAngle> MarginRecorder::shifted_angle(int number) const {
  using program::Operation;
  ShiftedAngle out;
  for (;;) {
    const program::Step& s = step(number);
    const auto constant = [&](int operand) { return step(operand).operation == Operation::constant; };
    if (s.operation == Operation::atan2) {
      out.sine = s.a, out.cosine = s.b;
      return out;
    }
    if (s.operation == Operation::negate) {
      out.sign = -out.sign, number = s.a;
    } else if (s.operation == Operation::subtract && constant(s.a)) {
      out.offset += out.sign * step(s.a).constant, out.sign = -out.sign, number = s.b;
    } else if (s.operation == Operation::subtract && constant(s.b)) {
      out.offset -= out.sign * step(s.b).constant, number = s.a;
    } else if (s.operation == Operation::add && constant(s.a)) {
      out.offset += out.sign * step(s.a).constant, number = s.b;
    } else if (s.operation == Operation::add && constant(s.b)) {
      out.offset += out.sign * step(s.b).constant, number = s.a;
    } else {
      return std::nullopt;
    }
  }
}

void MarginRecorder::add_reach() {
  const int limit = begin({PoseLimit::Group::reach, "reach", "the mechanism can be assembled", "", 0, open_end});
  out_.margins.push_back({limit, false, "reach", 0});
  outputs.push_back(recorder_.output(0));
}

void MarginRecorder::add_output(PoseLimit asked, std::size_t o) {
  using program::Operation;
  const int limit = begin(std::move(asked));
  const double min = out_.limits.back().min, max = out_.limits.back().max, pi = std::numbers::pi;
  const int number = start_.outputs()[o];
  const program::Step& s = step(number);
  const Recorded value = recorder_.step(number);
  const bool lower = std::isfinite(min), upper = std::isfinite(max);
  if (s.operation == Operation::sqrt && (!upper || max >= 0)) {
    const Recorded square = recorder_.step(s.a);
    // A square root is never below zero.
    if (lower && min >= 0) margin(limit, false, square - min * min, 2 * digits * min * scale_of(min));
    if (upper) margin(limit, true, max * max - square, 2 * digits * max * scale_of(max));
    return;
  }
  if (s.operation == Operation::acos) {
    const Recorded cosine = recorder_.step(s.a);
    if (lower && min >= 0 && min <= pi) margin(limit, false, std::cos(min) - cosine, digits * std::sin(min));
    if (upper && max >= 0 && max <= pi) margin(limit, true, cosine - std::cos(max), digits * std::sin(max));
    if ((!lower || min <= pi) && (!upper || max >= 0)) return;
  }
  if (const std::optional<ShiftedAngle> angle = shifted_angle(number)) {
    // Of sign phi + offset between min and max, phi lies between these.
    double least = min - angle->offset, most = max - angle->offset;
    if (angle->sign < 0) std::tie(least, most) = std::pair(-most, -least);
    const Recorded sine = recorder_.step(angle->sine), c = recorder_.step(angle->cosine);
    const auto within = [&](double end) { return !std::isfinite(end) || std::abs(end) < pi; };
    if (within(least) && within(most)) {
      // The margins stay those of the value: what breaks its lower end comes first.
      const program::Step& root = step(angle->sine);
      const auto end = [&](bool upper_end) {
        const bool of_most = upper_end == (angle->sign > 0);
        if (const double at = of_most ? most : least; root.operation == Operation::sqrt && tells_by_squares(at)) {
          const Recorded beyond = beyond_by_squares(recorder_.step(root.a), c, at);
          margin(limit, upper_end, of_most ? -beyond : beyond, 2 * digits * std::sin(at) * std::abs(std::cos(at)));
          return;
        }
        margin(limit, upper_end, of_most ? at_least(-sine, c, -most) : at_least(sine, c, least), digits);
      };
      if (lower) end(false);
      if (upper) end(true);
      return;
    }
  }
  if (lower) margin(limit, false, value - min, digits * scale_of(min));
  if (upper) margin(limit, true, max - value, digits * scale_of(max));
}

void MarginRecorder::add_angle(PoseLimit asked, const Recorded& product, const Recorded& lengths) {
  const int limit = begin(std::move(asked));
  const double min = out_.limits.back().min, max = out_.limits.back().max, pi = std::numbers::pi;
  if (min > 0 && std::isfinite(min))
    margin(limit, false, lengths * std::cos(std::min(min, pi)) - product, digits * std::sin(std::min(min, pi)));
  if (max < pi) margin(limit, true, product - lengths * std::cos(std::max(max, 0.0)), digits * std::sin(std::max(max, 0.0)));
}

void MarginRecorder::add_square(PoseLimit asked, const Recorded& square) {
  const int limit = begin(std::move(asked));
  const double min = out_.limits.back().min, max = out_.limits.back().max;
  if (min > 0 && std::isfinite(min)) margin(limit, false, square - min * min, 2 * digits * min * scale_of(min));
  if (std::isfinite(max)) margin(limit, true, max * max - square, 2 * digits * max * scale_of(max));
}

void MarginRecorder::add_late(PoseLimit asked, bool lower, bool upper) {
  const int limit = begin(std::move(asked));
  for (const bool above : {false, true})
    if (above ? upper : lower) {
      out_.margins.push_back({limit, above, out_.limits.back().name + (above ? ">" : "<"), digits});
      ++out_.late;
    }
}

}  // namespace pmreport::mechanics
