#include <core/analysis/study/reduce.hpp>

#include <core/analysis/study/instant.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pmreport::analysis {

Reduced reduce(const std::vector<double>& column, const scenario::Measured& how) {
  if (how.reduction == "rms") return {rms(column), -1};
  Reduced f;
  for (int k = 0; k < static_cast<int>(column.size()); ++k) {
    const double stands = column[static_cast<std::size_t>(k)], x = how.absolute ? std::abs(stands) : stands;
    if (!std::isfinite(x)) continue;
    if (f.sample < 0 || (how.reduction == "max" ? x > f.value : x < f.value)) f = {x, k};
  }
  return f;
}

Number measure(const Analysis& a, const scenario::Measured& m, bool largest) {
  Number out;
  const auto sample = std::find(a.time().begin(), a.time().end(), m.time);
  std::optional<Instant> instant;
  if (m.reduction == "at" && sample == a.time().end()) instant.emplace(a, m.time);
  const auto at = [&](const ColumnId& column) {
    const double x = instant ? instant->value(column) : a.column(column)[static_cast<std::size_t>(sample - a.time().begin())];
    return Reduced{m.absolute ? std::abs(x) : x, -1};
  };
  for (const std::string& name : m.columns) {
    const ColumnId column = ColumnId::named(name);
    if (!a.has(column)) return {};
    const Reduced f = m.reduction == "at" ? at(column) : reduce(a.column(column), m);
    if (!std::isfinite(f.value)) return {};
    if (out.column.empty() || (largest ? f.value > out.value : f.value < out.value)) out = {f.value, f.sample, name};
  }
  return out;
}

namespace {

// Of |x|, x between its least and its largest value m and M: the largest is max(-m, M). The least is m where x is positive throughout, -M
// where it is negative; else it is no more than |m| or |M|, and 0 unless x jumps.
program::Bounds of_magnitude(const Extreme& e, bool largest) {
  const program::Bounds &m = e.least, &M = e.largest;
  if (largest) return {std::max(-m.high, M.low), std::max(-m.low, M.high)};
  if (m.low >= 0) return m;
  if (M.high <= 0) return {-M.high, -M.low};
  return {0, std::min(std::max(std::abs(m.low), std::abs(m.high)), std::max(std::abs(M.low), std::abs(M.high)))};
}

}  // namespace

std::optional<program::Bounds> measure_proved(const MotionProof& proof, const scenario::Measured& m, bool largest) {
  const bool greatest = m.reduction == "max";
  if (!proof.unexamined.empty() || !m.quantity.empty() || m.columns.empty() || (!greatest && m.reduction != "min")) return {};
  std::optional<program::Bounds> out;
  for (const std::string& name : m.columns) {
    const Extreme* e = proof.extreme(ColumnId::named(name));
    if (e == nullptr || !e->least.bounded() || !e->largest.bounded()) return {};
    const program::Bounds b = m.absolute ? of_magnitude(*e, greatest) : greatest ? e->largest : e->least;
    if (!out)
      out = b;
    else if (largest)
      out = program::Bounds{std::max(out->low, b.low), std::max(out->high, b.high)};
    else
      out = program::Bounds{std::min(out->low, b.low), std::min(out->high, b.high)};
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
