// Panels that the sections of displacement, velocity and acceleration share.
#pragma once

#include <reports/section/common/plots.hpp>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::section {

bool linear_drives(const Analysis& a);  // the first actuator's stands for all
// The columns of some groups of a list.
std::vector<Column> columns_in(const Analysis& a, ColumnList* list, std::initializer_list<std::string_view> groups);
// Curves of the actuators and their limits, a panel for linear and one for rotary ones. `per`: of the unit, "/s".
void add_actuators(figure::Figure& f, const Analysis& a, ColumnList* list, OfMotion what, const std::string& words, const std::string& per);

}  // namespace pmreport::section
