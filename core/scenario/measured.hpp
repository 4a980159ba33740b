// Numbers of the report, and the gates over them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

// One number of the report: a column, or a group of columns, reduced; or a quantity that a section names.
struct Measured {
  std::string that;       // as written: "max(abs(actuator_force))", "mobility.redundant"
  std::string quantity;   // "mobility.redundant", of a kind of section; empty: reduced columns
  std::string reduction;  // "min", "max", "rms", "at"
  bool absolute = false;
  std::vector<std::string> columns;  // resolved column names: l1_force, ...
  double time = 0;                   // for "at": at(l1, 2.5 s)
  std::string unit;                  // SI
  bool count = false;                // a whole number
};

// Gate over a number of the report.
struct Check : Measured {
  std::optional<double> below, above;  // SI; passes when below and above hold strictly
  std::optional<double> equals;        // SI; passes when the number is `within` of it or nearer
  double within = 0;                   // SI; 0: exactly, of counts
  std::string written_in = {};         // the unit of its first bound, as its author has it: "rad/s"; empty: none, or not one alone
  int line = 0;
};

}  // namespace pmreport::scenario
