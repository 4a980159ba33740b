#include <algorithm>
#include <array>
#include <cmath>
#include <core/scenario/expression/integral.hpp>

namespace pmreport::scenario {
namespace {

constexpr double agreement = 4e-15;  // of two halves with the whole, relative to the integral of |f|
constexpr int deepest = 30;          // halvings: a kink is enclosed to a billionth of the panel
constexpr int most_halvings = 256;   // of one panel in all, several kinks; what wavers faster than that is no motion

struct Sum {
  double value = 0, magnitude = 0;  // of f and of |f|
};

// Positive nodes and their weights, Abramowitz and Stegun, Table 25.4, n = 10.
Sum gauss(const std::function<double(double)>& f, double a, double b) {
  static constexpr std::array<double, 5> nodes{0.1488743389816312109, 0.4333953941292471908, 0.6794095682990244062, 0.8650633666889845107,
                                               0.9739065285171717201},
      weights{0.2955242247147528702, 0.2692667193099963551, 0.2190863625159820440, 0.1494513491505805931, 0.0666713443086881376};
  const double centre = 0.5 * (a + b), half = 0.5 * (b - a);
  Sum s;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const double x : {f(centre - half * nodes[i]), f(centre + half * nodes[i])}) {
      s.value += weights[i] * x;
      s.magnitude += weights[i] * std::abs(x);
    }
  s.value *= half;
  s.magnitude *= std::abs(half);
  return s;
}

double refined(const std::function<double(double)>& f, double a, double b, const Sum& whole, double allowed, int depth, int& halvings) {
  const double middle = 0.5 * (a + b);
  const Sum left = gauss(f, a, middle), right = gauss(f, middle, b);
  const double both = left.value + right.value, error = std::abs(both - whole.value);
  if (depth == deepest || ++halvings > most_halvings || !(error > std::max(allowed, agreement * (left.magnitude + right.magnitude))))
    return both;
  const double first = refined(f, a, middle, left, allowed, depth + 1, halvings);
  return first + refined(f, middle, b, right, allowed, depth + 1, halvings);
}

double panel(const std::function<double(double)>& f, double a, double b) {
  if (a == b) return 0;
  const Sum whole = gauss(f, a, b);
  int halvings = 0;
  return refined(f, a, b, whole, agreement * whole.magnitude, 0, halvings);
}

}  // namespace

Integral::Integral(std::function<double(double)> f, double start, std::vector<double> knots) : f_(std::move(f)), knots_(std::move(knots)) {
  values_.push_back(start);
  for (std::size_t i = 1; i < knots_.size(); ++i) values_.push_back(values_.back() + panel(f_, knots_[i - 1], knots_[i]));
}

double Integral::at(double t) const {
  const auto after = std::upper_bound(knots_.begin() + 1, knots_.end(), t);
  const auto i = static_cast<std::size_t>(after - knots_.begin()) - 1;
  return values_[i] + panel(f_, knots_[i], t);
}

}  // namespace pmreport::scenario
