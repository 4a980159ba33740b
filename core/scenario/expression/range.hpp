// Ranges of the terms of an expression: no term takes a value outside its own, rounding included.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <core/scenario/expression/expression.hpp>
#include <vector>

namespace pmreport::scenario {

// Where there is a value at all. Not bounded where nothing bounds it.
struct Range {
  program::Bounds value, rate;  // the rate of both branches, where a function goes over from one to another
};
// The range of every term of an expression of t alone, t in [begin, end], in the terms' order; without their rates in half the time.
void values_of(std::span<const Term> terms, double begin, double end, std::vector<Range>& out);
void ranges_of(std::span<const Term> terms, double begin, double end, std::vector<Range>& out);

}  // namespace pmreport::scenario
