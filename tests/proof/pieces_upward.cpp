#include <tests/proof/pieces.hpp>

#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>

#include <algorithm>

namespace pmreport::test {

namespace {

using program::Bounds, program::Interval;

// One cubic over a part of the span: each of the three about the middle of that part, where they are narrow, and by their own ranges.
struct Ranges {
  Interval value, rate, acceleration;
};
Ranges over(const Cubic& c, Bounds time) {
  const auto of = [&](const Interval& t) {
    const Interval s = t - c.from;
    const Interval c1(c.c[1]), c2(c.c[2]), c3(c.c[3]);
    return Ranges{s * (s * (s * c3 + c2) + c1) + c.c[0], s * (s * c3 * 3.0 + c2 * 2.0) + c1, s * c3 * 6.0 + c2 * 2.0};
  };
  const Interval t(time), middle(time.middle()), away = t - middle;
  const Ranges wide = of(t), narrow = of(middle);
  const Interval rate = common(wide.rate, narrow.rate + wide.acceleration * away);
  return {common(wide.value, narrow.value + rate * away), rate, wide.acceleration};
}

void bound(const Pieces& p, Bounds time, mechanics::Bounded& out) {
  const auto& all = p.cubics;
  auto first = std::ranges::lower_bound(all.begin() + 1, all.end(), time.low, {}, &Cubic::from) - 1;
  const auto last = std::ranges::upper_bound(all.begin() + 1, all.end(), time.high, {}, &Cubic::from);
  const bool several = last - first > 1;
  Ranges sum = over(*first, {time.low, first + 1 < last ? (first + 1)->from : time.high});
  for (++first; first < last; ++first) {
    const Ranges next = over(*first, {first->from, first + 1 < last ? (first + 1)->from : time.high});
    sum = {hull(sum.value, next.value), hull(sum.rate, next.rate), hull(sum.acceleration, next.acceleration)};
  }
  out = {sum.value.bounds(), sum.rate.bounds(), sum.acceleration.bounds()};
  if (several && p.continuous < 1) out.rate = {};
  if (several && p.continuous < 2) out.acceleration = {};
}

}  // namespace

mechanics::Enclosure bounds_of(std::vector<Pieces> coordinates) {
  return [coordinates = std::move(coordinates)](Bounds time, mechanics::Bounded* out) {
    program::round_upward([&] {
      for (std::size_t i = 0; i < coordinates.size(); ++i) bound(coordinates[i], time, out[i]);
    });
    return true;
  };
}

}  // namespace pmreport::test
