// What of a column is rounding and what is signal.
#pragma once

#include <reports/section/common/analysis.hpp>

#include <string_view>
#include <vector>

namespace pmreport::section {

// Numbers that vanish are sums whose terms cancel, to some rounding of the largest of these terms. The terms are of the size of what the
// run has of the same sort: a length among lengths, and angles times the machine's length; a force among forces, and moments by that
// length. So every column of a sort shares one threshold, and a column of one sort alone (a determinant, a power) has its own.
//
// Magnitudes in columns of this SI unit that are rounding [SI]: figures and tables show zero, data files the number.
double noise(const Analysis& a, std::string_view unit, const std::vector<ColumnId>& columns);

// Of numbers that are computed from terms up to this size: some dozen roundings.
double noise_of(double largest_term);

}  // namespace pmreport::section
