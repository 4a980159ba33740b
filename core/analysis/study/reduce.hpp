// Columns reduced to single numbers.
#pragma once

#include <core/analysis/analysis.hpp>
#include <core/scenario/measured.hpp>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::analysis {

struct Reduced {
  double value = std::numeric_limits<double>::quiet_NaN();  // SI
  int sample = -1;                                          // where; -1: not at a single sample
};
// By the measure's reduction over the samples ("min", "max", "rms"), of magnitudes where it says so. NaN when the column has no value to
// reduce.
Reduced reduce(const std::vector<double>& column, const scenario::Measured& how);

// One number of the report, and where it was found.
struct Number {
  double value = std::numeric_limits<double>::quiet_NaN();
  int sample = -1;     // -1: not at a single sample
  std::string column;  // of a group, the one that counts
};
// Of the columns of `m`; "at" a time between two samples is a sample of its own (instant.hpp). `largest`: of a group the largest column
// counts, else the smallest. NaN when one of them is missing or has no value.
Number measure(const Analysis& a, const scenario::Measured& m, bool largest = true);

// The same over every instant, where it was proved: the number lies within, by the brackets of all columns of a "min" or "max". None: of a
// quantity or another reduction, or where a column has no bracket.
std::optional<program::Bounds> measure_proved(const MotionProof& proof, const scenario::Measured& m, bool largest = true);

// The sample with the largest magnitude in a column; value 0 and sample -1 where there is none.
struct Peak {
  int sample = -1;
  double value = 0;  // with its sign
};
Peak peak(const Analysis& a, const ColumnId& column);
// Root of the mean square over the samples that have a value; NaN where none has.
double rms(const Analysis& a, const ColumnId& column);
double rms(const std::vector<double>& column);

}  // namespace pmreport::analysis
