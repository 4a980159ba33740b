#include <algorithm>
#include <array>
#include <cmath>
#include <core/scenario/expression/integral.hpp>
#include <limits>

namespace pmreport::scenario {
namespace {

constexpr double agreement = 4e-15;                                      // of two halves with the whole, relative to the integral of |f|
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();  // of the time at which f is taken, relative to it
constexpr int deepest_panel = 30;                                        // halvings: a kink is enclosed to a billionth of the panel
constexpr std::size_t most_panels = 1u << 21;                            // beyond them halves need not agree, and the error says so

}  // namespace

// Positive nodes and their weights, Abramowitz and Stegun, Table 25.4, n = 10.
Integral::Sum Integral::gauss(double a, double b) const {
  static constexpr std::array<double, 5> nodes{0.1488743389816312109, 0.4333953941292471908, 0.6794095682990244062, 0.8650633666889845107,
                                               0.9739065285171717201},
      weights{0.2955242247147528702, 0.2692667193099963551, 0.2190863625159820440, 0.1494513491505805931, 0.0666713443086881376};
  const double centre = 0.5 * (a + b), half = 0.5 * (b - a);
  Sum s;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const Jet<double>& x : {f_(centre - half * nodes[i]), f_(centre + half * nodes[i])}) {
      s.value += weights[i] * x.value;
      s.magnitude += weights[i] * std::abs(x.value);
      s.slope += weights[i] * std::abs(x.rate);
    }
  s.value *= half, s.magnitude *= std::abs(half), s.slope *= std::abs(half);
  return s;
}

void Integral::add(double a, double b, const Sum& whole, double allowed, int depth) {
  const double middle = 0.5 * (a + b);
  const Sum left = gauss(a, middle), right = gauss(middle, b);
  const double both = left.value + right.value, difference = std::abs(both - whole.value);
  const double noise = rounding * std::max(std::abs(a), std::abs(b)) * (left.slope + right.slope);
  const bool agree = std::isnan(difference) || difference <= std::max(allowed, agreement * (left.magnitude + right.magnitude)) + noise;
  if (!agree && depth < deepest_panel && ends_.size() < given_ + most_panels) {
    add(a, middle, left, allowed, depth + 1);
    add(middle, b, right, allowed, depth + 1);
    return;
  }
  if (!agree) error_ += difference;
  magnitude_ += left.magnitude + right.magnitude;
  // Compensated: many panels do not add up their roundings.
  const double piece = both - carried_, sum = values_.back() + piece;
  carried_ = (sum - values_.back()) - piece;
  ends_.push_back(b);
  values_.push_back(sum);
}

Integral::Integral(std::function<Jet<double>(double)> f, double start, std::vector<double> knots) : f_(std::move(f)) {
  given_ = knots.size();
  ends_.push_back(knots.front());
  values_.push_back(start);
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const Sum whole = gauss(knots[i - 1], knots[i]);
    add(knots[i - 1], knots[i], whole, agreement * whole.magnitude, 0);
  }
}

double Integral::at(double t) const {
  const auto after = std::upper_bound(ends_.begin() + 1, ends_.end(), t);
  const auto i = static_cast<std::size_t>(after - ends_.begin()) - 1;
  return ends_[i] == t ? values_[i] : values_[i] + gauss(ends_[i], t).value;
}

}  // namespace pmreport::scenario
