#include <core/program/rounding.hpp>
#include <core/scenario/expression/integral_enclosure.hpp>
#include <core/scenario/expression/sharp_series.hpp>

namespace pmreport::scenario {
namespace {

using program::Bounds;

constexpr int order = 14;                         // even
constexpr double nothing = 1e-15;                 // of the integral of |f|: what a panel may leave open
constexpr int deepest = 52;                       // halvings beside a jump, until it is enclosed to the rounding of the time
constexpr std::size_t most_panels = 1u << 18;     // beyond those given; then panels leave open what they do
constexpr std::size_t most_evaluated = 1u << 23;  // terms, likewise: seconds

// Integral of (t - m)^k from a to b.
Interval moment(int k, const Interval& from, const Interval& to) {
  return (pow(to, k + 1) - pow(from, k + 1)) / static_cast<double>(k + 1);
}

// The integral of an expression f over one panel, without dividing it.
class Panel {
 public:
  Panel(std::span<const Term> terms, double a, double b) : terms_(terms), span_(a, b) {
    const Interval middle(span_.middle()), from = a - middle, to = b - middle;
    const Series<2> rough = sharp_series(terms_, span_);
    value_ = rough[0];
    integral_ = rough[0] * (Interval(b) - a);
    left_open_ = integral_.width();
    if (rough.smooth > order)
      by_series(middle, from, to);
    else if (rough.smooth >= 0)
      by_slope(rough, middle, from, to);
  }

  const Interval& value() const { return value_; }  // f
  const Interval& integral() const { return integral_; }
  double left_open() const { return left_open_; }  // of the integral, where it is more than rounding

 private:
  // f(m) + f'(T) (t - m), of which each half has an f' of its own.
  void by_slope(const Series<2>& f, const Interval& middle, const Interval& from, const Interval& to) {
    const Interval centre = sharp_series(terms_, middle)[0];
    integral_ = common(integral_, centre * (to - from) + 0.5 * (f[1] * square(to)) - 0.5 * (f[1] * square(from)));
    left_open_ = integral_.width();
  }

  // Taylor's formula about m with the remainder f_K(T) (t - m)^K: K is even, and (t - m)^K has one sign, so that the integral of the
  // remainder lies in f_K(T) times that of (t - m)^K.
  void by_series(const Interval& middle, const Interval& from, const Interval& to) {
    thread_local std::vector<Series<order>> work;
    evaluate_terms(terms_, Series<order>::time(span_), {}, work);
    const Interval remainder = work.back()[order] * moment(order, from, to);
    evaluate_terms(terms_, Series<order>::time(middle), {}, work);
    Interval sum(0.0);
    for (int k = 0; k < std::min(order, work.back().degree + 1); ++k) sum = sum + work.back()[k] * moment(k, from, to);
    integral_ = common(integral_, sum + remainder);
    left_open_ = remainder.bounded() && remainder.width() <= sum.width() ? 0 : integral_.width();
  }

  std::span<const Term> terms_;
  Interval span_, value_, integral_;
  double left_open_ = 0;
};

// F from a, or b, on, over the panel between them: one that rises or falls is between its ends.
Interval between(const Interval& at_a, const Interval& at_b, const Interval& rate, const Interval& length) {
  const Interval step = rate * Interval(0.0, length.high);
  return common(at_a + step, at_b - step);
}

class Divided {
 public:
  Divided(std::span<const Term> terms, double allowed, Interval start) : terms_(terms), allowed_(allowed), sum_(start) {}

  void add(double a, double b, int depth = 0) {
    const Panel panel(terms_, a, b);
    const double middle = Interval(a, b).middle();
    const bool good = panel.left_open() <= allowed_, last = depth == deepest || !(a < middle && middle < b);
    evaluated_ += terms_.size();
    if (!good && !last && extra_ < most_panels && evaluated_ < most_evaluated) {
      ++extra_;
      add(a, middle, depth + 1);
      add(middle, b, depth + 1);
      return;
    }
    const Interval before = sum_;
    sum_ = sum_ + panel.integral();
    ranges.push_back(between(before, sum_, panel.value(), Interval(b) - a).bounds());
    ends.push_back(b);
    values.push_back(sum_.bounds());
  }

  std::vector<double> ends;
  std::vector<Bounds> values, ranges;

 private:
  std::span<const Term> terms_;
  double allowed_;
  Interval sum_;
  std::size_t extra_ = 0, evaluated_ = 0;
};

// F within one panel that begins at a, where it is `value`.
Interval within(std::span<const Term> terms, double a, const Bounds& value, const Bounds& time) {
  const Interval span(time), middle(span.middle()), away = span - middle;
  const auto at = [&](double t) { return t > a ? Interval(value) + Panel(terms, a, t).integral() : Interval(value); };
  const Series<2> f = sharp_series(terms, span);
  const Interval centre = at(span.middle());
  const Interval first = centre + f[0] * away;
  if (f.smooth < 0) return first;
  return common(first, centre + sharp_series(terms, middle)[0] * away + 0.5 * (f[1] * square(away)));
}

}  // namespace

IntegralEnclosure::Panels IntegralEnclosure::panels() const {
  Divided divided(f_.terms(), std::isfinite(magnitude_) ? nothing * magnitude_ : magnitude_, start_);
  divided.ends = {times_.front()};
  divided.values = {Bounds::exactly(start_)};
  for (std::size_t i = 1; i < times_.size(); ++i) divided.add(times_[i - 1], times_[i]);
  return {std::move(divided.ends), std::move(divided.values), Hulls(divided.ranges)};
}

Bounds IntegralEnclosure::values(const Panels& panels, Bounds time) const {
  const std::vector<double>& ends = panels.ends;
  if (!(time.low >= ends.front() && time.high <= ends.back())) return {};
  const auto panel = [&](double t) {
    return static_cast<std::size_t>(std::upper_bound(ends.begin() + 1, ends.end() - 1, t) - ends.begin()) - 1;
  };
  const std::size_t first = panel(time.low), last = panel(time.high);
  const auto part = [&](std::size_t i, double from, double to) {
    return within(f_.terms(), ends[i], panels.values[i], {from, to}).bounds();
  };
  if (first == last) return part(first, time.low, time.high);
  const Bounds outer = hull(part(first, time.low, ends[first + 1]), part(last, ends[last], time.high));
  return last == first + 1 ? outer : hull(outer, panels.ranges.of(first + 1, last - 1));
}

Jet<Bounds> IntegralEnclosure::over(Bounds time) const {
  return program::round_upward([&]() -> Jet<Bounds> {
    std::call_once(once_, [&] { panels_ = panels(); });
    const Series<2> f = sharp_series(f_.terms(), Interval(time));
    if (!f[0].bounded()) return {};
    return {values(panels_, time), f[0].bounds(), f[1].bounds()};
  });
}

}  // namespace pmreport::scenario
