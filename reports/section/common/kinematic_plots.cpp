#include <reports/section/common/kinematic_plots.hpp>

#include <algorithm>

namespace pmreport::section {

void add_panel(figure::Figure& f, const Analysis& a, const std::string& title, const std::string& axis, const std::string& unit,
               const std::vector<Trace>& curves) {
  if (!curves.empty()) f.panels.push_back(panel(a, title, axis, unit, curves));
}

bool linear_drives(const Analysis& a) { return a.machine().topology().actuators.front().sense() == Sense::linear; }

std::vector<Column> columns_in(const Analysis& a, ColumnList* list, std::initializer_list<std::string_view> groups) {
  std::vector<Column> out;
  for (const Column& c : list(a.machine().topology()))
    if (std::find(groups.begin(), groups.end(), c.group) != groups.end()) out.push_back(c);
  return out;
}

void add_actuators(figure::Figure& f, const Analysis& a, ColumnList* list, OfMotion what, const std::string& words,
                   const std::string& per) {
  for (const std::string unit : {"m", "rad"})
    add_panel(f, a, words, words, unit + per, group(a, list, analysis::group_of("actuator", what), unit + per));
}

}  // namespace pmreport::section
