#include <core/program/intervals/rounding.hpp>
#include <core/scenario/expression/hulls.hpp>
#include <core/scenario/expression/integral_enclosure.hpp>
#include <core/scenario/expression/sharp_series.hpp>

namespace pmreport::scenario {
namespace {

using program::Bounds;

constexpr int order = 14;                         // even
constexpr double nothing = 1e-15;                 // of the integral of |f|: what a panel may leave open
constexpr int deepest = 52;                       // halvings beside a jump, until it is enclosed to the rounding of the time
constexpr std::size_t most_panels = 1u << 17;     // beyond those given; then panels leave open what they do
constexpr std::size_t most_evaluated = 1u << 21;  // terms, likewise: seconds
constexpr std::size_t most_kept = 1u << 15;       // panels whose series are kept
constexpr double beside = 0x1p-26;                // of a panel: what is cut off at its ends, where switches stand
constexpr int turns = 8;                          // halvings of a panel in which F may turn: a part in 4^8 of its range is left open

// An expression f over one panel, without dividing it.
//
// Where it is smooth, f(t) = sum of c_k (t - m)^k, k < K, + r (t - m)^K about the middle m, with r in f_K of the panel (Taylor). K is even
// and (t - m)^K has one sign, so that its integral from a to t, too, has an r in f_K: all is a polynomial with an interval for its last
// coefficient. Elsewhere f(t) is in f(m) + f'(T) (t - m), over the part that is asked for, or, where it jumps, in f(T).
class Panel {
 public:
  Panel(std::span<const Term> terms, double a, double b) : terms_(terms), a_(a) {
    const Interval span(a, b), middle(span.middle());
    thread_local std::vector<Series<order>> work;
    evaluate_terms(terms, Series<order>::time(span), {}, work);
    value_ = work.back()[0];
    smooth_ = work.back().smooth > order && work.back()[order].bounded();
    if (!smooth_) return;
    middle_ = span.middle();
    c_[order] = work.back()[order] / (order + 1.0);
    evaluate_terms(terms, Series<order>::time(middle), {}, work);
    for (int k = 0; k < order; ++k) c_[static_cast<std::size_t>(k)] = work.back()[k] / (k + 1.0);
    before_ = polynomial(a, order);
  }

  bool smooth() const { return smooth_; }
  const Interval& value() const { return value_; }  // f

  // From a to t.
  Interval integral(double t) const {
    if (t == a_) return Interval(0.0);
    return smooth_ ? polynomial(t, order) - before_ : rough(t);
  }
  // Of the whole integral, where it is more than rounding.
  double left_open(double b) const {
    const Interval whole = integral(b);
    if (!smooth_) return whole.width();
    const Interval remainder = c_[order] * (pow(Interval(b) - middle_, order + 1) - pow(Interval(a_) - middle_, order + 1));
    return remainder.width() <= 0.5 * whole.width() ? 0 : whole.width();
  }

 private:
  Interval polynomial(double t, std::size_t k) const {
    const Interval x = Interval(t) - middle_;
    Interval sum = c_[k];
    while (k-- > 0) sum = c_[k] + x * sum;
    return x * sum;
  }
  Interval rough(double t) const {
    const Interval span(a_, t), middle(span.middle()), from = a_ - middle, to = t - middle;
    const Series<2> f = sharp_series(terms_, span);
    const Interval all = f[0] * (to - from);
    if (f.smooth < 0) return all;
    const Interval centre = sharp_series(terms_, middle)[0];
    return common(all, centre * (to - from) + 0.5 * (f[1] * square(to)) - 0.5 * (f[1] * square(from)));
  }

  std::span<const Term> terms_;
  double a_, middle_ = 0;
  bool smooth_ = false;
  Interval value_, before_;
  std::array<Interval, order + 1> c_;
};

// F from a, or b, on, over the panel between them: one that rises or falls is between its ends.
Interval between(const Interval& at_a, const Interval& at_b, const Interval& rate, const Interval& length) {
  const Interval step = rate * Interval(0.0, length.high);
  return common(at_a + step, at_b - step);
}

class Divided {
 public:
  Divided(std::span<const Term> terms, double allowed, Interval start) : terms_(terms), allowed_(allowed), sum_(start) {}

  // Switches are ends of what is given: most panels that are not smooth are so beside their ends alone.
  void add(double a, double b, int depth = 0) {
    const Panel panel(terms_, a, b);
    const double middle = Interval(a, b).middle(), edge = beside * (b - a);
    const bool good = panel.left_open(b) <= allowed_, last = depth == deepest || !(a < middle && middle < b);
    evaluated_ += terms_.size();
    if (!good && !last && extra_ < most_panels && evaluated_ < most_evaluated) {
      ++extra_;
      if (depth == 0 && !panel.smooth() && a < a + edge && a + edge < b - edge && b - edge < b) {
        add(a, a + edge, 1);
        add(a + edge, b - edge, 1);
        add(b - edge, b, 1);
        return;
      }
      add(a, middle, depth + 1);
      add(middle, b, depth + 1);
      return;
    }
    const Interval before = sum_;
    sum_ = sum_ + panel.integral(b);
    ranges.push_back(range(panel, before, a, before, b, sum_, good ? turns : 0).bounds());
    if (kept.size() == ends.size() - 1 && kept.size() < most_kept) kept.push_back(panel);
    ends.push_back(b);
    values.push_back(sum_.bounds());
  }

  std::vector<double> ends;
  std::vector<Bounds> values, ranges;
  std::vector<Panel> kept;

 private:
  // Of F from t to u, where it is `at_t` and `at_u`; it is `start` where the panel begins.
  Interval range(const Panel& panel, const Interval& start, double t, const Interval& at_t, double u, const Interval& at_u,
                 int halvings) const {
    const Interval rate = sharp_series(terms_, Interval(t, u))[0], length = Interval(u) - t;
    const double middle = Interval(t, u).middle();
    const bool turns_back = rate.bounded() && rate.low() < 0 && rate.high > 0 && (rate * length).width() > 16 * allowed_;
    if (!turns_back || halvings == 0 || !(t < middle && middle < u)) return between(at_t, at_u, rate, length);
    const Interval at_middle = start + panel.integral(middle);
    return hull(range(panel, start, t, at_t, middle, at_middle, halvings - 1),
                range(panel, start, middle, at_middle, u, at_u, halvings - 1));
  }

  std::span<const Term> terms_;
  double allowed_;
  Interval sum_;
  std::size_t extra_ = 0, evaluated_ = 0;
};

// F within one panel, where it begins with `start`.
Interval within(std::span<const Term> terms, const Panel& panel, const Interval& start, const Interval& span, const Series<2>& f) {
  const Interval middle(span.middle()), away = span - middle, centre = start + panel.integral(span.middle());
  const Interval first = centre + f[0] * away;
  if (f.smooth < 0 || !(span.width() > 0)) return first;
  return common(first, centre + sharp_series(terms, middle)[0] * away + 0.5 * (f[1] * square(away)));
}

}  // namespace

struct IntegralEnclosure::Panels {
  std::vector<double> ends;    // one more than there are panels
  std::vector<Bounds> values;  // of F at the ends
  std::vector<Panel> kept;     // the first of them
  Hulls ranges;                // of F in each panel

  // The panel that has t.
  std::size_t of(double t) const {
    return static_cast<std::size_t>(std::upper_bound(ends.begin() + 1, ends.end() - 1, t) - ends.begin()) - 1;
  }
  Interval within(std::span<const Term> terms, std::size_t i, double from, double to, const Series<2>* f) const {
    const Interval span(from, to);
    const Series<2> own = f != nullptr ? *f : sharp_series(terms, span);
    return scenario::within(terms, i < kept.size() ? kept[i] : Panel(terms, ends[i], ends[i + 1]), Interval(values[i]), span, own);
  }
  // `f`: over that time.
  Bounds over(std::span<const Term> terms, Bounds time, const Series<2>& f) const {
    if (!(time.low >= ends.front() && time.high <= ends.back())) return {};
    const std::size_t first = of(time.low), last = of(time.high);
    if (first == last) return within(terms, first, time.low, time.high, &f).bounds();
    const Interval outer =
        hull(within(terms, first, time.low, ends[first + 1], nullptr), within(terms, last, ends[last], time.high, nullptr));
    return last == first + 1 ? outer.bounds() : hull(outer, Interval(ranges.of(first + 1, last - 1))).bounds();
  }
};

std::shared_ptr<const IntegralEnclosure::Panels> IntegralEnclosure::panels() const {
  Divided divided(f_.terms(), std::isfinite(magnitude_) ? nothing * magnitude_ : std::numeric_limits<double>::infinity(), start_);
  divided.ends = {times_.front()};
  divided.values = {Bounds::exactly(start_)};
  for (std::size_t i = 1; i < times_.size(); ++i) divided.add(times_[i - 1], times_[i]);
  return std::make_shared<const Panels>(
      Panels{std::move(divided.ends), std::move(divided.values), std::move(divided.kept), Hulls(divided.ranges)});
}

Jet<Bounds> IntegralEnclosure::over(Bounds time) const {
  return program::round_upward([&]() -> Jet<Bounds> {
    std::call_once(once_, [&] { panels_ = panels(); });
    const Series<2> f = sharp_series(f_.terms(), Interval(time));
    if (!f[0].bounded()) return {};
    return {panels_->over(f_.terms(), time, f), f[0].bounds(), f.smooth < 0 ? Bounds{} : f[1].bounds()};
  });
}

}  // namespace pmreport::scenario
