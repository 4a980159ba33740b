// What `pmreport check` prints: the property suite of each mechanism, and a table of all when there are several.
#pragma once

#include <core/mechanics/conformance/properties.hpp>

#include <string>
#include <vector>

namespace pmreport::program {

struct Checked {
  std::string mechanism;
  int passed = 0, properties = 0;
  std::string closest;  // the property that came closest to its tolerance, or exceeded it by most
  double share = 0;     // its deviation in terms of its tolerance
  bool all_passed() const { return passed == properties; }
};

// Runs the suite and prints it, with what to look at where it fails.
Checked print_properties(const mechanics::Machine& machine, int poses);

void print_table(const std::vector<Checked>& all);

}  // namespace pmreport::program
