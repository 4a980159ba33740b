// The property suite: what must hold for every mechanism, whoever wrote it. Run by the tests over all plugins and by `pmreport check`.
#pragma once

#include <core/mechanics/model/machine.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace pmreport::mechanics {

struct Property {
  std::string claim;  // "joints close"
  std::string how;    // what was compared with what
  double worst = 0;   // largest deviation found
  double tolerance = 0;
  std::string unit;   // "m", "rad", "" relative or a count
  std::string where;  // the pose, joint or body of the worst case, and what to look at when it fails
  bool passed() const { return worst <= tolerance; }
};

struct PropertyOptions {
  int poses = 1000;  // random poses in the box of the coordinates; those out of reach are counted, not judged
  std::uint64_t seed = 1;
};

// Every property at home and at random poses with random rates and accelerations.
std::vector<Property> check_properties(const Machine& machine, const PropertyOptions& options = {});

}  // namespace pmreport::mechanics
