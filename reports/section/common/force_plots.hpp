// Panels and tables of forces in motion that the sections `dynamics` and `drives` share.
#pragma once

#include <core/analysis/study/reduce.hpp>
#include <core/text/units.hpp>
#include <reports/section/common/plots.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// The curves of one kind of column of the actuators of a unit, "m" or "rad", labelled by their symbols; those that the run has.
std::vector<Trace> of_actuators(const Analysis& a, OfActuator what, const std::string& unit);
std::vector<Trace> of_actuators(const Analysis& a, OfActuator what);  // of any unit

// Lines at both signs of the finite `limits` (one an actuator, SI) of the actuators of a unit; those alike in one, hatched beyond
// where one holds for all. `per_si`: the panel's.
void add_limit_lines(figure::Panel& p, const Analysis& a, const std::vector<double>& limits, const std::string& unit, double per_si);

// The curves of one actuator that a figure of shares shows, in the same style in every panel; keys in the first panel alone.
struct Share {
  ColumnId column;
  std::string label;
  int style;
};
constexpr int total_style = 73;                                      // black, solid
constexpr int load_style = 1, gravity_style = 2, inertia_style = 5;  // orange, green and sky blue, dashed
figure::Panel share_panel(const Analysis& a, const std::string& title, const std::string& axis, const std::string& unit,
                          const std::vector<Share>& shares, bool keys);

// "F" by unit of an actuator: a force, or a torque.
std::string effort(const std::string& actuator_unit);       // "force", "torque"
std::string effort_unit(const std::string& actuator_unit);  // "N", "N*m"

using analysis::peak;
using analysis::Peak;
using analysis::rms;

// A column of a table: one SI unit, shown in the unit that reads best for its largest number.
class TableColumn {
 public:
  TableColumn(const Analysis& a, const std::string& title, const std::string& unit, const std::vector<double>& values);
  const std::string& heading() const { return heading_; }  // "peak force [N]"
  std::string cell(double value) const;                    // "–" where it is not a number, "0" where it is rounding

 private:
  std::string heading_;
  double per_si_, nothing_;
};

}  // namespace pmreport::section
