// A small mechanism to try scenarios on: a carriage slides along X, a table turns on it about Z, and a feeler of length r on the table
// stands at height y = r sin(phi). Either phi or y is the independent one; the other follows.
#pragma once

#include <core/scenario/loaded.hpp>

namespace stage {

pmreport::scenario::MechanismSource source();  // knows stewart by name alone

}  // namespace stage
