#include <core/analysis/proof/followed_krawczyk.hpp>

#include <core/program/interval.hpp>
#include <core/program/rounding.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

using program::Interval, program::round_upward;

namespace {

using Numbers = std::array<Interval, 6>;
using Matrix = std::array<Numbers, 6>;

constexpr int most_rounds = 5;
// A box is enlarged by this share of its width at either side, and by this of the coordinates' sizes, which rounding takes for nothing.
constexpr double inflation = 0.5, least_inflation = 0x1p-46;
constexpr double largest_offset = 0.5;  // in sizes
// A box that no longer shrinks to this share of its width is as small as the span lets it be.
constexpr double worth_while = 0.7;
constexpr int most_contractions = 4;

Offsets inflated(const Offsets& d, const SmallVector& sizes) {
  Offsets out = d;
  for (int i = 0; i < sizes.size(); ++i) {
    Bounds& b = out[static_cast<std::size_t>(i)];
    const double more = inflation * b.width() + least_inflation * sizes(i);
    b = {b.low - more, b.high + more};
  }
  return out;
}

}  // namespace

struct Krawczyk::Work {
  Work(const ActuatorGeometry& of, const SmallVector& coordinate_sizes)
      : geometry(of),
        sizes(coordinate_sizes),
        m(static_cast<std::size_t>(of.dof)),
        values(of.values),
        partials(of.partials),
        in_time(of.in_time),
        turning(of.turning),
        in(3 * m),
        out(std::max({of.partials.outputs().size(), of.in_time.outputs().size(), of.turning.outputs().size()})) {}

  const ActuatorGeometry& geometry;
  const SmallVector& sizes;
  const std::size_t m;
  program::Evaluator<Interval> values, partials, in_time, turning;
  std::vector<Interval> in, out;

  // What follows of one span and one box.
  Interval elapsed;             // T - c
  Numbers coordinates;          // X
  Matrix jacobian, turn, rest;  // J(X) = jacobian + J' (T - c) of (4); Y J'; R = I - Y J(X)
  bool smooth = true;           // no kink in X
  Numbers error_now, shift;     // F(0, c); -Y F(0, T)

  static double entry(const SmallMatrix& a, std::size_t i, std::size_t j) {
    return a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  static double entry(const SmallVector& a, std::size_t i) { return a(static_cast<Eigen::Index>(i)); }

  // F(0, c). False where the geometry has no bounds.
  bool start(const MovingFrame& frame, Bounds time, const Prescribed& prescribed) {
    elapsed = Interval(time) - Interval(frame.middle);
    for (std::size_t i = 0; i < m; ++i) in[i] = Interval(entry(frame.origin, i));
    values.run({in.data(), m}, {out.data(), m});
    for (std::size_t k = 0; k < m; ++k) {
      error_now[k] = out[k] - Interval(prescribed.at_middle[k].value);
      if (!error_now[k].bounded()) return false;
    }
    return true;
  }

  // X, J(X) and R.
  Found differentiate(const MovingFrame& frame, const Offsets& d) {
    Numbers start;
    for (std::size_t i = 0; i < m; ++i) {
      start[i] = Interval(d[i]) + entry(frame.origin, i);
      coordinates[i] = start[i] + elapsed * entry(frame.velocity, i);
      in[i] = coordinates[i];
      in[m + i] = Interval(entry(frame.velocity, i));
    }
    const std::size_t choices = static_cast<std::size_t>(geometry.choices), switches = geometry.outputs() - m;
    turning.run({in.data(), 2 * m}, {out.data(), switches + m * m});
    smooth = true;
    for (std::size_t c = 0; c < switches; ++c) {
      if (!out[c].bounded()) return Found::no_bounds;
      const bool open = out[c].width() != 0;
      if (open && c < choices) return Found::choice;
      smooth = smooth && !open;
    }
    for (std::size_t k = 0; k < m * m; ++k) smooth = smooth && out[switches + k].bounded();
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < m; ++j) {
        turn[i][j] = Interval(0.0);
        for (std::size_t k = 0; smooth && k < m; ++k) turn[i][j] += out[switches + k * m + j] * entry(frame.inverse, i, k);
      }

    std::copy_n((smooth ? start : coordinates).begin(), m, in.begin());
    partials.run({in.data(), m}, {out.data(), geometry.outputs() * (1 + m)});
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t j = 0; j < m; ++j) {
        jacobian[k][j] = out[geometry.outputs() + k * m + j];
        if (!out[k].bounded() || !jacobian[k][j].bounded()) return Found::no_bounds;
      }
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < m; ++j) {
        rest[i][j] = Interval(i == j ? 1.0 : 0.0) - turn[i][j] * elapsed;
        for (std::size_t k = 0; k < m; ++k) rest[i][j] -= jacobian[k][j] * entry(frame.inverse, i, k);
      }
    return Found::one;
  }

  // Y x.
  Numbers preconditioned(const MovingFrame& frame, const Numbers& x) const {
    Numbers y;
    for (std::size_t i = 0; i < m; ++i) {
      y[i] = Interval(0.0);
      for (std::size_t k = 0; k < m; ++k) y[i] += x[k] * entry(frame.inverse, i, k);
    }
    return y;
  }
  // Y (b - J x0).
  Numbers left_of(const MovingFrame& frame, Numbers b, const SmallVector& x0) const {
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t j = 0; j < m; ++j) b[k] -= jacobian[k][j] * entry(x0, j);
    Numbers x = preconditioned(frame, b);
    for (std::size_t i = 0; i < m; ++i) {
      Interval turned(0.0);
      for (std::size_t j = 0; j < m; ++j) turned += turn[i][j] * entry(x0, j);
      x[i] -= turned * elapsed;
    }
    return x;
  }
  static Numbers numbers(const mechanics::Bounded* of, std::size_t m, Bounds mechanics::Bounded::*part) {
    Numbers x;
    for (std::size_t k = 0; k < m; ++k) x[k] = Interval(of[k].*part);
    return x;
  }

  // (3), preconditioned.
  void find_shift(const MovingFrame& frame, const Prescribed& prescribed) {
    const Numbers lag = left_of(frame, numbers(prescribed.over, m, &mechanics::Bounded::rate), frame.velocity),
                  error = preconditioned(frame, error_now);
    for (std::size_t i = 0; i < m; ++i) shift[i] = lag[i] * elapsed - error[i];
  }

  Numbers remains_of(const Numbers& start, const Numbers& d) const {  // start + R d
    Numbers x = start;
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < m; ++j) x[i] += rest[i][j] * d[j];
    return x;
  }
  Offsets krawczyk(const Offsets& d) const {  // K(D)
    Numbers x;
    for (std::size_t i = 0; i < m; ++i) x[i] = Interval(d[i]);
    x = remains_of(shift, x);
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
      if (!(std::max(-d[i].low, d[i].high) < largest_offset * entry(sizes, i))) return true;
    return false;
  }
  Offsets with_zero(const Offsets& a) const {
    Offsets out = a;
    for (std::size_t i = 0; i < m; ++i) out[i] = hull(a[i], Bounds::exactly(0));
    return out;
  }

  Found find(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, const Offsets& include, Offsets& only, Offsets& within,
             int& rounds) {
    rounds = 0;
    if (!start(frame, time, prescribed)) return Found::no_bounds;
    if (const Found f = differentiate(frame, none()); f != Found::one) return f;
    find_shift(frame, prescribed);
    const auto enlarged = [&](const Offsets& d) {
      Offsets out = with_zero(include);
      for (std::size_t i = 0; i < m; ++i) out[i] = hull(out[i], d[i]);
      return inflated(out, sizes);
    };
    Offsets now{};
    for (std::size_t i = 0; i < m; ++i) now[i] = shift[i].bounds();
    for (now = enlarged(now); rounds < most_rounds && !too_large(now); now = enlarged(now)) {
      ++rounds;
      if (const Found f = differentiate(frame, now); f != Found::one) return f;
      const Offsets next = krawczyk(now);
      if (!interior(next, now)) {
        now = next;
        continue;
      }
      only = now;
      within = next;
      for (int k = 0; k < 2; ++k) within = both(within, krawczyk(within));
      return Found::one;
    }
    return Found::undecided;
  }
  Offsets none() const {
    Offsets out;
    out.fill(Bounds::exactly(0));
    return out;
  }
  Offsets both(const Offsets& a, const Offsets& b) const {
    Offsets out = a;
    for (std::size_t i = 0; i < m; ++i) out[i] = common(a[i], b[i]);
    return out;
  }

  bool contract(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, Offsets& within) {
    if (!start(frame, time, prescribed)) return false;
    for (int k = 0; k < most_contractions; ++k) {
      const Offsets before = within;
      if (differentiate(frame, with_zero(within)) != Found::one) return k > 0;
      find_shift(frame, prescribed);
      within = both(within, krawczyk(with_zero(within)));
      bool shrinks = false;
      for (std::size_t i = 0; i < m; ++i) {
        if (!(within[i].low <= within[i].high)) return false;
        shrinks = shrinks || within[i].width() < worth_while * before[i].width();
      }
      if (!shrinks) break;
    }
    return true;
  }

  // (5): bounds of x with J x = b, around x0. False where R is not small.
  bool solve(const MovingFrame& frame, const Numbers& b, const SmallVector& x0, Numbers& x) const {
    const Numbers z = left_of(frame, b, x0);
    double rho = 0, largest = 0;
    for (std::size_t i = 0; i < m; ++i) {
      if (!z[i].bounded()) return false;
      double row = 0;
      for (std::size_t j = 0; j < m; ++j) row += rest[i][j].magnitude() * entry(sizes, j);
      rho = std::max(rho, row / entry(sizes, i));
      largest = std::max(largest, z[i].magnitude() / entry(sizes, i));
    }
    if (!(rho < 1)) return false;
    const double all = (largest / (1.0 - Interval(rho))).high;
    Numbers y;
    for (std::size_t i = 0; i < m; ++i) {
      const double end = all * entry(sizes, i);
      y[i] = Interval(-end, end);
    }
    for (int k = 0; k < 2; ++k) {
      const Numbers next = remains_of(z, y);
      for (std::size_t i = 0; i < m; ++i) y[i] = common(y[i], next[i]);
    }
    for (std::size_t i = 0; i < m; ++i) x[i] = y[i] + entry(x0, i);
    return true;
  }

  // (4) of the box at hand. `rate` is known where this is true; whether `acceleration` is, its bounds tell.
  bool find_rates(const MovingFrame& frame, const mechanics::Bounded* actuators, Numbers& rate, Numbers& acceleration) {
    acceleration.fill(Interval::unbounded());
    if (!solve(frame, numbers(actuators, m, &mechanics::Bounded::rate), frame.velocity, rate)) return false;
    for (std::size_t i = 0; i < m; ++i) in[i] = coordinates[i], in[m + i] = rate[i], in[2 * m + i] = Interval(0.0);
    in_time.run({in.data(), 3 * m}, {out.data(), 3 * geometry.outputs()});
    Numbers left = numbers(actuators, m, &mechanics::Bounded::acceleration);
    SmallVector nearly = SmallVector::Zero(static_cast<Eigen::Index>(m));
    for (std::size_t k = 0; k < m; ++k) {
      left[k] -= out[2 * geometry.outputs() + k];
      if (!left[k].bounded()) return true;
      for (std::size_t i = 0; i < m; ++i) nearly(static_cast<Eigen::Index>(i)) += entry(frame.inverse, i, k) * left[k].middle();
    }
    if (!solve(frame, left, nearly, acceleration)) acceleration.fill(Interval::unbounded());
    return true;
  }

  bool enclose(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, const Offsets& within, bool steady,
               mechanics::Bounded* bounded) {
    if (!start(frame, time, prescribed) || differentiate(frame, within) != Found::one) return false;
    Numbers rate, acceleration;
    if (!find_rates(frame, prescribed.over, rate, acceleration)) return false;
    Numbers value = coordinates;
    if (time.low < time.high) {  // (6)
      const Interval since = elapsed;
      const bool without_kink = smooth;
      elapsed = Interval(0.0);
      Numbers rate_now, acceleration_now;
      if (differentiate(frame, with_zero(within)) == Found::one) {
        find_shift(frame, {prescribed.at_middle, prescribed.at_middle});
        const Offsets now = both(within, krawczyk(with_zero(within)));
        const bool known = find_rates(frame, prescribed.at_middle, rate_now, acceleration_now);
        for (std::size_t i = 0; i < m; ++i) {
          if (known && without_kink && steady) rate[i] = common(rate[i], rate_now[i] + acceleration[i] * since);
          value[i] = common(value[i], Interval(now[i]) + entry(frame.origin, i) + rate[i] * since);
        }
      }
    }
    for (std::size_t i = 0; i < m; ++i) bounded[i] = {value[i].bounds(), rate[i].bounds(), acceleration[i].bounds()};
    return true;
  }

  static Offsets seen_from(const MovingFrame& frame, Bounds time, const MovingBox& box) {
    const Interval between = Interval(frame.middle) - Interval(box.frame.middle), since = Interval(time) - Interval(frame.middle);
    Offsets out{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(frame.origin.size()); ++i) {
      const double old = entry(box.frame.velocity, i), now = entry(frame.velocity, i);
      const Interval moved = Interval(entry(box.frame.origin, i)) - entry(frame.origin, i) + between * old;
      out[i] = (moved + (Interval(old) - now) * since + Interval(box.offsets[i])).bounds();
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

bool Krawczyk::enclose(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, const Offsets& within, bool steady,
                       mechanics::Bounded* out) {
  return round_upward([&] { return work_->enclose(frame, time, prescribed, within, steady, out); });
}

Offsets Krawczyk::seen_from(const MovingFrame& frame, Bounds time, const MovingBox& box) {
  return round_upward([&] { return Work::seen_from(frame, time, box); });
}

}  // namespace pmreport::analysis
