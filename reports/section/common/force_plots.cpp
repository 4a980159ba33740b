#include <core/mechanics/model/effort.hpp>
#include <reports/section/common/force_plots.hpp>

#include <reports/section/common/words/noise.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pmreport::section {

namespace {

// What drives and motors give is told by whose it is.
std::string label_of(const Topology& t, const Actuator& x, OfActuator what) {
  if (what == OfActuator::static_force || what == OfActuator::dynamic_force) return effort_symbol(t, x);
  return what == OfActuator::power ? effort_symbol(t, x, Effort::power) : symbol(x.name);
}

}  // namespace

std::vector<Trace> of_actuators(const Analysis& a, OfActuator what, const std::string& unit) {
  const Topology& t = a.machine().topology();
  std::vector<Trace> out;
  for (const Actuator& x : t.actuators)
    if (const ColumnId column = column_of(x, what); (unit.empty() || x.unit == unit) && a.has(column))
      out.push_back({column, label_of(t, x, what)});
  return out;
}

std::vector<Trace> of_actuators(const Analysis& a, OfActuator what) { return of_actuators(a, what, ""); }

void add_limit_lines(figure::Panel& p, const Analysis& a, const std::vector<double>& limits, const std::string& unit, double per_si) {
  std::map<double, std::string> names;  // of each bound, whom it binds
  int bound = 0, all = 0;
  const std::vector<Actuator>& actuators = a.machine().topology().actuators;
  for (std::size_t i = 0; i < actuators.size(); ++i) {
    if (!unit.empty() && actuators[i].unit != unit) continue;
    ++all;
    if (i >= limits.size() || !std::isfinite(limits[i])) continue;
    ++bound;
    std::string& name = names[limits[i]];
    name += (name.empty() ? "" : " ") + symbol(actuators[i].name);
  }
  for (const auto& [limit, name] : names) {
    using Forbids = figure::Line::Forbids;
    const bool common = names.size() == 1 && bound == all;
    const std::string label = common ? "limit" : "limit " + name;
    p.lines.push_back({limit * per_si, label, common ? Forbids::above : Forbids::nothing});
    p.lines.push_back({-limit * per_si, label, common ? Forbids::below : Forbids::nothing});
  }
}

figure::Panel share_panel(const Analysis& a, const std::string& title, const std::string& axis, const std::string& unit,
                          const std::vector<Share>& shares, bool keys) {
  std::vector<Trace> curves;
  for (const Share& s : shares) curves.push_back({s.column, keys ? s.label : ""});
  figure::Panel p = panel(a, title, axis, unit, curves);
  for (std::size_t i = 0; i < shares.size(); ++i) p.series[i].style = shares[i].style;
  return p;
}

std::string effort(const std::string& actuator_unit) { return mechanics::word_of_effort(sense_of(actuator_unit)); }
std::string effort_unit(const std::string& actuator_unit) { return mechanics::unit_of_effort(sense_of(actuator_unit)); }

TableColumn::TableColumn(const Analysis& a, const std::string& title, const std::string& unit, const std::vector<double>& values) {
  double largest = 0;
  for (const double x : values)
    if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
  const DisplayUnit d = display_unit(unit, largest);
  per_si_ = d.per_si;
  nothing_ = std::max(noise(a, unit, {}), noise_of(largest));
  heading_ = d.label.empty() ? title : fmt::format("{} [{}]", title, d.label);
}

std::string TableColumn::cell(double value) const {
  if (!std::isfinite(value)) return "–";
  return typeset(format_number((std::abs(value) < nothing_ ? 0 : value) * per_si_, 4));
}

}  // namespace pmreport::section
