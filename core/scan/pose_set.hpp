// A set of poses, by numbers that must not be negative; and what of it is scanned.
#pragma once

#include <core/chunks/work.hpp>
#include <core/program/guided.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace pmreport::scan {

// Numbers of poses that no program gives, such as condition numbers. Input i of pose k is poses[i * count + k]; margin m of it goes to
// out[m * count + k]. Called by several threads at once.
struct LateMargins {
  std::size_t size = 0;
  std::function<void(std::size_t count, const double* poses, double* out)> judge;
  // The last so many must hold at every orientation of a point that all others accept; where they do not, none of it is accepted.
  std::size_t every = 0;
  // The same margins for boxes, where there is such a program; a proof needs it.
  std::optional<program::Guided> over_boxes = {};
};

// The poses whose margins are none negative. Margins stand in the order in which reasons are told; the first is the reach: where it is
// negative, or no number, the pose cannot be assembled, and nothing else is looked at. A margin that is no number elsewhere is negative.
struct PoseSet {
  program::Program margins;      // inputs: the coordinates; output k: margin k
  std::vector<double> rounding;  // of each, and then of each late one: a margin nearer to zero is on its limit, and so accepted
  LateMargins late = {};         // margins behind those of the program

  // Whether intervals can tell all margins: none is left to be judged pose by pose, or at all orientations of a point at once.
  bool provable() const { return late.size == 0 || (late.over_boxes && late.every == 0); }
  std::size_t size() const { return margins.outputs().size() + late.size; }
};

// A coordinate that is scanned. Value k of a grid is from + (to - from) k / (count - 1); of a single one `from`.
struct Axis {
  int input = 0;
  double from = 0, to = 0;
  std::size_t count = 1;  // of a grid; proof and Monte Carlo take the range from the one end to the other

  double value(std::size_t k) const {
    return count < 2 ? from : from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1);
  }
  double step() const { return count < 2 ? 0.0 : (to - from) / static_cast<double>(count - 1); }
};

// Points, and at each point the same orientations. All coordinates that are not scanned have the values of `at`.
struct Scan {
  std::vector<double> at;                              // one an input
  std::vector<Axis> points;                            // the last moves fastest
  std::vector<int> turned = {};                        // inputs that tell an orientation
  std::vector<std::vector<double>> orientations = {};  // values of `turned`, one list each; none: one orientation, that of `at`

  std::size_t point_count() const {
    std::size_t n = 1;
    for (const Axis& a : points) n *= a.count;
    return n;
  }
  std::size_t orientation_count() const { return orientations.empty() ? 1 : orientations.size(); }
  double cell() const {  // of a grid: the product of the steps
    double x = 1;
    for (const Axis& a : points) x *= a.step() < 0 ? -a.step() : a.step();
    return x;
  }
  double range() const {  // the product of the ranges
    double x = 1;
    for (const Axis& a : points) x *= a.to < a.from ? a.from - a.to : a.to - a.from;
    return x;
  }
};

using chunks::Watch;

}  // namespace pmreport::scan
