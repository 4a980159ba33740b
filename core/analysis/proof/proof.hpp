// What holds at every instant of a motion, from its first sample to its last, and not at its samples alone: proved by interval arithmetic
// on the recorded geometry (core/program), rounding included. What could not be proved or refuted is told with its times.
#pragma once

#include <core/analysis/column_names.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/program/intervals/bounds.hpp>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pmreport::analysis {

using program::Bounds;

// One statement about the whole motion.
struct Claim {
  enum class About {
    assembled,    // the mechanism can be assembled, and all of its geometry has finite numbers
    stroke,       // of actuator `index`
    joint_limit,  // number `limit` of joint `index`; not where the range bounds nothing
    regular       // det G has one sign, and G is finite: the actuators hold the platform, and no limb loses its actuator
  } about = About::assembled;
  int index = 0, limit = 0;
  Range range{0, 0};  // of stroke and joint_limit, SI

  enum class State {
    holds,      // at every instant
    broken,     // at some instant for certain
    undecided,  // neither is certain
    unexamined  // not looked at, for the `reason`
  } state = State::unexamined;
  std::string reason;  // of unexamined; of a claim that is undecided from some time on, why

  struct Broken {        // a stretch of time in which the limit is left for certain
    Bounds begin, end;   // it begins, and ends, within; where the motion begins or ends with it, exactly there
    bool above = false;  // the upper end of the range is left, else the lower
    Bounds worst;        // the value farthest beyond it; of assembled the reach
    double at = 0;       // a time at which it is in `worst`, nearly
  };
  std::vector<Broken> broken;     // rising
  std::vector<Bounds> undecided;  // times, rising: within each the claim may hold or not; not those that enclose begin or end of `broken`
};

// Where det G is zero, or may be.
struct Meeting {
  enum class What {
    crossing,  // det G has opposite signs before and after
    touch,     // the same sign on both sides: it touches zero, or crosses twice, or comes so near that rounding leaves it open
    unbounded  // G grows beyond all bounds, or may: a limb at the end of its reach
  } what = What::crossing;
  Bounds time;  // it happens within
};

// The least and the largest value of a quantity over all instants.
struct Extreme {
  ColumnId column;
  Bounds least, largest;                // brackets, SI; not bounded where nothing is known
  double at_least = 0, at_largest = 0;  // times at which the brackets' inner ends are taken [s]
};

struct MotionProof {
  std::string unexamined;                                       // why nothing was looked at; empty: it was
  double recording = std::numeric_limits<double>::quiet_NaN();  // how far what was recorded is from what the plugin computes, relative, at
                                                                // samples; NaN: not compared
  double begin = 0, end = 0;                                    // [s]
  int intervals = 0;                                            // of time, that the motion was cut into until each claim was judged
  long evaluations = 0;                                         // of the geometry on an interval
  bool exhausted = false;                                       // the bound on intervals was reached, and some claims are undecided for it
  double resolution = 0;                                        // [s]: how finely begins and ends are told, at best
  std::vector<Claim> claims;                                    // assembled; strokes in order; limits of joints in order; regular
  std::vector<Meeting> meetings;
  std::vector<Extreme> extremes;  // of coordinates and actuators, their rates and accelerations; derived quantities and their rates; joints

  // The bracket of a column's extremes; nullptr: there is none.
  const Extreme* extreme(const ColumnId& column) const;
};

struct ProofOptions {
  int most_intervals = 20000;       // on the whole
  double finest = 1e-7;             // [s]: no interval is halved that is shorter
  double bracket = 1e-6;            // of the range of a coordinate or an actuator, or its rate: how near the ends of its brackets come
  double bracket_of_others = 1e-3;  // the same of joints and derived quantities
  double bracket_of_accelerations = 1e-2;  // the same of accelerations, whose own rates are not followed: theirs come near more slowly
  long most_for_brackets = 10000, most_for_accelerations = 2000;  // evaluations: of values and rates, of accelerations; brackets end there
  // Values that brackets should tell from the extremes of their columns, as far as rounding lets them.
  std::vector<std::pair<ColumnId, double>> decide = {};
};

// Of a motion by coordinates, waypoints or file, by the bounds of its trajectory (`over`); of one by actuators, by those of the actuators,
// along the path that was followed. Not examined, with the reason: a motion by forces, a mechanism without a program.
// `actuators`: of a motion by actuators their bounds over time, else none.
MotionProof prove_motion(const mechanics::Machine& machine, const mechanics::Trajectory& trajectory, const mechanics::Enclosure& actuators,
                         const ProofOptions& options = {});

}  // namespace pmreport::analysis
