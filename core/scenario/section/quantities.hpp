// Quantities that sections name: single numbers, for checks, comparisons and results.json.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pmreport::mechanics {

struct Quantity {
  std::string name;   // "mobility.redundant"
  std::string unit;   // SI
  std::string title;  // "redundant constraints"
  bool count = true;  // a whole number
};

// Of a section kind: "mobility", "singularity" (`poses`: how many it is given), "assembly", "classification", "dynamics",
// "drives", "reactions", "speed". Others: none.
std::vector<Quantity> quantities_of(std::string_view section, std::size_t poses = 0);
std::vector<std::string> sections_with_quantities();

}  // namespace pmreport::mechanics
