// How it ends to ask for a pose, or for a way of poses.
#pragma once

#include <cstdint>

namespace pmreport::mechanics {

enum class Outcome : std::uint8_t {
  good,                 // there it is, or the way has been gone to its end
  singular,             // a singular surface: the actuators do not hold the platform, and branches of forward displacement fold back
  unreachable,          // the mechanism cannot be assembled, or not any further, at a regular pose
  at_limit,             // an actuator at the end of its stroke, or a joint at its limit
  other_assembly_mode,  // there is a pose, but the way to it crosses a singular surface
  not_converged,        // none near the guess: out of reach, or the guess is too far
  failed                // numbers that are not finite: the plugin's, or of forces or a motion beyond bounds
};

}  // namespace pmreport::mechanics
