// Assembly modes along a motion: how near to the way of the mechanism another mode comes.
#pragma once

#include <core/mechanics/assembly/assembly.hpp>

#include <functional>

namespace pmreport::mechanics {

// The motion, at any time: its pose, from which the actuator values follow. Not PM_OK where there is none.
using PoseAt = std::function<Pose(double t)>;

struct ModeTrack {               // one mode followed through the samples
  std::size_t word = 0;          // of the working mode, where it was first known
  std::vector<double> distance;  // of its pose from the motion's at each sample [m]; NaN where it does not exist
  double begins, ends;           // [s]: when it comes into being and vanishes; the ends of the motion when it exists beyond
  bool born = false, vanishes = false;
};

struct ModeTracks {
  std::vector<ModeTrack> tracks;  // those of `found` but the motion's own, in their order; then those that are born later
  std::vector<double> nearest;    // at each sample: the least of the distances
  double least = 0;               // of all [m]; NaN: there is no other mode
  int least_sample = -1;
  std::size_t least_track = 0;
};

// Follows the modes `found` at sample `start` from sample to sample both ways, by Newton's method, halving the way where it does not
// converge; where a mode leaves reach it is looked for in the next words of the working mode. `later`: samples at which all modes are
// looked for anew, to know those that are born on the way. `length` as in distance().
ModeTracks follow_assembly_modes(const AssemblyModes& found, const std::vector<double>& times, const PoseAt& motion, int start,
                                 const std::vector<int>& later, double length, const AssemblyOptions& options);

}  // namespace pmreport::mechanics
