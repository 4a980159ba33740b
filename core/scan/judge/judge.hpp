// Judges poses, many at a time.
#pragma once

#include <core/program/batch.hpp>
#include <core/scan/judge/plan.hpp>
#include <core/scan/tally.hpp>

#include <tbb/cache_aligned_allocator.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace pmreport::scan {

// On the borders of cache lines: a vector across one costs twice.
using Numbers = std::vector<double, tbb::cache_aligned_allocator<double>>;

// What is known beforehand of a margin at all poses of a block.
enum class MarginVerdict : std::uint8_t { open, kept, refused };

// Poses that were accepted, in no order that means anything.
struct Accepted {
  std::span<const std::uint32_t> places, turns;  // as they were given to the judge
  // is_on_a_limit or is_kept (kernel.hpp); is_refused: only by a margin that must hold at every orientation of a point.
  std::span<const double> known;
  std::span<const double> signs;  // of the plan's sign program; empty where there is none
};

// Points that are judged at one orientation after the other. Point k has the value values[s * stride + k] of the input in slot s
// (Plan::slots). The stride is a multiple of `lanes`, and what stands behind the last point is some point too.
struct PointBlock {
  std::size_t count = 0, stride = 0;
  Numbers values;
  std::vector<std::uint32_t> places;  // by which an accepted pose is told

  static constexpr std::size_t lanes = 8;
  static std::size_t stride_of(std::size_t count) { return (count + lanes - 1) / lanes * lanes; }
  void resize(std::size_t points, std::size_t slots);
  void fill_up();  // behind the last point
};

// Poses of one block and orientation share what the orientation decides, and go through the stages together as long as many are left. The
// few of them that go on wait until there are many, of whatever orientation, for a stage costs as much for ten as for one.
//
// A margin that is nearer to zero than its rounding counts as kept; an accepted pose with such a margin is on a limit, since the margin the
// other way would refuse it. A refused pose is refused by a margin that is beyond its rounding, whatever else is on a limit.
class Judge {
 public:
  // `accepted` is told of accepted poses now and then, of the last in `finish`. Keeps its buffers: one a thread.
  Judge(const Plan& plan, std::function<void(const Accepted&)> accepted);

  // Of the blocks to come. One a margin of the program, and what they say is true; none: all open.
  void set(std::span<const MarginVerdict> verdicts);
  // `others`: all inputs of the plan's inner program, of which those that points move are not looked at; must stand until `finish`. What
  // is counted, but how many poses there are, is added to the tally.
  void run(const PointBlock& points, const double* others, std::uint32_t turn, Tally& tally);
  // All that wait.
  void finish(Tally& tally);
  // What waits is not looked at any more: whoever gave it has given up.
  void forget();

 private:
  // Poses that nothing refused so far.
  struct Left {
    const double* points = nullptr;  // slot after slot
    std::size_t count = 0, stride = 0;
    std::size_t left = 0;  // by what is known, where the last stage refused some
  };
  // Poses before a stage, of any orientation.
  struct Waiting {
    std::size_t count = 0;
    Numbers points;  // slot after slot, `most` each
    std::vector<const double*> others;
    std::vector<std::uint32_t> places, turns;
    Numbers known;
    std::vector<std::uint64_t> open;  // stages: a bit each
  };
  static constexpr std::size_t most = 1024;  // that wait before one stage

  void judge(Left& left, std::uint32_t turn, Tally& tally);
  void explain(Left& left, Tally& tally);
  void keep(Left& left);
  void run_stage(const Left& left, std::size_t stage);
  std::size_t next(std::size_t stage, std::uint64_t open) const;
  void wait(std::size_t stage, const Left& left, std::uint32_t turn, Tally& tally);
  void pass_on(std::size_t stage, const Waiting& from, std::size_t k, Tally& tally);
  void drain(std::size_t stage, Tally& tally);
  void drain_late(Tally& tally);
  void accept(Tally& tally);
  void gather(const Waiting& w, std::size_t stride, std::span<const int> inputs);

  const Plan& plan_;
  const std::function<void(const Accepted&)> accepted_;
  std::vector<program::Batch> hoisted_;      // of each stage, at one orientation
  std::vector<program::Batch> loose_;        // of each stage, and then of the sign
  std::vector<std::vector<int>> inputs_of_;  // of each of these: what it reads
  std::vector<MarginVerdict> verdicts_;
  std::uint64_t open_ = 0;              // stages
  Numbers values_;                      // margins of a stage
  Numbers points_, known_;              // of the poses that are left
  std::vector<std::uint32_t> numbers_;  // of each, within its block
  std::vector<std::uint32_t> stood_;    // where those that are left stood
  std::vector<Waiting> waiting_;        // before each stage, before the late margins, and accepted ones
  Numbers in_, by_others_;
  std::vector<double> signs_;
  const double* others_ = nullptr;
  const PointBlock* block_ = nullptr;
};

// Margins that nothing was refused by so far, of that many.
Tally empty_tally(std::size_t margins, bool reasons);

}  // namespace pmreport::scan
