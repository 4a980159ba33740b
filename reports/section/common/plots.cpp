#include <core/text/digits.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/noise.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::section {

namespace {

// Without the rounding of what vanishes.
double shown(double x, double noise) { return std::abs(x) < noise ? 0 : x; }

// Significant digits of the smallest and the largest value of a column, and of the difference between them.
constexpr int digits_of_value = 5, digits_of_span = 3;

}  // namespace

std::vector<ColumnId> columns_of(const std::vector<Trace>& curves) {
  std::vector<ColumnId> out;
  for (const Trace& c : curves) out.push_back(c.column);
  return out;
}

DisplayUnit unit_of(const Analysis& a, const std::string& unit, const std::vector<Trace>& curves) {
  const std::vector<ColumnId> columns = columns_of(curves);
  return display_unit(unit, shown(a.largest(columns), noise(a, unit, columns)));
}

figure::Panel panel(const Analysis& a, const std::string& title, const std::string& axis, const std::string& unit,
                    const std::vector<Trace>& curves) {
  const DisplayUnit d = unit_of(a, unit, curves);
  const double nothing = noise(a, unit, columns_of(curves));
  figure::Panel p;
  p.title = title;
  p.x = {"time", "s"};
  p.y = {axis, d.label};
  for (const Trace& c : curves) {
    figure::Series s{c.label, a.time(), a.column(c.column), -1};
    for (double& y : s.y) y = shown(y, nothing) * d.per_si;
    p.series.push_back(std::move(s));
  }
  // A sample stands for the time halfway to its neighbours.
  const std::vector<double>& t = a.time();
  const auto band = [&](const SampleRun& i, figure::Band::Kind kind) {
    const auto first = static_cast<std::size_t>(i.first), last = static_cast<std::size_t>(i.last);
    const double from = first > 0 ? (t[first - 1] + t[first]) / 2 : t[first];
    const double to = last + 1 < t.size() ? (t[last] + t[last + 1]) / 2 : t[last];
    p.bands.push_back({from, to, kind});
  };
  for (const SampleRun& i : a.broken()) band(i, figure::Band::Kind::limit);
  for (const SampleRun& i : a.unreachable()) band(i, figure::Band::Kind::unreachable);
  return p;
}

std::vector<Trace> group(const Analysis& a, ColumnList* list, const std::string& name, const std::string& unit) {
  std::vector<Trace> out;
  const bool vector = name == "velocity" || name == "angular_velocity" || name == "acceleration" || name == "angular_acceleration";
  for (const Column& c : a.columns_of(list)) {
    if (c.group != name || (!unit.empty() && c.unit != (unit == "1" ? "" : unit))) continue;
    // A vector's components are labelled by their axes.
    out.push_back({c, symbol(vector ? c.name.substr(c.name.size() - 1) : analysis::owner_of(c))});
  }
  // x, y, z and alpha, beta, gamma in this order, whichever of them is the dependent one.
  if (name.starts_with("coordinate")) std::sort(out.begin(), out.end(), [](const Trace& x, const Trace& y) { return x.column < y.column; });
  // The force of l₃, or of ρ₃, is F₃: a Greek letter takes two bytes, the first of them 0xCE or 0xCF.
  if (name == "actuator_force" || name == "dynamic_force")
    for (Trace& c : out) {
      std::size_t at = std::min(c.label.size(), c.label.find_first_not_of("abcdefghijklmnopqrstuvwxyz"));
      if (at + 1 < c.label.size() && (c.label[at] == '\xCE' || c.label[at] == '\xCF')) at += 2;
      c.label = "F" + c.label.substr(at);
    }
  if (name == "constraint" && out.size() == 1) out.front().label = "Fτ";
  return out;
}

document::Table extremes(const Analysis& a, const std::string& caption, const std::vector<Column>& columns) {
  document::Table table{
      caption, {"quantity", "meaning", "smallest", "at", "largest", "at", "unit"}, {false, false, true, true, true, true, false}, {}};
  for (const Column& c : columns) {
    const std::vector<double>& x = a.column(c);
    int low = -1, high = -1;
    for (int k = 0; k < a.samples(); ++k) {
      const double v = x[static_cast<std::size_t>(k)];
      if (!std::isfinite(v)) continue;
      if (low < 0 || v < x[static_cast<std::size_t>(low)]) low = k;
      if (high < 0 || v > x[static_cast<std::size_t>(high)]) high = k;
    }
    if (low < 0) {
      table.rows.push_back({c.name, c.title, "–", "–", "–", "–", c.unit});
      continue;
    }
    const double nothing = noise(a, c.unit, {c});
    const double smallest = shown(x[static_cast<std::size_t>(low)], nothing), largest = shown(x[static_cast<std::size_t>(high)], nothing);
    const DisplayUnit d = display_unit(c.unit, std::max(std::abs(smallest), std::abs(largest)));
    const std::vector<std::string> both =
        format_together({smallest * d.per_si, largest * d.per_si}, digits_of_value, digits_of_span, nothing * d.per_si);
    table.rows.push_back({c.name, c.title, typeset(both[0]), show_time(a, low), typeset(both[1]), show_time(a, high), d.label});
  }
  return table;
}

namespace {

// A number that could not be computed at some sample counts as the worst: what could be is no proof then.
std::string why_no_value(const Analysis& a, const Worst& w) {
  if (w.compared == 0) return why_nothing(a);
  return "it could not be computed" + (w.sample >= 0 ? " at t = " + show_time(a, w.sample) : std::string());
}

}  // namespace

document::Proof proof(const Analysis& a, const std::vector<Claim>& claims) {
  document::Proof p;
  for (const Claim& c : claims) {
    const Worst w = a.worst(c.measure, c.tolerance);
    std::string how = c.how;
    if (w.compared < a.samples()) how += fmt::format(" ({} of {} samples)", w.compared, a.samples());
    if (w.compared == 0) {
      p.lines.push_back(document::Evidence::not_examined(c.claim, c.how,
                                                         w.undecided > 0 ? "too near the end of reach to compare any digit"
                                                         : a.count(Outcome::good) > 0 && !c.unless.empty() ? c.unless
                                                                                                           : why_no_value(a, w)));
      continue;
    }
    if (!std::isfinite(w.value)) {
      p.lines.push_back({c.claim, how, std::numeric_limits<double>::quiet_NaN(), c.tolerance, c.unit, why_no_value(a, w)});
      continue;
    }
    if (w.poorly_known > 0)
      how += fmt::format("; at {} rounding leaves either side known to {} or better only, and that is what it is judged by",
                         plural(w.poorly_known, "sample"), format_number(w.poorest, 2));
    if (w.undecided > 0) how += fmt::format("; at {} no digit is left to compare: not decided", plural(w.undecided, "sample"));
    if (w.value > c.tolerance) how += fmt::format("; largest at t = {}", show_time(a, w.sample));
    p.lines.push_back({c.claim, how, w.value, c.tolerance, c.unit});
  }
  return p;
}

document::Data data_of(const Analysis& a, const std::string& name, ColumnList* list) {
  document::Data d{name, {"t [s]"}, {a.time()}};
  for (const Column& c : a.columns_of(list)) {
    d.headings.push_back(c.unit.empty() ? c.name : fmt::format("{} [{}]", c.name, c.unit));
    d.columns.push_back(a.column(c));
  }
  return d;
}

}  // namespace pmreport::section
