#include <core/analysis/study/reduce.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

namespace {

// Linear between the two samples around a time.
template <class Value>
double interpolated(const std::vector<double>& t, double time, Value&& value) {
  const auto after = std::upper_bound(t.begin(), t.end(), time);
  const int right = std::clamp(static_cast<int>(after - t.begin()), 1, static_cast<int>(t.size()) - 1), left = right - 1;
  const double share =
      (time - t[static_cast<std::size_t>(left)]) / (t[static_cast<std::size_t>(right)] - t[static_cast<std::size_t>(left)]);
  return share <= 0 ? value(left) : share >= 1 ? value(right) : value(left) * (1 - share) + value(right) * share;
}

}  // namespace

Reduced reduce(const std::vector<double>& time, const std::vector<double>& column, const scenario::Measured& how) {
  const auto value = [&](int k) {
    const double x = column[static_cast<std::size_t>(k)];
    return how.absolute ? std::abs(x) : x;
  };
  if (how.reduction == "at") return {interpolated(time, how.time, value), -1};
  if (how.reduction == "rms") return {rms(column), -1};
  Reduced f;
  for (int k = 0; k < static_cast<int>(column.size()); ++k) {
    const double x = value(k);
    if (!std::isfinite(x)) continue;
    if (f.sample < 0 || (how.reduction == "max" ? x > f.value : x < f.value)) f = {x, k};
  }
  return f;
}

Number measure(const Analysis& a, const scenario::Measured& m, bool largest) {
  Number out;
  for (const std::string& name : m.columns) {
    const ColumnId column = ColumnId::named(name);
    if (!a.has(column)) return {};
    const Reduced f = reduce(a.time(), a.column(column), m);
    if (!std::isfinite(f.value)) return {};
    if (out.column.empty() || (largest ? f.value > out.value : f.value < out.value)) out = {f.value, f.sample, name};
  }
  return out;
}

Peak peak(const Analysis& a, const ColumnId& column) {
  Peak out;
  const std::vector<double>& x = a.column(column);
  for (int k = 0; k < a.samples(); ++k) {
    const double value = x[static_cast<std::size_t>(k)];
    if (std::isfinite(value) && (out.sample < 0 || std::abs(value) > std::abs(out.value))) out = {k, value};
  }
  return out;
}

double rms(const Analysis& a, const ColumnId& column) { return rms(a.column(column)); }

double rms(const std::vector<double>& column) {
  double squares = 0;
  int count = 0;
  for (const double x : column)
    if (std::isfinite(x)) squares += x * x, ++count;
  return count > 0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace pmreport::analysis
