#include <core/analysis/proof/followed_krawczyk.hpp>

#include <core/analysis/proof/followed_linearised.hpp>
#include <core/program/intervals/rounding.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

using program::round_upward;

namespace {

// A box is enlarged by this share of its width at either side, and by this share of the coordinates' sizes, which rounding needs.
constexpr double inflation = 0.2, least_inflation = 0x1p-46;
constexpr double largest_offset = 0.5;  // in sizes
// With |R| d < k d the first box proves something when k < 0.28, the second when k < 0.61, the third when k < 0.68: more gain little.
constexpr int most_rounds = 3;
// A box that no longer shrinks to this share of its width is as small as the span lets it be.
constexpr double worth_while = 0.7;
constexpr int most_contractions = 4;

}  // namespace

struct Krawczyk::Work {
  Work(const ActuatorGeometry& geometry, const SmallVector& coordinate_sizes)
      : near(geometry, coordinate_sizes), sizes(coordinate_sizes), m(static_cast<std::size_t>(geometry.dof)) {}

  Linearised near;
  const SmallVector& sizes;
  const std::size_t m;
  Numbers error_now, shift;  // Y F(0, c); -Y F(0, T)

  static Interval since(const MovingFrame& frame, Bounds time) { return Interval(time) - frame.middle; }

  bool start(const MovingFrame& frame, const Interval& elapsed, const mechanics::Bounded* at_middle) {
    near.begin(frame, elapsed);
    error_now = near.error_now(at_middle);
    return std::all_of(error_now.begin(), error_now.begin() + static_cast<std::ptrdiff_t>(m),
                       [](const Interval& x) { return x.bounded(); });
  }

  // (3) and (4), preconditioned.
  void find_shift(const MovingFrame& frame, const Prescribed& prescribed) {
    const Interval elapsed = near.elapsed();
    const Numbers lag = near.left_of(near.numbers(prescribed.over, &mechanics::Bounded::rate), frame.velocity);
    for (std::size_t i = 0; i < m; ++i) shift[i] = lag[i] * elapsed - error_now[i];
    if (!prescribed.steady || !near.smooth()) return;
    const Numbers lag_now = near.left_at_middle(near.numbers(prescribed.at_middle, &mechanics::Bounded::rate), frame.velocity),
                  turned = near.turned(frame.velocity),
                  bent = near.preconditioned(near.numbers(prescribed.over, &mechanics::Bounded::acceleration));
    const Interval half_square = square(elapsed) * 0.5;
    for (std::size_t i = 0; i < m; ++i)
      shift[i] = common(shift[i], lag_now[i] * elapsed + (bent[i] - turned[i]) * half_square - error_now[i]);
  }

  Offsets krawczyk(const Offsets& d) const {  // K(D)
    Numbers x;
    for (std::size_t i = 0; i < m; ++i) x[i] = Interval(d[i]);
    x = near.with_rest(shift, x);
    Offsets out{};
    for (std::size_t i = 0; i < m; ++i) out[i] = x[i].bounds();
    return out;
  }

  bool interior(const Offsets& inner, const Offsets& outer) const {
    for (std::size_t i = 0; i < m; ++i)
      if (!(inner[i].low > outer[i].low && inner[i].high < outer[i].high)) return false;
    return true;
  }
  bool too_large(const Offsets& d) const {
    for (std::size_t i = 0; i < m; ++i)
      if (!(std::max(-d[i].low, d[i].high) < largest_offset * Linearised::entry(sizes, i))) return true;
    return false;
  }
  static Offsets none() {
    Offsets out;
    out.fill(Bounds::exactly(0));
    return out;
  }
  static Offsets either(const Offsets& a, const Offsets& b) {
    Offsets out;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = hull(a[i], b[i]);
    return out;
  }
  Offsets both(const Offsets& a, const Offsets& b) const {
    Offsets out = a;
    for (std::size_t i = 0; i < m; ++i) out[i] = common(a[i], b[i]);
    return out;
  }
  Offsets inflated(Offsets d) const {
    for (std::size_t i = 0; i < m; ++i) {
      const double more = inflation * d[i].width() + least_inflation * Linearised::entry(sizes, i);
      d[i] = {d[i].low - more, d[i].high + more};
    }
    return d;
  }

  Found find(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, const Offsets& include, Offsets& only, Offsets& within,
             int& rounds) {
    rounds = 0;
    if (!start(frame, since(frame, time), prescribed.at_middle)) return Found::no_bounds;
    if (const Found f = near.differentiate(none()); f != Found::one) return f;
    find_shift(frame, prescribed);
    const Offsets least = either(include, none());
    Offsets now = inflated(either(least, krawczyk(none())));
    while (rounds < most_rounds && !too_large(now)) {
      ++rounds;
      if (const Found f = near.differentiate(now); f != Found::one) return f;
      const Offsets next = krawczyk(now);
      if (interior(next, now)) {
        only = now;
        within = next;
        for (int k = 0; k < 2; ++k) within = both(within, krawczyk(within));
        return Found::one;
      }
      now = inflated(either(least, next));
    }
    return Found::undecided;
  }

  bool contract(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, Offsets& within) {
    if (!start(frame, since(frame, time), prescribed.at_middle)) return false;
    for (int k = 0; k < most_contractions; ++k) {
      const Offsets before = within, with_zero = either(within, none());
      if (near.differentiate(with_zero) != Found::one) return k > 0;
      find_shift(frame, prescribed);
      within = both(within, krawczyk(with_zero));
      bool shrinks = false;
      for (std::size_t i = 0; i < m; ++i) {
        if (!within[i].bounded()) return false;
        shrinks = shrinks || within[i].width() < worth_while * before[i].width();
      }
      if (!shrinks) break;
    }
    return true;
  }

  bool enclose(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, const Offsets& within, mechanics::Bounded* out) {
    near.begin(frame, since(frame, time));
    Numbers rate;
    if (near.differentiate(within) != Found::one || !near.find_rates(prescribed.over, rate)) return false;
    const bool smooth = near.smooth();  // of all the span, before the middle alone is looked at
    const Numbers acceleration = near.find_accelerations(prescribed.over, rate);
    Numbers value = near.coordinates();
    if (time.low < time.high) sharpen(frame, time, prescribed, within, prescribed.steady && smooth, acceleration, value, rate);
    for (std::size_t i = 0; i < m; ++i) out[i] = {value[i].bounds(), rate[i].bounds(), smooth ? acceleration[i].bounds() : Bounds{}};
    return true;
  }

  // (7).
  void sharpen(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, const Offsets& within, bool rates_steady,
               const Numbers& acceleration, Numbers& value, Numbers& rate) {
    const Offsets with_zero = either(within, none());
    if (!start(frame, Interval(0.0), prescribed.at_middle) || near.differentiate(with_zero) != Found::one) return;
    find_shift(frame, {prescribed.at_middle, prescribed.at_middle, prescribed.steady});
    const Offsets now = both(within, krawczyk(with_zero));
    const Interval elapsed = since(frame, time);
    Numbers rate_now;
    if (rates_steady && near.find_rates(prescribed.at_middle, rate_now))
      for (std::size_t i = 0; i < m; ++i) rate[i] = common(rate[i], rate_now[i] + acceleration[i] * elapsed);
    for (std::size_t i = 0; i < m; ++i)
      value[i] = common(value[i], Interval(now[i]) + Linearised::entry(frame.origin, i) + rate[i] * elapsed);
  }

  static Offsets seen_from(const MovingFrame& frame, Bounds time, const MovingBox& box) {
    const Interval between = Interval(frame.middle) - box.frame.middle, elapsed = since(frame, time);
    Offsets out{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(frame.origin.size()); ++i) {
      const double old = Linearised::entry(box.frame.velocity, i), now = Linearised::entry(frame.velocity, i);
      const Interval moved = Interval(Linearised::entry(box.frame.origin, i)) - Linearised::entry(frame.origin, i) + between * old;
      out[i] = (moved + (Interval(old) - now) * elapsed + Interval(box.offsets[i])).bounds();
    }
    return out;
  }
};

Krawczyk::Krawczyk(const ActuatorGeometry& geometry, const SmallVector& sizes) {
  round_upward([&] { work_ = std::make_unique<Work>(geometry, sizes); });
}
Krawczyk::~Krawczyk() = default;

Krawczyk::Found Krawczyk::find(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, const Offsets& include, Offsets& only,
                               Offsets& within, int& rounds) {
  return round_upward([&] { return work_->find(frame, time, prescribed, include, only, within, rounds); });
}

bool Krawczyk::contract(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, Offsets& within) {
  return round_upward([&] { return work_->contract(frame, time, prescribed, within); });
}

bool Krawczyk::enclose(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, const Offsets& within,
                       mechanics::Bounded* out) {
  return round_upward([&] { return work_->enclose(frame, time, prescribed, within, out); });
}

Offsets Krawczyk::seen_from(const MovingFrame& frame, Bounds time, const MovingBox& box) {
  return round_upward([&] { return Work::seen_from(frame, time, box); });
}

}  // namespace pmreport::analysis
