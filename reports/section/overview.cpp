#include <reports/section/overview.hpp>

#include <reports/figure/layout/range.hpp>
#include <reports/section/common/force_plots.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>

namespace pmreport::section {

namespace {

constexpr std::size_t fewest_columns = 3;
constexpr int digits = 3;  // of the numbers beside the worst points

// A column of the overview.
struct Quantity {
  std::string title, unit;                          // unit: SI
  std::function<ColumnId(const Actuator&)> column;  // of an actuator
  std::function<Range(std::size_t)> allowed;        // of an actuator, by its number in the topology [SI]; infinite where nothing limits it
  std::string limits;                               // "strokes": what the range is called
  bool stroke = false;
};

constexpr double none = std::numeric_limits<double>::infinity();

std::function<Range(std::size_t)> both_ways(const std::vector<double>& limits) {
  return [&limits](std::size_t i) { return i < limits.size() ? Range{-limits[i], limits[i]} : Range{-none, none}; };
}

Range unlimited(std::size_t) { return {-none, none}; }

std::vector<Quantity> quantities(const Analysis& a, const std::string& unit) {
  const auto asked = [&](std::string_view kind) {
    return std::ranges::any_of(a.scenario().sections, [&](const scenario::Section& s) { return s.kind->name == kind; });
  };
  const mechanics::MotionLimits& limits = a.scenario().limits;
  const bool moving = asked("dynamics"), linear = unit == "m";
  const auto of_motion = [](OfMotion what) { return [what](const Actuator& x) { return column_of(x, what); }; };
  const auto of_actuator = [](OfActuator what) { return [what](const Actuator& x) { return column_of(x, what); }; };
  std::vector<Quantity> out;
  if (asked("displacement"))
    out.push_back({linear ? "length" : "angle", unit, of_motion(OfMotion::value),
                   [&a](std::size_t i) { return a.machine().topology().actuators[i].stroke; }, "strokes", true});
  if (asked("velocity")) out.push_back({"speed", unit + "/s", of_motion(OfMotion::rate), both_ways(limits.speed), "speed limits"});
  if (asked("acceleration") && !moving) out.push_back({"acceleration", unit + "/s^2", of_motion(OfMotion::acceleration), unlimited, ""});
  if (moving) {
    out.push_back(
        {effort(unit), effort_unit(unit), of_actuator(OfActuator::dynamic_force), both_ways(limits.force), effort(unit) + " limits"});
    out.push_back({"power", "W", of_actuator(OfActuator::power), both_ways(limits.power), "power limits"});
  } else if (asked("statics")) {
    out.push_back({effort(unit) + " at rest", effort_unit(unit), of_actuator(OfActuator::static_force), unlimited, ""});
  }
  return out;
}

// How near a value comes to what limits it: 1 at the limit, more beyond it. Without limits its magnitude, which is less than any use of
// one.
struct Use {
  bool limited = false;
  double use = -none;

  // Of two that only rounding sets apart the first counts, on every processor.
  bool exceeds(const Use& other) const {
    if (limited != other.limited) return limited;
    return use > other.use + 1e-9 * std::abs(other.use) || (std::isfinite(use) && !std::isfinite(other.use));
  }
};
Use use_of(double x, const Range& allowed) {
  if (!std::isfinite(allowed.min) || !std::isfinite(allowed.max)) return {false, std::abs(x)};
  const double middle = allowed.min / 2 + allowed.max / 2, half = allowed.max / 2 - allowed.min / 2;
  return {true, std::abs(x - middle) / half};
}

// Where the use is largest. -1: no value.
int worst_sample(const std::vector<double>& x, const Range& allowed) {
  int worst = -1;
  Use most;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!std::isfinite(x[k])) continue;
    const Use use = use_of(x[k], allowed);
    if (worst < 0 || use.exceeds(most)) most = use, worst = static_cast<int>(k);
  }
  return worst;
}

// What the values of each row count from [SI]: 0, or of strokes that differ their middles.
std::vector<double> middles_of(const Quantity& q, const std::vector<std::size_t>& rows) {
  std::vector<double> out(rows.size(), 0);
  const auto differs = [&](std::size_t i) {
    const Range first = q.allowed(rows.front()), other = q.allowed(i);
    return other.min != first.min || other.max != first.max;
  };
  if (!q.stroke || std::none_of(rows.begin(), rows.end(), differs)) return out;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const Range stroke = q.allowed(rows[row]);
    const double middle = stroke.min / 2 + stroke.max / 2;
    if (!std::isfinite(middle)) return std::vector<double>(rows.size(), 0);
    out[row] = middle;
  }
  return out;
}

// Of one column: its panels from top to bottom, its worst points marked. `off_scale` gathers limits that no panel can show.
std::vector<figure::Panel> column_panels(const Analysis& a, const Quantity& q, const std::vector<std::size_t>& rows,
                                         std::vector<std::string>& off_scale) {
  const std::vector<Actuator>& actuators = a.machine().topology().actuators;
  std::vector<Trace> curves;
  for (const std::size_t i : rows) curves.push_back({q.column(actuators[i]), ""});
  const figure::Panel all = panel(a, "", q.title, q.unit, curves);
  const double per_si = unit_of(a, q.unit, curves).per_si;

  // Strokes that differ have one scale when each counts from its middle.
  const std::vector<double> middles = middles_of(q, rows);

  std::vector<figure::Panel> out;
  std::vector<int> worst;
  double largest = 0;
  Use gravest;
  std::size_t grave = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    figure::Panel p{symbol(actuators[rows[row]].name) + ", " + q.title, {"t", "s"}, all.y, {all.series[row]}, all.bands, {}};
    p.series.front().style = static_cast<int>(row);
    Range allowed = q.allowed(rows[row]);
    allowed.min -= middles[row], allowed.max -= middles[row];
    for (double& y : p.series.front().y) y -= middles[row] * per_si;
    if (std::isfinite(allowed.max)) p.lines.push_back({allowed.max * per_si, "", figure::Line::Forbids::above});
    if (std::isfinite(allowed.min)) p.lines.push_back({allowed.min * per_si, "", figure::Line::Forbids::below});
    const std::vector<double>& y = p.series.front().y;
    const Range drawn{allowed.min * per_si, allowed.max * per_si};
    worst.push_back(worst_sample(y, drawn));
    if (worst.back() >= 0) {
      const double value = y[static_cast<std::size_t>(worst.back())];
      largest = std::max(largest, std::abs(value));
      if (const Use use = use_of(value, drawn); use.exceeds(gravest)) gravest = use, grave = row;
    }
    out.push_back(std::move(p));
  }
  const int decimals = largest > 0 ? std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(largest)))) : 0;
  figure::Panel shared;
  for (std::size_t row = 0; row < out.size(); ++row) {
    figure::Panel& p = out[row];
    shared.series.push_back(p.series.front());
    shared.lines.insert(shared.lines.end(), p.lines.begin(), p.lines.end());
    if (worst[row] < 0) continue;
    const auto k = static_cast<std::size_t>(worst[row]);
    const double value = p.series.front().y[k];
    const double rounded = std::round(value * std::pow(10.0, decimals)) == 0 ? 0 : value;
    p.marks.push_back(
        {a.time()[k], value, typeset(fmt::format("{:.{}f}", rounded, decimals)), static_cast<int>(row), row == grave && out.size() > 1});
  }
  const figure::Interval shown = figure::y_range(shared);
  double low = none, high = -none;
  for (const figure::Line& l : shared.lines)
    if (l.y < shown.low || l.y > shown.high) low = std::min(low, l.y / per_si), high = std::max(high, l.y / per_si);
  if (low <= high) {
    const bool symmetric = low == -high;
    const std::string ends = symmetric    ? "±" + show(high, q.unit)
                             : low < high ? show(low, q.unit) + " to " + show(high, q.unit)
                                          : show(low, q.unit);
    const std::string limits = low < high ? q.limits : q.limits.substr(0, q.limits.size() - 1);  // "force limit"
    off_scale.push_back(limits + " " + ends);
  }
  return out;
}

// Of the actuators of one unit; no panels where there are too few columns.
figure::Figure multiples(const Analysis& a, const std::string& unit) {
  const std::vector<Actuator>& actuators = a.machine().topology().actuators;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < actuators.size(); ++i)
    if (actuators[i].unit == unit) rows.push_back(i);
  const std::vector<Quantity> columns = quantities(a, unit);
  figure::Figure f{unit == "m" ? "overview" : "overview-rotary", "", "", figure::Width::full, static_cast<int>(columns.size()), {}};
  if (rows.empty() || columns.size() < fewest_columns) return f;

  std::vector<std::string> titles, off_scale;
  std::vector<std::vector<figure::Panel>> drawn;
  for (const Quantity& q : columns) {
    drawn.push_back(column_panels(a, q, rows, off_scale));
    const std::vector<double> middles = middles_of(q, rows);
    const bool from_middle = std::any_of(middles.begin(), middles.end(), [](double m) { return m != 0; });
    titles.push_back(from_middle ? q.title + " from mid-stroke" : q.title);
  }
  figure::Multiples names{{}, titles};
  bool limits = false;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    names.rows.push_back(symbol(actuators[rows[row]].name));
    for (std::vector<figure::Panel>& column : drawn) {
      limits = limits || !column[row].lines.empty();
      f.panels.push_back(std::move(column[row]));
    }
  }
  f.multiples = std::move(names);
  const bool strokes = std::any_of(columns.begin(), columns.end(), [](const Quantity& q) { return q.stroke; });
  f.caption = fmt::format(
      "Every actuator at a glance: {}. A column has one scale. Dots: the worst of each actuator, in bold of all; {}.",
      fmt::join(titles, ", "),
      strokes ? fmt::format("of {} the nearest to an end of its stroke, else the largest", unit == "m" ? "a length" : "an angle")
              : "the largest");
  if (limits) f.caption += " Hatched: beyond a limit.";
  if (!off_scale.empty()) f.caption += fmt::format(" Off the scale: {}.", fmt::join(off_scale, "; "));
  return f;
}

}  // namespace

std::vector<document::Section> overview_section(const Analysis& a) {
  document::Section s{"overview", "overview", "Overview", {}};
  for (const char* unit : {"m", "rad"})
    if (figure::Figure f = multiples(a, unit); !f.panels.empty()) s.blocks.push_back(std::move(f));
  if (s.blocks.empty()) return {};
  return {std::move(s)};
}

}  // namespace pmreport::section
