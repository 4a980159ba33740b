// A program as text: one line a step, for tests and for people.
#pragma once

#include <core/program/program.hpp>

#include <span>
#include <string>

namespace pmreport::program {

// "v3 = x0 * v1", with names of inputs and outputs where they are given, constants to the last digit; at the end what each output is.
std::string print(const Program& program, std::span<const std::string> inputs = {}, std::span<const std::string> outputs = {});

}  // namespace pmreport::program
