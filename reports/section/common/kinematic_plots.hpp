// Panels that the sections of displacement, velocity and acceleration and the overview share.
#pragma once

#include <reports/section/common/plots.hpp>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::section {

void add_panel(figure::Figure& f, const Analysis& a, const std::string& title, const std::string& axis, const std::string& unit,
               const std::vector<Trace>& curves);  // none without curves
bool linear_drives(const Analysis& a);             // the first actuator's stands for all
// The columns of some groups of a list.
std::vector<Column> columns_in(const Analysis& a, ColumnList* list, std::initializer_list<std::string_view> groups);
// Curves of the actuators, a panel for linear and one for rotary ones. `per`: of the unit, "/s".
void add_actuators(figure::Figure& f, const Analysis& a, ColumnList* list, OfMotion what, const std::string& words, const std::string& per);

}  // namespace pmreport::section
