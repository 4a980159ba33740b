// How an expression of t behaves over a span of time: how finely it must be looked at, and where it may be anything but smooth.
#pragma once

#include <core/scenario/expression/expression.hpp>
#include <vector>

namespace pmreport::scenario {

// A place where a function goes over from one branch to another (abs, min, max, step5, atan2), or where it has no value or no derivative
// (division by zero, the root of zero, the arc sine of one).
struct Switch {
  double before, after;  // times on either side, neighbours as far as numbers tell
  double time() const { return before + 0.5 * (after - before); }
};

struct Behaviour {
  // From the begin to the end, rising. Between two neighbours no sine turns by more than a radian, no exponential grows more than
  // sevenfold, and so on: a handful of points within show all that the expression does.
  std::vector<double> steps;
  std::vector<Switch> switches;  // inside, rising
  bool complete = true;          // false: it wavers or switches more often than can be looked at, and only a part of it was
};
// Of an expression of t alone, begin < end. Two singular places that undo each other within a hundredth of a step may be missed, and
// switches where there are ten thousand places that look like some.
Behaviour behaviour(const Expression& expression, double begin, double end);

}  // namespace pmreport::scenario
