#include <core/text/digits.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/noise.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

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

std::string constants(const Analysis& a, const std::string& unit, const std::vector<Trace>& curves) {
  const double nothing = noise(a, unit, columns_of(curves));
  const DisplayUnit d = unit_of(a, unit, curves);
  std::vector<std::string> names, values;
  for (const Trace& c : curves) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double x : a.column(c.column))
      if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
    if (low > high) return "";
    // Rounding of the value itself and of the terms it is the sum of.
    if (!(high - low <= std::max(nothing, noise_of(std::max(std::abs(low), std::abs(high)))))) return "";
    const double value = shown(low / 2 + high / 2, nothing) * d.per_si;
    const std::string beside = d.label.empty() || d.label == "°" ? d.label : " " + d.label;
    names.push_back(c.label);
    values.push_back(typeset(format_number(value, digits_of_value)) + beside);
  }
  std::string out;
  const bool alike = std::all_of(values.begin(), values.end(), [&](const std::string& v) { return v == values.front(); });
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (alike)
      out += names[i] + (names[i].empty() ? "" : " = ");
    else
      out += (i == 0 ? "" : ", ") + names[i] + (names[i].empty() ? "" : " = ") + values[i];
  }
  return alike && !values.empty() ? out + values.front() : out;
}

void add_panel(figure::Figure& f, const Analysis& a, const std::string& title, const std::string& axis, const std::string& unit,
               const std::vector<Trace>& curves) {
  if (curves.empty()) return;
  if (const std::string words = constants(a, unit, curves); !words.empty())
    f.caption += fmt::format("{}Constant, so not drawn: {}, {}.", f.caption.empty() ? "" : " ", title, words);
  else
    f.panels.push_back(panel(a, title, axis, unit, curves));
}

void put(document::Section& s, figure::Figure f) {
  if (f.panels.empty())
    s.blocks.push_back(document::Paragraph{document::Paragraph::Tone::plain, std::move(f.caption)});
  else
    s.blocks.push_back(std::move(f));
}

void add_stroke_lines(figure::Panel& p, const Analysis& a, const std::string& unit, double per_si) {
  using Forbids = figure::Line::Forbids;
  std::set<double> lowest, highest;
  for (const Actuator& x : a.machine().topology().actuators)
    if (x.unit == unit) lowest.insert(x.stroke.min), highest.insert(x.stroke.max);
  if (highest.size() == 1 && std::isfinite(*highest.begin())) p.lines.push_back({*highest.begin() * per_si, "stroke ends", Forbids::above});
  if (lowest.size() == 1 && std::isfinite(*lowest.begin())) p.lines.push_back({*lowest.begin() * per_si, "stroke ends", Forbids::below});
}

namespace {

// "v" of a velocity, with the axis behind it: vx.
std::string letter_of(const std::string& vector) {
  return vector == "velocity" ? "v" : vector == "angular_velocity" ? "ω" : vector == "acceleration" ? "a" : with_dots("ω", 1);
}

int dots_of(const std::string& name) { return name.ends_with("_rate") ? 1 : name.ends_with("_acceleration") ? 2 : 0; }

}  // namespace

std::vector<Trace> group(const Analysis& a, ColumnList* list, const std::string& name, const std::string& unit) {
  std::vector<Trace> out;
  const bool vector = name == "velocity" || name == "angular_velocity" || name == "acceleration" || name == "angular_acceleration";
  for (const Column& c : a.columns_of(list)) {
    if (c.group != name || (!unit.empty() && c.unit != (unit == "1" ? "" : unit))) continue;
    const std::string axis = vector ? c.name.substr(c.name.size() - 1) : "";
    out.push_back({c, vector ? letter_of(name) + axis : with_dots(symbol(analysis::owner_of(c)), dots_of(name))});
  }
  // x, y, z and alpha, beta, gamma in this order, whichever of them is the dependent one.
  if (name.starts_with("coordinate")) std::sort(out.begin(), out.end(), [](const Trace& x, const Trace& y) { return x.column < y.column; });
  if (name == "actuator_force" || name == "dynamic_force")
    for (Trace& c : out)
      for (const Actuator& x : a.machine().topology().actuators)
        if (x.name == analysis::owner_of(c.column)) c.label = effort_symbol(a.machine().topology(), x);
  if (name == "constraint" && out.size() == 1) out.front().label = "Fτ";
  return out;
}

namespace {

// Smallest and largest of a column, and when.
struct Ends {
  int low = -1, high = -1;  // samples
  double smallest = 0, largest = 0, nothing = 0;
  double size() const { return std::max(std::abs(smallest), std::abs(largest)); }
};

Ends ends_of(const Analysis& a, const Column& c) {
  Ends e;
  const std::vector<double>& x = a.column(c);
  for (int k = 0; k < a.samples(); ++k) {
    const double v = x[static_cast<std::size_t>(k)];
    if (!std::isfinite(v)) continue;
    if (e.low < 0 || v < x[static_cast<std::size_t>(e.low)]) e.low = k;
    if (e.high < 0 || v > x[static_cast<std::size_t>(e.high)]) e.high = k;
  }
  if (e.low < 0) return e;
  e.nothing = noise(a, c.unit, {c});
  e.smallest = shown(x[static_cast<std::size_t>(e.low)], e.nothing), e.largest = shown(x[static_cast<std::size_t>(e.high)], e.nothing);
  return e;
}

// How the rows of one group and unit are written, so that their decimal points stand below each other: as many decimals as give its smaller
// numbers all digits, and its larger ones not more than one too many.
struct Notation {
  DisplayUnit unit;
  int decimals = -1;  // -1: each row for itself

  // Whether a row says enough in it: its digits, and those that set its ends apart.
  bool suits(const Ends& e) const {
    if (decimals < 0) return false;
    const double scale = std::pow(10.0, decimals) * unit.per_si, span = e.largest - e.smallest;
    const auto vanishes = [&](double si) { return si != 0 && std::round(si * scale) == 0; };
    return !vanishes(e.smallest) && !vanishes(e.largest) && (e.size() == 0 || e.size() * scale >= std::pow(10.0, digits_of_span - 1)) &&
           (span <= e.nothing || span * scale >= std::pow(10.0, digits_of_span - 1));
  }
  std::string number(double si) const { return si == 0 ? "0" : fmt::format("{:.{}f}", si * unit.per_si, decimals); }
};

Notation notation_of(const std::string& unit, const std::vector<Ends>& rows) {
  double largest = 0, least = std::numeric_limits<double>::infinity();
  for (const Ends& e : rows)
    if (e.size() > 0) largest = std::max(largest, e.size()), least = std::min(least, e.size());
  Notation n{display_unit(unit, largest)};
  constexpr double longest = 1e5, shortest = 1e-2;  // beyond, decimals are no way to write a number
  if (largest == 0 || largest * n.unit.per_si >= longest || largest * n.unit.per_si < shortest) return n;
  const auto wanted = [&](double size) { return digits_of_value - 1 - static_cast<int>(std::floor(std::log10(size * n.unit.per_si))); };
  n.decimals = std::max(0, std::min(wanted(least), wanted(largest) + 1));
  // Zeros at the end that all of them have say nothing.
  const auto ends_in_zero = [&](const Ends& e) { return n.number(e.smallest).back() == '0' && n.number(e.largest).back() == '0'; };
  while (n.decimals > 0 && std::all_of(rows.begin(), rows.end(), ends_in_zero)) --n.decimals;
  return n;
}

}  // namespace

document::Table extremes(const Analysis& a, const std::string& caption, const std::vector<Column>& columns) {
  document::Table table{
      caption, {"quantity", "meaning", "smallest", "at", "largest", "at", "unit"}, {false, false, true, true, true, true, false}, {}};
  std::map<std::pair<std::string, std::string>, std::vector<Ends>> groups;
  for (const Column& c : columns) groups[{c.group, c.unit}].push_back(ends_of(a, c));
  for (const Column& c : columns) {
    const Ends e = ends_of(a, c);
    if (e.low < 0) {
      table.rows.push_back({c.name, c.title, "–", "–", "–", "–", c.unit});
      continue;
    }
    const Notation common = notation_of(c.unit, groups[{c.group, c.unit}]);
    const bool suits = common.suits(e);
    const DisplayUnit d = suits ? common.unit : display_unit(c.unit, e.size());
    const std::vector<std::string> both =
        suits ? std::vector{common.number(e.smallest), common.number(e.largest)}
              : format_together({e.smallest * d.per_si, e.largest * d.per_si}, digits_of_value, digits_of_span, e.nothing * d.per_si);
    table.rows.push_back({c.name, c.title, typeset(both[0]), show_time(a, e.low), typeset(both[1]), show_time(a, e.high), d.label});
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

document::Data handed_over(Analysis& a, const std::string& name, ColumnList* list) {
  document::Data d{name, {"t [s]"}, {a.time()}};
  for (const Column& c : a.columns_of(list)) {
    d.headings.push_back(c.unit.empty() ? c.name : fmt::format("{} [{}]", c.name, c.unit));
    d.columns.push_back(a.release(c));
  }
  return d;
}

}  // namespace pmreport::section
