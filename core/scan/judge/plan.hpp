// How the poses of a scan are judged: the program in two, what an orientation decides and what a point does, and margins in stages.
#pragma once

#include <core/program/program.hpp>
#include <core/scan/pose_set.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pmreport::scan {

// Margins that are looked at together; what refuses most for its cost comes first, so that few poses are left for what costs much.
struct Stage {
  std::vector<int> margins;   // of the program, ascending
  program::Program program;   // their slice of the inner program
  std::vector<double> slack;  // their rounding
};

// Keeps what it was made from: the set and the scan must outlive it. Throws std::invalid_argument with a sentence: a scan that does not fit
// the set.
struct Plan {
  // With reasons margins keep their order from stage to stage, the reach alone in the first. `sign`: may be none.
  Plan(const PoseSet& set, const Scan& scan, bool reasons, const program::Program* sign);

  const PoseSet& set;
  const Scan& scan;
  bool reasons;
  std::size_t margins;             // of the program
  std::uint64_t point_inputs = 0;  // one bit each
  std::vector<std::size_t> slots;  // of each point axis: its place among the inputs that points move, by their numbers
  program::Program outer;          // of the coordinates: numbers that are handed over, none of which depends on a point
  program::Program inner;          // of the coordinates, then what was handed over: margins, then the sign
  program::Program sign;           // its slice of the inner program; of nothing where none is asked for
  std::vector<Stage> stages;
  std::vector<int> stage_of;  // of each margin of the program
  // How much margins change over the whole of each point axis, and then over all orientations: what is halved first where blocks of poses
  // are judged as one. Only ratios count.
  std::vector<double> weights;

  // Of an input that points move.
  std::size_t slot_of(int input) const { return static_cast<std::size_t>(std::popcount(point_inputs & ((std::uint64_t{1} << input) - 1))); }
  std::size_t width() const { return static_cast<std::size_t>(inner.inputs()); }
};

}  // namespace pmreport::scan
