// The interval arithmetic of spans.hpp, on plain bounds: rounding goes upward within, and nowhere else.
#pragma once

#include <core/program/intervals/bounds.hpp>

#include <span>

namespace pmreport::analysis {

// (1) of spans.hpp: `value` at all of `time`, given its value at `middle`, an instant in it, and its rate at all of it. What is not bounded
// teaches nothing.
void sharpen(program::Bounds time, double middle, std::span<const program::Bounds> at_middle, std::span<const program::Bounds> rate,
             std::span<program::Bounds> value);

// (2) of spans.hpp: no matrix within `wrenches`, 6 x 6 by rows, is singular, as far as `inverse`, by rows, can show.
bool regular(std::span<const program::Bounds, 36> wrenches, std::span<const double, 36> inverse);

}  // namespace pmreport::analysis
