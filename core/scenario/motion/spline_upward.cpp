#include <algorithm>
#include <array>
#include <cmath>
#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>
#include <core/scenario/motion/spline.hpp>
#include <span>

namespace pmreport::scenario {
namespace {

using program::Bounds, program::Interval;
using Enclosed = Jet<Interval>;

constexpr std::size_t few = 8;  // pieces: no table is made for these

Enclosed either(const Enclosed& a, const Enclosed& b) {
  return {hull(a.value, b.value), hull(a.rate, b.rate), hull(a.acceleration, b.acceleration)};
}

// f from its values at both ends of a span and f' in it: where f rises or falls throughout, its range is that of the ends.
Interval between(const Interval& at_begin, const Interval& at_end, const Interval& rate, const Interval& upto) {
  const Interval step = rate * upto;
  return common(at_begin + step, at_end - step);
}
Enclosed between(const Enclosed& begin, const Enclosed& end, const Interval& jerk, double length) {
  const Interval upto(0.0, length);
  Enclosed x;
  x.acceleration = between(begin.acceleration, end.acceleration, jerk, upto);
  x.rate = between(begin.rate, end.rate, x.acceleration, upto);
  x.value = between(begin.value, end.value, x.rate, upto);
  return x;
}

// Of one piece over a span, cut where the piece turns: where exactly does not matter, the bounds hold for any cut. `cuts`: rising.
template <class Piece>
Enclosed over_piece(const Piece& piece, double from, double to, std::span<const double> cuts) {
  Enclosed begin = piece.at(from), out = begin;
  double at = from;
  const auto go_to = [&](double t) {
    const Enclosed end = piece.at(t);
    out = either(out, between(begin, end, piece.jerk(at, t), t - at));
    begin = end, at = t;
  };
  for (const double t : cuts)
    if (t > at && t < to) go_to(t);
  if (to > at) go_to(to);
  return out;
}

// With s = t - t0 and second derivatives M0, M1 at the ends:  y0 + c s + M0 s^2 / 2 + j s^3 / 6,  j = (M1 - M0) / h, and c such that y1 is
// met. Every s of the piece is in [0, h], and beyond the ends of the curve outside.
class Cubic {
 public:
  Cubic(double t0, double t1, double y0, double y1, double m0, double m1) : t0_(t0), y0_(y0), bend_(m0) {
    const Interval h = Interval(t1) - t0;
    slope_ = (Interval(y1) - y0) / h - h * (2.0 * Interval(m0) + m1) / 6.0;
    jerk_ = (Interval(m1) - m0) / h;
  }
  Enclosed at(double t) const {
    const Interval s = Interval(t) - t0_;
    return {y0_ + s * (slope_ + s * (0.5 * bend_ + s * jerk_ / 6.0)), slope_ + s * (bend_ + 0.5 * (s * jerk_)), bend_ + s * jerk_};
  }
  const Interval& jerk(double, double) const { return jerk_; }

  // The zeros of c + M0 s + j s^2 / 2, and that of its rate between them.
  std::array<double, 3> turns() const {
    const double a = slope_.middle(), b = bend_.middle(), c = 0.5 * jerk_.middle(), middle = -0.5 * b / c;
    const double under = b * b - 4 * a * c;
    if (!(under >= 0)) return {t0_ + middle, t0_ + middle, t0_ + middle};
    const double q = -0.5 * (b + std::copysign(std::sqrt(under), b));
    std::array<double, 3> out{t0_ + q / c, t0_ + middle, t0_ + a / q};
    if (!(out[0] <= out[2])) std::swap(out[0], out[2]);
    return out;
  }

 private:
  double t0_;
  Interval y0_, bend_, slope_, jerk_;
};

// With u = (t - t0) / h:  y0 + (y1 - y0) (10 u^3 - 15 u^4 + 6 u^5), whose third derivative is 60 (6 (u - 1/2)^2 - 1/2).
class Quintic {
 public:
  Quintic(double t0, double t1, double y0, double y1) : t0_(t0), t1_(t1), h_(Interval(t1) - t0), y0_(y0), step_(Interval(y1) - y0) {}
  Enclosed at(double t) const {
    const Interval u = share(t), v = 1.0 - u, rate = step_ / h_;
    return {y0_ + step_ * (u * u * u * (10.0 + u * (6.0 * u - 15.0))), rate * (30.0 * square(u * v)),
            rate / h_ * (60.0 * (u * v * (v - u)))};
  }
  Interval jerk(double from, double to) const {
    return step_ / (h_ * square(h_)) * (60.0 * (6.0 * square(hull(share(from), share(to)) - 0.5) - 0.5));
  }

  // The zeros of its third derivative, and that of its second between them.
  std::array<double, 3> turns() const {
    const double aside = 0.28867513459481288225, h = h_.middle();  // 1 / sqrt(12)
    return {t0_ + h * (0.5 - aside), t0_ + 0.5 * h, t0_ + h * (0.5 + aside)};
  }

 private:
  Interval share(double t) const { return common((Interval(std::clamp(t, t0_, t1_)) - t0_) / h_, Interval(0.0, 1.0)); }

  double t0_, t1_;
  Interval h_, y0_, step_;
};

Jet<Bounds> plain(const Enclosed& x) { return {x.value.bounds(), x.rate.bounds(), x.acceleration.bounds()}; }
Enclosed enclosed(const Jet<Bounds>& x) { return {Interval(x.value), Interval(x.rate), Interval(x.acceleration)}; }

// Over all pieces that the span touches: those at its ends as far as it goes, those between as a whole. `piece(i)`: Cubic or Quintic.
template <class Piece>
Jet<Bounds> over_pieces(const std::vector<double>& times, const WholePieces& whole, const Piece& piece, Bounds time) {
  if (!(time.low <= time.high) || !time.bounded()) return {};
  const auto inner = times.begin() + 1, last_inner = times.end() - 1;
  const auto first = static_cast<std::size_t>(std::lower_bound(inner, last_inner, time.low) - inner),
             last = static_cast<std::size_t>(std::upper_bound(inner, last_inner, time.high) - inner);
  const auto part = [&](std::size_t i, double from, double to) {
    const auto p = piece(i);
    return over_piece(p, from, to, p.turns());
  };
  const auto all_of = [&](std::size_t i) { return plain(part(i, times[i], times[i + 1])); };
  if (first == last) return plain(part(first, time.low, time.high));
  Enclosed out = either(part(first, time.low, times[first + 1]), part(last, times[last], time.high));
  if (last - first > few) return plain(either(out, enclosed(whole.of(first + 1, last - 1, times.size() - 1, all_of))));
  for (std::size_t i = first + 1; i < last; ++i) out = either(out, enclosed(all_of(i)));
  return plain(out);
}

}  // namespace

Jet<Bounds> CubicSpline::over(Bounds time) const {
  const auto piece = [&](std::size_t i) { return Cubic(times_[i], times_[i + 1], values_[i], values_[i + 1], bends_[i], bends_[i + 1]); };
  return program::round_upward([&] { return over_pieces(times_, whole_, piece, time); });
}

// Beyond the ends all is as at the end.
Jet<Bounds> QuinticSteps::over(Bounds time) const {
  const Bounds inside{std::clamp(time.low, times_.front(), times_.back()), std::clamp(time.high, times_.front(), times_.back())};
  const auto piece = [&](std::size_t i) { return Quintic(times_[i], times_[i + 1], values_[i], values_[i + 1]); };
  return program::round_upward([&] { return over_pieces(times_, whole_, piece, inside); });
}

}  // namespace pmreport::scenario
