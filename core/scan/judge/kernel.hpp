// The loops of a judge, in the vectors of the processor that they run on.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pmreport::scan {

// What is known of a pose while margins are looked at, as a number, since numbers are what lanes compare with.
constexpr double is_refused = 0, is_on_a_limit = 1, is_kept = 2;

struct Refusals {
  std::uint64_t any = 0;    // poses that a margin refuses
  std::uint64_t first = 0;  // of these, such as nothing refused before
};

struct JudgeKernel {
  // Margin m of pose k at values[m * count + k], of so many margins; no number is negative. Lowers what is known of each pose, and returns
  // how many are left.
  std::size_t (*judge)(std::size_t margins, const double* slack, std::size_t count, const double* values, double* known);
  // One margin, with what it refuses.
  Refusals (*explain)(double slack, std::size_t count, const double* values, double* known);
};

// That of this processor. All give the same.
const JudgeKernel& judge_kernel();

}  // namespace pmreport::scan
