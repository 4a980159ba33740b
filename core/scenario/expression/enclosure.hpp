// An expression of t over a span of time: what it can be at any instant of it, proved by interval arithmetic.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <core/scenario/expression/expression.hpp>
#include <pmreport/jet.hpp>

namespace pmreport::scenario {

// Value, rate and acceleration at every instant of the span, rounding included; where the expression goes over from one branch to another
// within, or at an end, those of both sides; no bound of the rate where the value jumps, nor of the acceleration where the rate does. Of an
// expression of t alone. Not bounded: nothing is known. The width is that of what it does in the span to the second order in its length.
Jet<program::Bounds> over(const Expression& expression, program::Bounds time);

}  // namespace pmreport::scenario
