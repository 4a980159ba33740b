// Judges poses that share an orientation, many at a time.
#pragma once

#include <core/program/batch.hpp>
#include <core/scan/judge/plan.hpp>
#include <core/scan/tally.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pmreport::scan {

// What is known beforehand of a margin at all poses of a block.
enum class Verdict : std::uint8_t { open, kept, refused };

// Keeps its buffers: one a thread. A margin that is nearer to zero than its rounding counts as kept; an accepted pose with such a margin is
// on a limit, since the margin the other way would refuse it. A refused pose is refused by a margin that is beyond its rounding, whatever
// else is on a limit.
class Judge {
 public:
  explicit Judge(const Plan& plan);

  // Point k has the value points[s * count + k] of the input in slot s (Plan::slots); `others`: all inputs of the plan's inner program, of
  // which those that points move are not looked at. `verdicts`: one a margin of the program, and what they say is true; none: all open.
  // Returns the accepted poses by their numbers, ascending, until the next run, and adds all that is counted but the poses to `tally`.
  std::span<const std::uint32_t> run(std::size_t count, const double* points, const double* others, std::span<const Verdict> verdicts,
                                     Tally& tally);
  // Of the poses that the last run accepted: is_on_a_limit or is_kept (kernel.hpp).
  std::span<const double> known() const { return {known_.data(), accepted_.count}; }
  // Of these too: the plan's sign program. The points of the run must still stand.
  std::span<const double> signs();

 private:
  struct Left {                      // poses that nothing refused so far
    const double* points = nullptr;  // slot after slot
    std::size_t count = 0;           // of which the last stage may have refused some
    std::size_t left = 0;            // by what is known
  };
  void judge(Left& left, std::span<const Verdict> verdicts);
  void explain(Left& left, std::span<const Verdict> verdicts, Tally& tally);
  void judge_late(Left& left, Tally& tally);
  void run_stage(const Left& left, std::size_t stage);
  void keep(Left& left);

  const Plan& plan_;
  std::vector<program::Batch> batches_;  // of each stage
  std::vector<program::Batch> sign_;     // one or none
  std::vector<double> values_;           // margins of a stage
  std::vector<double> points_;           // of the poses that are left
  std::vector<double> known_;            // of each
  std::vector<std::uint32_t> numbers_;   // of each
  std::vector<std::uint32_t> places_;    // where those that are left stood
  std::vector<double> late_poses_, signs_;
  const double* others_ = nullptr;
  Left accepted_;
};

// Margins that nothing was refused by so far, of that many.
Tally empty_tally(std::size_t margins, bool reasons);

}  // namespace pmreport::scan
