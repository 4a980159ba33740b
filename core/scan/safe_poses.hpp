// Boxes and balls of poses that are proved to lie within a set: limits that a controller may be given.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <core/scan/pose_set.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pmreport::scan {

struct SafeOptions {
  std::vector<double> proportions;  // of the scanned coordinates: half widths of the box that is grown first, as a whole
  double accuracy = 1e-3;           // relative: how far a face may stay from where it could not be proved any more
  std::uint64_t boxes = 2'000'000;  // most to look at for one question
};

struct SafeBox {
  bool found = false;
  std::string why;                           // none was
  std::vector<program::Bounds> sides;        // of each point axis
  std::vector<int> low_margin, high_margin;  // what binds each face: a margin, or -1: the scanned range ends there
  std::vector<bool> low_sharp, high_sharp;   // a pose just beyond the face is outside, and that was seen; else the proof ended there
  std::uint64_t boxes = 0;
};
// About `centre`, the values of the point axes: grown as a whole in the proportions until it cannot be, then each face on its own. Proved
// over the whole box and every orientation of the scan; nothing can be moved outward by `accuracy` alone.
SafeBox safe_box(const PoseSet& set, const Scan& scan, const std::vector<double>& centre, const SafeOptions& options,
                 const Watch& watch = {});

// All poses with sum over the axes of ((x - centre) / (radius proportion))^2 <= 1.
struct SafeBall {
  bool found = false;
  std::string why;
  double radius = 0;  // in proportions
  int margin = -1;    // what binds it
  bool sharp = false;
  std::uint64_t boxes = 0;
};
SafeBall safe_ball(const PoseSet& set, const Scan& scan, const std::vector<double>& centre, const SafeOptions& options,
                   const Watch& watch = {});

}  // namespace pmreport::scan
