#include <algorithm>
#include <cmath>
#include <core/scenario/expression/behaviour.hpp>
#include <core/scenario/expression/range.hpp>
#include <functional>
#include <limits>
#include <numbers>

namespace pmreport::scenario {
namespace {

constexpr int fewest_steps = 64;
constexpr std::size_t most_steps = 1u << 21;  // more periods than a million samples could show
constexpr std::size_t most_work = 1u << 27;   // terms evaluated: a second or two
constexpr int deepest_step = 30;              // halvings of one of the first steps
constexpr int most_restless = 64;             // steps that are not short enough even so: beside a pole one or two are not
constexpr int deepest_search = 6;             // halvings of a step in search of switches
constexpr int most_turning = 1 << 14;         // cells beyond these halvings in which what tells a switch may turn back

using J = Jet<double>;
using program::Bounds;

// Whether a function does, over the range of its argument, little enough for a handful of points to show it. Polynomials do little over any
// short time; what they make of it is judged by the functions that take it.
bool calm(const Term& term, std::span<const Range> ranges) {
  const auto of = [&](int i) { return ranges[static_cast<std::size_t>(i)].value; };
  switch (term.operation) {
    case Operation::sin:
    case Operation::cos:
    case Operation::tan:
      return of(term.a).width() <= 1;
    case Operation::exp:
      return of(term.a).width() <= 2 || of(term.a).high < -40;  // beside one, what is below e^-40 is nothing
    case Operation::sinh:
    case Operation::cosh:
      return of(term.a).width() <= 2;
    case Operation::tanh:
    case Operation::atan:
      return of(term.a).width() <= 1 || of(term.a).low > 20 || of(term.a).high < -20;
    case Operation::step5: {
      const Bounds x = of(term.a), from = of(term.b), to = of(term.c);
      const bool inside = x.high > std::min(from.low, to.low) && x.low < std::max(from.high, to.high);
      return !inside || x.width() <= std::abs(to.low - from.low) / 2;
    }
    default:
      return true;
  }
}

// A function of the terms that tells a switch: it changes its sign there, or, where `singular`, touches zero.
struct Telltale {
  std::function<J(std::span<const J>)> value;
  std::function<Range(std::span<const Range>)> range;  // rounded, but its signs are right
  std::size_t term;                                    // the last that it needs
  bool singular;
  double constant = 0;  // that it is told from: its rounding is relative to that
};

Bounds difference(const Bounds& a, const Bounds& b) { return {a.low - b.high, a.high - b.low}; }

Telltale difference(int a, int b, bool singular) {
  const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
  return {[=](std::span<const J> x) { return x[first] - x[second]; },
          [=](std::span<const Range> r) {
            return Range{difference(r[first].value, r[second].value), difference(r[first].rate, r[second].rate)};
          },
          std::max(first, second), singular};
}
Telltale less(int a, double constant, bool singular) {
  const auto of = static_cast<std::size_t>(a);
  return {[=](std::span<const J> x) { return x[of] - constant; },
          [=](std::span<const Range> r) {
            return Range{difference(r[of].value, Bounds::exactly(constant)), r[of].rate};
          },
          of, singular, std::abs(constant)};
}
// Of atan2(y, x) that stays on the ray y = 0: where x changes its sign.
Telltale along_ray(int y, int x) {
  const auto height = static_cast<std::size_t>(y), along = static_cast<std::size_t>(x);
  return {[=](std::span<const J> v) { return v[height].value == 0 ? v[along] : J(1.0); },
          [=](std::span<const Range> r) {
            return r[height].value.has(0) ? r[along] : Range{Bounds::exactly(1), Bounds::exactly(0)};
          },
          std::max(height, along), false};
}

std::vector<Telltale> telltales(std::span<const Term> terms) {
  std::vector<Telltale> out;
  for (const Term& term : terms) switch (term.operation) {
      case Operation::atan2:  // beyond a half-turn
        out.push_back(along_ray(term.a, term.b));
        [[fallthrough]];
      case Operation::abs:
        out.push_back(less(term.a, 0, false));
        break;
      case Operation::min:
      case Operation::max:
        out.push_back(difference(term.a, term.b, false));
        break;
      case Operation::step5:
        out.push_back(difference(term.a, term.b, false));
        out.push_back(difference(term.a, term.c, false));
        break;
      case Operation::divide:
        if (terms[static_cast<std::size_t>(term.b)].operation != Operation::constant) out.push_back(less(term.b, 0, true));
        break;
      case Operation::power:
        if (term.constant < 0 || term.constant != std::round(term.constant)) out.push_back(less(term.a, 0, true));
        break;
      case Operation::sqrt:
      case Operation::log:
        out.push_back(less(term.a, 0, true));
        break;
      case Operation::asin:
      case Operation::acos:
        out.push_back(less(term.a, 1, true));
        out.push_back(less(term.a, -1, true));
        break;
      case Operation::tan: {
        const auto of = static_cast<std::size_t>(term.a);
        out.push_back({[of](std::span<const J> x) { return cos(x[of]); },
                       [of](std::span<const Range> r) {
                         const auto half_turns = [](double x) { return std::floor(x / std::numbers::pi - 0.5); };
                         const bool one = half_turns(r[of].value.low) == half_turns(r[of].value.high);
                         return Range{one ? Bounds::exactly(1) : Bounds{-1, 1}, {}};
                       },
                       of, true});
        break;
      }
      default:
        break;
    }
  return out;
}

class Observer {
 public:
  explicit Observer(const Expression& e) : expression_(e), terms_(e.terms()) {}

  // False when there are too many.
  bool find_steps(double begin, double end, std::vector<double>& steps) {
    steps = {begin};
    for (int i = 0; i < fewest_steps; ++i) {
      const double from = steps.back(), to = i + 1 == fewest_steps ? end : begin + (end - begin) * (i + 1) / fewest_steps;
      if (!divide(from, to, 0, steps)) return false;
    }
    return true;
  }

  bool exhausted() const { return work_ > most_work; }

  // The switches that one telltale tells. `times` rise; the range of the telltale says where to look more closely.
  void find(const Telltale& tale, const std::vector<double>& times, std::vector<Switch>& out) {
    closer_ = {times.front()};
    turning_ = 0;
    for (std::size_t i = 1; i < times.size(); ++i) look(tale, times[i - 1], times[i], 0);
    double old_time = closer_.front();
    J old = at(tale, old_time);
    int sign = sign_of(old.value);
    for (std::size_t i = 1; i < closer_.size() && !exhausted(); ++i) {
      const double time = closer_[i];
      const J now = at(tale, time);
      const int here = sign_of(now.value);
      if (sign * here < 0) {
        const Switch found = bisect(tale, old_time, time, sign);
        // Else it stays zero: another switch began that, or is this one. Beside a pole the times are near already, but not as near as that.
        const double cell = time - old_time, nearest = 8 * std::numeric_limits<double>::epsilon() * std::abs(time);
        if (found.after - found.before <= std::max(1e-9 * cell, std::min(nearest, cell / 16))) out.push_back(found);
      } else if (tale.singular && sign * here > 0 && now.rate * sign > 0 && old.rate * sign < 0) {
        touch(tale, old_time, time, sign, std::max(std::abs(old.value), std::abs(now.value)), out);
      } else if (tale.singular && here == 0 && i + 1 < closer_.size() && sign * sign_of(at(tale, closer_[i + 1]).value) > 0) {
        out.push_back(beside(tale, time, time - old_time));
      }
      if (here == 0) continue;
      old_time = time, old = now, sign = here;
    }
  }

 private:
  static int sign_of(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

  void values(std::size_t terms, double from, double to) {
    work_ += terms;
    values_of(terms_.first(terms), from, to, ranges_);
  }
  J at(const Telltale& tale, double t) {
    work_ += terms_.size();
    expression_.evaluate(t, {}, values_);
    return tale.value(values_);
  }

  bool divide(double from, double to, int depth, std::vector<double>& steps) {
    if (steps.size() > most_steps || exhausted()) return false;
    values(terms_.size(), from, to);
    const double middle = 0.5 * (from + to);
    const bool short_enough = std::all_of(terms_.begin(), terms_.end(), [&](const Term& t) { return calm(t, ranges_); });
    const bool done = short_enough || depth == deepest_step || !(from < middle && middle < to);
    if (!short_enough && done && ++restless_ > most_restless) return false;
    if (!done) return divide(from, middle, depth + 1, steps) && divide(middle, to, depth + 1, steps);
    steps.push_back(to);
    return true;
  }

  void look(const Telltale& tale, double from, double to, int depth) {
    const double middle = 0.5 * (from + to);
    if (depth < deepest_step && !exhausted() && from < middle && middle < to) {
      values(tale.term + 1, from, to);
      if (tale.range(ranges_).value.has(0) && (depth < deepest_search || may_turn(tale, from, to))) {
        look(tale, from, middle, depth + 1);
        look(tale, middle, to, depth + 1);
        return;
      }
    }
    closer_.push_back(to);
  }

  // Whether it may come back to the sign that it had, so that its ends tell nothing. A function that is singular is blown up by rounding
  // nearer to its zeros, and one that stays zero turns everywhere: most_turning.
  bool may_turn(const Telltale& tale, double from, double to) {
    if (tale.singular || turning_ >= most_turning) return false;
    work_ += tale.term + 1;
    ranges_of(terms_.first(tale.term + 1), from, to, ranges_);
    if (!tale.range(ranges_).rate.has(0)) return false;
    ++turning_;
    return true;
  }

  // The last time with the old sign and the first with the new one; zero is neither.
  Switch bisect(const Telltale& tale, double from, double to, int sign) {
    const auto border = [&](bool strictly_new) {
      double low = from, high = to;
      for (;;) {
        const double middle = 0.5 * (low + high);
        if (!(low < middle && middle < high)) return Switch{low, high};
        const int here = sign * sign_of(at(tale, middle).value);
        ((strictly_new ? here < 0 : here <= 0) ? high : low) = middle;
      }
    };
    return {border(false).before, border(true).after};
  }

  // Where it comes nearest to zero, if that is zero but for rounding.
  void touch(const Telltale& tale, double from, double to, int sign, double size, std::vector<Switch>& out) {
    double low = from, high = to;
    for (;;) {
      const double middle = 0.5 * (low + high);
      if (!(low < middle && middle < high)) break;
      (at(tale, middle).rate * sign < 0 ? low : high) = middle;
    }
    if (!(std::abs(at(tale, low).value) <= 1e-12 * size)) return;
    out.push_back(beside(tale, low, to - from));
  }

  // Both sides of a place where it touches zero, `width` wide at most: so far away that it is more than the rounding of its constant, which
  // a function that is singular at zero would blow up.
  Switch beside(const Telltale& tale, double t, double width) {
    constexpr double nearest = 1e-9, farthest = 1e-2, clear = 1e-11;  // of the width; of the constant
    for (double share = nearest;; share *= 10) {
      const Switch out{t - share * width, t + share * width};
      const double left = std::abs(at(tale, out.before).value), right = std::abs(at(tale, out.after).value);
      if (share > farthest || std::min(left, right) > clear * tale.constant) return out;
    }
  }

  const Expression& expression_;
  std::span<const Term> terms_;
  std::vector<Range> ranges_;
  std::vector<J> values_;
  std::vector<double> closer_;
  int restless_ = 0, turning_ = 0;
  std::size_t work_ = 0;
};

}  // namespace

Behaviour behaviour(const Expression& expression, double begin, double end) {
  Behaviour out;
  Observer observer(expression);
  out.complete = observer.find_steps(begin, end, out.steps);
  if (!out.complete) return out;
  // In the order of the terms: where one switches, those that stand on it are looked at too.
  std::vector<double> times = out.steps;
  for (const Telltale& tale : telltales(expression.terms())) {
    std::vector<Switch> found;
    observer.find(tale, times, found);
    if (observer.exhausted()) out.complete = false;
    if (!out.complete) return out;
    for (const Switch& s : found) {
      if (!(s.before > begin && s.after < end)) continue;
      out.switches.push_back(s);
      times.insert(times.end(), {s.before, s.after});
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
  }
  std::sort(out.switches.begin(), out.switches.end(), [](const Switch& x, const Switch& y) { return x.before < y.before; });
  return out;
}

}  // namespace pmreport::scenario
