// Section `dynamics`: what the actuators must exert, their powers, and the energies.
#pragma once

#include <reports/section/kind.hpp>

namespace pmreport::section {

struct DynamicsOptions : scenario::Options {
  std::vector<double> equations;  // mass matrix, Coriolis and gravity terms at these times [s]
};

const SectionKind& dynamics_kind();
Result dynamics_section(const Analysis& a, const DynamicsOptions& r);

}  // namespace pmreport::section
