// Curves through points, with exact rates and accelerations.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <core/scenario/motion/whole_pieces.hpp>
#include <pmreport/jet.hpp>
#include <vector>

namespace pmreport::scenario {

enum class Ends {
  at_rest,     // zero rate at both ends
  not_a_knot,  // the first two pieces are one cubic, and the last two: what best continues measured points
};

// The cubic spline through the points: twice continuously differentiable. At least two points, times strictly increasing.
class CubicSpline {
 public:
  CubicSpline(std::vector<double> times, std::vector<double> values, Ends ends);
  Jet<double> at(double t) const;  // beyond the ends the outer piece goes on
  // The same at every instant of a span, of the curve as its stored numbers make it, rounding included; at a point that of both pieces.
  Jet<program::Bounds> over(program::Bounds time) const;

  // How far it goes at most beyond both points of a piece, and when; nothing where it goes from point to point without a detour.
  struct Overshoot {
    double beyond = 0, time = 0;
  };
  Overshoot overshoot() const;

 private:
  std::vector<double> times_, values_;
  std::vector<double> bends_;  // second derivative at each point
  WholePieces whole_;
};

// From point to point by quintics that start and end at rest: zero rate and acceleration at every point.
class QuinticSteps {
 public:
  QuinticSteps(std::vector<double> times, std::vector<double> values) : times_(std::move(times)), values_(std::move(values)) {}
  Jet<double> at(double t) const;  // beyond the ends the outer point stays
  Jet<program::Bounds> over(program::Bounds time) const;

 private:
  std::vector<double> times_, values_;
  WholePieces whole_;
};

}  // namespace pmreport::scenario
