// What went into a run, and where it comes from.
#pragma once

#include <string>
#include <vector>

namespace pmreport::document {

struct Input {
  std::string name;                  // as a path of the scenario: "mechanism.parameters.base_radius", "load.force"
  std::string text = {};             // as written; of a parameter that is a choice its word; empty: numbers
  std::vector<double> numbers = {};  // [unit], SI
  bool list = false;                 // of numbers
  std::string unit = {};             // SI; empty: none, or as written in the text
  std::string source = {};           // "scenario", "default of the plugin"
  int line = 0;                      // of the scenario, 1-based; 0: it has none
};

}  // namespace pmreport::document
