// What an actuator exerts and feels: a linear one a force and a mass, a rotary one a torque and a moment of inertia.
#pragma once

#include <pmreport/topology.hpp>

namespace pmreport::mechanics {

constexpr const char* word_of_effort(Sense s) { return s == Sense::linear ? "force" : "torque"; }
constexpr const char* unit_of_effort(Sense s) { return s == Sense::linear ? "N" : "N*m"; }
constexpr const char* unit_of_inertia(Sense s) { return s == Sense::linear ? "kg" : "kg*m^2"; }

// The size that makes a coordinate or an actuator of either sense comparable: `length` [m], or one radian.
constexpr double size_of(Sense s, double length) { return s == Sense::linear ? length : 1.0; }

}  // namespace pmreport::mechanics
