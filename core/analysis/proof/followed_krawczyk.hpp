// Interval Newton, in Krawczyk's form, on coordinates that follow prescribed actuators over a span of time.
//
// Over the span T, c within it, coordinates are written in a moving frame (followed_frame.hpp),
//     q = q_c + v (t - c) + d,   F(d, t) = l(q) - l*(t),   Y = J(q_c)^-1, nearly.
// For d in a box D that holds 0, at an instant t, there is a J~ within the bounds of J over the box X of all such q for which
//     F(d, t) = F(0, t) + J~ d                                                                     (1)
// by the mean value theorem, row by row; so a d with F(d, t) = 0 is d = -Y F(0, t) + (I - Y J~) d, and lies in
//     K(D) = -Y F(0, T) + (I - Y J(X)) D.                                                          (2)
// If K(D) lies in the interior of D, then Y and every matrix in J(X) are regular, and for every t in T there is exactly one d in D with
// F(d, t) = 0 (Krawczyk 1969; Neumaier, Interval Methods for Systems of Equations, 1990, 5.1; Moore, Kearfott and Cloud, Introduction to
// Interval Analysis, 2009, 8.1). As l and l* are continuous and it is the only one in a closed box, it moves without a jump. Conversely
// what is known to lie in D lies in K(D) too, which needs no test. Where J jumps, as that of min, max and abs does, its bounds hold both
// sides, and (1) is the mean value theorem of Lipschitz functions. Frame and shape of D are free: they decide what can be proved, never
// what is. F(0, T) is of second order in the span by the mean value theorem in time,
//     F(0, t) = F(0, c) + (J~ v - l*'(t~)) (t - c),   J~ in J(X),                                  (3)
// because v = Y l*'(c), nearly. Where l*' does not jump, and J neither, it is four times smaller by Taylor's theorem,
//     F(0, t) = F(0, c) + (J(q_c) v - l*'(c)) (t - c) + (J'~ v - l*''(t~)) (t - c)^2 / 2.          (4)
//
// Rates and accelerations are the solutions of
//     J q' = l*',   J q'' = l*'' - J' q'                                                           (5)
// with every matrix in J(X). J' q' is the acceleration of l along (q, q', 0), exactly. Of x with J x = b and x = x0 + y, x0 nearly right,
//     y = z + R y,   z = Y (b - J x0),   R = I - Y J(X),                                           (6)
// and when the rows of |R| sum to rho < 1 then |y| <= max|z| / (1 - rho), in units of the coordinates, from where (6) is run again. What
// follows of (5) is of first order in the span, more than the rates and accelerations vary themselves; that of
//     q'(t) = q'(c) + q''(t~) (t - c),   q(t) = q(c) + q'(t~) (t - c)                              (7)
// exceeds it by the second order. Rates that jump at an instant are not to be found by (7): neither l*' nor J jumps then.
//
// J(X) itself is sharpest where what it changes by along the path is told apart from what the box does to it,
//     J(X) in J(q_c + D) + J'(X) (t - c),   J' along (q, v),                                       (8)
// where J has no kink in X: near a singular surface Y is large, and Y J' is what there is of it, while Y J(X) is the sum of all its parts.
#pragma once

#include <core/analysis/proof/followed_frame.hpp>
#include <core/program/intervals/bounds.hpp>

#include <array>
#include <memory>

namespace pmreport::analysis {

using program::Bounds;

// Bounds of d, as many as coordinates.
using Offsets = std::array<Bounds, 6>;
// Of coordinates that move with a frame: where they are.
struct MovingBox {
  MovingFrame frame;
  Offsets offsets;
};

class Krawczyk {
 public:
  // Both must outlive it. Keeps its buffers: one a thread. All functions round upward within and give back the mode that they found.
  Krawczyk(const ActuatorGeometry& geometry, const SmallVector& sizes);
  ~Krawczyk();

  // The actuators, dof of them each: over the span, and at the frame's middle; `steady`: their rates do not jump meanwhile.
  struct Prescribed {
    const mechanics::Bounded *over, *at_middle;
    bool steady = false;
  };
  enum class Found {
    one,        // exactly one solution at every instant
    no_bounds,  // the geometry or its partials have none there, or it jumps
    undecided   // K(D) is not in the interior of D, of whatever size
  };
  // Looks for a box of offsets, `include` in it, with exactly one solution at every instant of `time`: `only`; `within`: where in it the
  // solution is. `rounds`: how often the box was made larger.
  Found find(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, const Offsets& include, Offsets& only, Offsets& within,
             int& rounds);

  // Makes the offsets that a solution is known to have smaller. False: nothing is known of the geometry there, or there is no solution
  // after all, which bounds of the actuators that contradict one another lead to.
  bool contract(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, Offsets& within);

  // Coordinates, rates and accelerations of the solution `within`. False where rates have no bounds.
  bool enclose(const MovingFrame& frame, Bounds time, const Prescribed& prescribed, const Offsets& within, mechanics::Bounded* out);

  // The offsets that all of `box` has in another frame during `time`.
  static Offsets seen_from(const MovingFrame& frame, Bounds time, const MovingBox& box);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace pmreport::analysis
