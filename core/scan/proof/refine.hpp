// Boxes are halved, and their halves examined.
#pragma once

#include <core/scan/proof/examiner.hpp>
#include <core/scan/proof/open_boxes.hpp>

#include <limits>

namespace pmreport::scan {

// What is known of the ends of a set along one axis, from boxes that it fills or that it may fill.
struct Ends {
  double least = std::numeric_limits<double>::infinity();           // no pose of the set is lower
  double greatest = -std::numeric_limits<double>::infinity();       // none is higher
  double low_at_most = std::numeric_limits<double>::infinity();     // some pose is no higher than this
  double high_at_least = -std::numeric_limits<double>::infinity();  // some pose is no lower

  void may_hold(program::Bounds side);    // a box that may hold poses of the set
  void has_one_in(program::Bounds side);  // a box that holds one
  void filled(program::Bounds side);      // a box of which every pose belongs to it
  void add(const Ends& more);
};

struct Refined {
  Refined(std::size_t axes, std::size_t margins) : open(axes), ends(axes), examination(margins) {}

  OpenBoxes open;  // in the order of the boxes they came from; sets as examination.sets numbers them
  static constexpr std::uint32_t nowhere = ~std::uint32_t{0};
  std::vector<std::uint32_t> came_from;  // of each of those sets, the set of the first box that has it; no box has it: `nowhere`
  program::Bounds filled{0, 0};          // bounds of the volume of boxes that the set fills
  std::vector<Ends> ends;                // of filled boxes
  std::uint64_t filled_count = 0;
  std::uint64_t boxes = 0;  // examined
  Examination examination;
};

// The boxes of `from` that `which` tells, each halved along all axes of its split.
void refine(const OpenBoxes& from, std::span<const std::uint32_t> which, std::size_t need, const BoxedMargins& margins, Examiner& examiner,
            Refined& out);

// Sums, rounded outward.
program::Bounds sum(std::span<const program::Bounds> terms);
inline program::Bounds sum(program::Bounds a, program::Bounds b) {
  const program::Bounds terms[] = {a, b};
  return sum(terms);
}

}  // namespace pmreport::scan
