// Programs that differentiate a program.
#pragma once

#include <core/program/program.hpp>

#include <span>

namespace pmreport::program {

// Inputs as before. Outputs: those of the program, then the partial derivatives: output o by input by[i] stands at
// outputs + o * by.size() + i. A choice has the derivative of what is chosen.
Program partials(const Program& program, std::span<const int> by);

// Inputs: those of the program, then their rates, then (`order` 2) their accelerations. Outputs: those of the program, their rates, and
// (`order` 2) their accelerations. `order`: 1 or 2.
Program in_time(const Program& program, int order);

}  // namespace pmreport::program
