// A mechanism with its actuators held: which way it still moves, if any, and how far.
//
// The measures. All is in numbers: lengths by the mechanism's size, angles in radians. S is the slope of the actuators l by u, v a unit
// vector that S shortens to its smallest singular value s, e what is left of the actuators' error at the mode.
//
// A root is simple, and no other is near, when Newton's method from it is sure to converge (Kantorovich): its first step is at most e / s,
// and the slope along it changes by c a unit way, so that with
//     c (e / s) / s < 1/2,   c = |dS/dv v|                                                                          (1)
// the mode is one root of full rank. A double root that Newton's method came upon from one side has just 1/2 there, so 1/8 is asked for:
//     s > sqrt(8 c e). Where (1) fails the digits do not tell it from a double root; e is at least the rounding at which
// Newton's method stops. The slopes themselves round too: their rounding r is seen by moving u in its last digits, and s > r is asked for
// as well. What fails is singular beyond rounding, and is looked at more closely.
//
// Along v the error of a double root grows with the square of the way, that of a root of order p with its p-th power; on a continuum it
// stays. So the null direction is followed a finite way, each step brought back to the actuator values by least-norm steps: if after a way
// of 0.1 in five steps there is still a pose with these actuator values, away from the first, it is a continuum. The power of a way of 0.1
// is above the 1e-10 that a mode may be off for every order below ten.
//
// The poses of a family of dimension d have d null directions that move the bodies, or more where the family counts twice, as a double root
// does, or where branches cross. So where there are several, each is gone along a little and the poses brought back to the actuator values:
// the secants span the family's directions, and no others. What moves the coordinates but no body, where angles are singular, does not
// count.
#pragma once

#include <core/mechanics/assembly/walk.hpp>

#include <vector>

namespace pmreport::mechanics {

class HeldActuators {
 public:
  explicit HeldActuators(const AssemblyTarget& target) : target_(target) {}

  struct Spot {  // a pose, with what moves when the coordinates do
    bool reached = false;
    std::size_t word = 0;
    SmallVector u, error;        // of the actuators, in numbers
    SmallMatrix slope;           // S
    std::vector<double> bodies;  // origins by the mechanism's size, rotations' elements
    std::vector<double> motion;  // of the bodies by u: D, a row for each of their numbers
    SmallMatrix gram;            // D^T D
    Eigen::MatrixXd ways;        // tangents, where they were asked for and kept
  };
  enum class Step { done, edge, lost };
  static constexpr double stride = 0.02;  // of the way that a continuum must go
  static constexpr double longest = 0.1;  // step

  Spot spot(std::size_t word, const SmallVector& u) const;
  static double apart(const std::vector<double>& a, const std::vector<double>& b);  // of bodies

  // Below it a singular value of the slope may be zero: (1), and the rounding of the slope.
  double rounding(const Spot& s) const;
  // Unit vectors, columns: that the actuators do not feel beyond a bound; those of them that move a body; those in which the family goes
  // on.
  Eigen::MatrixXd null_directions(const Spot& s, double bound) const;
  Eigen::MatrixXd moving(const Spot& s, double bound) const;
  Eigen::MatrixXd tangents(const Spot& s, double bound) const;

  // To the actuator values, by steps of least norm, within a reach. Done: the spot has moved there.
  Step settle(Spot& s, double reach) const;
  // One step of length h along the family; the direction turns with it.
  Step advance(Spot& s, SmallVector& direction, double h, double bound) const;
  // Whether the solutions go on along a null direction.
  bool goes_on(const Spot& s, const SmallVector& direction, double bound) const;
  // Along the family to where the bodies are in a given place, by the way that nears them most. False where that does not lead there.
  bool walk_to(Spot s, const std::vector<double>& bodies, double bound, double tolerance) const;

 private:
  const AssemblyTarget& target_;
};

}  // namespace pmreport::mechanics
