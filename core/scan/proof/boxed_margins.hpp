// The margins of a set of poses as programs for boxes of the scanned coordinates.
#pragma once

#include <core/program/guided.hpp>
#include <core/program/intervals/bounds.hpp>
#include <core/program/program.hpp>
#include <core/scan/pose_set.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace pmreport::scan {

// A scanned coordinate that has a range. One whose range is zero is a number like those that are not scanned.
struct FreeAxis {
  std::size_t point_axis = 0;  // of Scan::points
  int input = 0;
  program::Bounds range;  // the lesser end first, whichever way it is scanned
};

class BoxedMargins {
 public:
  // Throws std::invalid_argument: the set is not provable, or the scan has more free axes than `most_axes`.
  BoxedMargins(const PoseSet& set, const Scan& scan);

  const std::vector<FreeAxis>& axes() const { return axes_; }
  // Those of the set, and behind them those of which they are made (apart.hpp).
  std::size_t margins() const { return values_.outputs().size(); }
  int part_of(int margin) const { return part_of_[static_cast<std::size_t>(margin)]; }  // the margin of the set
  std::size_t orientations() const { return fixed_.size(); }

  // Inputs: the coordinates, then the guides of each box, then what does not change within an orientation. Outputs: the margins; and behind
  // them, the derivative of margin m by free axis q at margins + m axes + q.
  const program::Program& values() const { return values_; }
  const program::Program& with_partials() const { return with_partials_; }
  std::size_t coordinates() const { return coordinates_; }
  std::size_t guides() const { return guided_.guides; }
  // Guides of boxes, as program::Guided has them.
  void choose_guides(std::size_t count, const double* middles, double* guides) const { guided_.choose(count, middles, guides); }
  // One an input; of the free ones the whole range, of guides nothing.
  std::span<const program::Bounds> fixed(std::size_t orientation) const { return fixed_[orientation]; }

 private:
  std::vector<FreeAxis> axes_;
  std::size_t coordinates_ = 0;
  program::Guided guided_;
  program::Program values_, with_partials_;
  std::vector<int> part_of_;
  std::vector<std::vector<program::Bounds>> fixed_;  // of each orientation
};

}  // namespace pmreport::scan
