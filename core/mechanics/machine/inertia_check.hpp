// Whether there can be bodies with the masses and inertias that are declared.
#pragma once

#include <core/mechanics/machine/machine.hpp>

#include <span>
#include <string>

namespace pmreport::mechanics {

// What no body can have: "its mass is -1 kg", with numbers; empty: nothing is wrong.
struct InertiaFault {
  std::string sentence;
  bool of_mass = false;  // the mass is wrong, rather than the inertia
};
// `turned_about`: axes, unit vectors in axes of the body, about which a rotary actuator turns it, or turns others against it. There the
// rotor of a geared motor may be felt.
InertiaFault inertia_fault(const Inertia& inertia, std::span<const Eigen::Vector3d> turned_about = {});

// Throws MechanismError with the body, what is wrong, and the parameters to look at: PM_BAD_ARGUMENT where parameters that differ from
// their defaults have brought it, else PM_FAILED. Of a machine that knows its home pose.
void check_inertias(const Machine& machine, const pm_mechanism& table);

}  // namespace pmreport::mechanics
