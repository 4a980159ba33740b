#include <reports/section/common/words/noise.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pmreport::section {

namespace {

// A sort of quantities: linear and angular, which a length turns into each other.
struct Sort {
  std::string_view linear, angular;
  bool angular_is_longer;  // by a length, as a moment is than a force; else an angle, which is shorter by one
  int rates;               // 1: rates, 2: accelerations
};
constexpr std::array<Sort, 4> sorts{
    {{"m", "rad", false, 0}, {"m/s", "rad/s", false, 1}, {"m/s^2", "rad/s^2", false, 2}, {"N", "N*m", true, 0}}};

constexpr int looked_at = 200;  // samples, spread over the motion: a size needs no more

double largest_in(const std::vector<double>& column) {
  double out = 0;
  const std::size_t step = std::max<std::size_t>(1, column.size() / looked_at);
  for (std::size_t k = 0; k < column.size(); k += step)
    if (std::isfinite(column[k])) out = std::max(out, std::abs(column[k]));
  return out;
}

// Over all columns of the run that have this unit.
double largest_of(const Analysis& a, std::string_view unit) {
  constexpr std::array<ColumnList*, 7> lists{analysis::displacement_columns, analysis::velocity_columns, analysis::acceleration_columns,
                                             analysis::statics_columns,      analysis::dynamics_columns, analysis::drive_columns,
                                             analysis::reaction_columns};
  double out = 0;
  for (ColumnList* list : lists)
    for (const Column& c : a.columns_of(list))
      if (c.unit == unit) out = std::max(out, largest_in(a.column(c)));
  return out;
}

// The size of the terms, in the linear unit. Angles come from directions, whose size is one: so the machine's length is a term of all
// lengths, and its share per duration of all rates.
double terms_of(const Analysis& a, const Sort& sort) {
  const double length = a.length(), per_length = sort.angular_is_longer ? 1 / length : length;
  double out = std::max(largest_of(a, sort.linear), largest_of(a, sort.angular) * per_length);
  if (sort.angular_is_longer) return out;
  const double duration = a.time().empty() ? 0 : a.time().back() - a.time().front();
  if (sort.rates == 0 || duration > 0) out = std::max(out, length / std::pow(duration, sort.rates));
  return out;
}

}  // namespace

double noise_of(double largest_term) { return 64 * std::numeric_limits<double>::epsilon() * largest_term; }

double noise(const Analysis& a, std::string_view unit, const std::vector<ColumnId>& columns) {
  for (const Sort& sort : sorts) {
    if (unit == sort.linear) return noise_of(terms_of(a, sort));
    if (unit == sort.angular) return noise_of(sort.angular_is_longer ? terms_of(a, sort) * a.length() : terms_of(a, sort) / a.length());
  }
  return noise_of(a.largest(columns));
}

}  // namespace pmreport::section
