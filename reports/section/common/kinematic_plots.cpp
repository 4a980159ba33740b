#include <reports/section/common/force_plots.hpp>
#include <reports/section/common/kinematic_plots.hpp>

#include <algorithm>

namespace pmreport::section {

bool linear_drives(const Analysis& a) { return a.machine().topology().actuators.front().sense() == Sense::linear; }

std::vector<Column> columns_in(const Analysis& a, ColumnList* list, std::initializer_list<std::string_view> groups) {
  std::vector<Column> out;
  for (const Column& c : list(a.machine().topology()))
    if (std::find(groups.begin(), groups.end(), c.group) != groups.end()) out.push_back(c);
  return out;
}

void add_actuators(figure::Figure& f, const Analysis& a, ColumnList* list, OfMotion what, const std::string& words,
                   const std::string& per) {
  for (const std::string unit : {"m", "rad"}) {
    const std::vector<Trace> curves = group(a, list, analysis::group_of("actuator", what), unit + per);
    const std::size_t before = f.panels.size();
    add_panel(f, a, words, words, unit + per, curves);
    if (f.panels.size() == before) continue;
    const double per_si = unit_of(a, unit + per, curves).per_si;
    if (what == OfMotion::value) add_stroke_lines(f.panels.back(), a, unit, per_si);
    if (what == OfMotion::rate) add_limit_lines(f.panels.back(), a, a.scenario().limits.speed, unit, per_si);
  }
}

}  // namespace pmreport::section
