// Assembly modes along a motion: how near to the way of the mechanism another mode comes, and where modes come into being and vanish.
#pragma once

#include <core/mechanics/assembly/assembly.hpp>

#include <functional>
#include <limits>
#include <vector>

namespace pmreport::mechanics {

// The motion, at any time: its pose, from which the actuator values follow. Not PM_OK where there is none.
using PoseAt = std::function<Pose(double t)>;

constexpr std::size_t no_track = std::numeric_limits<std::size_t>::max(), own_mode = no_track - 1;  // beside the numbers of tracks

// How a mode begins or ends on the way, and when.
struct ModeEnd {
  enum class How {
    beyond,  // it does not: the motion ends before, has no pose on, or another track goes on with it
    meets,   // another mode, on a singular surface
    reach,   // at the end of reach
    lost     // by no way that is known: it cannot be followed any further
  } how = How::beyond;
  double time = 0;              // [s]
  std::size_t with = no_track;  // the track that it meets, or own_mode; no_track: one that exists for less than a sample
};

struct ModeTrack {               // one mode followed through the samples
  std::size_t word = 0;          // of the working mode, where it was first known
  std::vector<double> distance;  // of its pose from the motion's at each sample [m]; NaN where it does not exist
  ModeEnd begins, ends;
};

struct ModeEvent {  // modes that come into being, or vanish, at one time
  double time = 0;  // [s]
  bool birth = false;
  ModeEnd::How how = ModeEnd::How::lost;
  std::size_t track = 0, with = no_track;  // as in ModeEnd
};

// Samples at which all modes are looked for.
struct LookedAt {
  int sample = 0;
  AssemblyOptions options;
};

struct ModeTracks {
  std::vector<ModeTrack> tracks;      // those of `found` but the motion's own, in their order; then those found later
  std::vector<std::size_t> of_found;  // of each mode of `found` its track, or own_mode
  std::vector<ModeEvent> events;      // by time
  std::vector<int> count;             // at each sample, with the motion's own; 0 where the motion has no pose
  std::vector<double> nearest;        // at each sample: the least of the distances
  double least = 0;                   // of all [m]; NaN: there is no other mode
  int least_sample = -1;
  std::size_t least_track = 0;
  std::vector<int> searched;  // samples at which the whole space was searched, the first that of `found`, and those with the same actuators
  std::vector<int> continua;  // of these, samples at which modes are not isolated: continua are not followed
  int further = 0;            // modes that no search had found where it looked, but that following or another search led to
};

// Follows the modes `found` at sample `start` from sample to sample both ways, by Newton's method, halving the way where it does not
// converge; where a mode leaves reach it is looked for in the next words of the working mode. Where it ends at a singular surface its
// partner is looked for on the other side of the fold, and followed as well. At the samples `looked` all modes are searched anew; what is
// found at one of them is taken on to all others, both by following it and as a start for Newton's method there, until nothing is new.
// Samples with the same actuator values have the same modes, and are searched once. `length` as in distance().
ModeTracks follow_assembly_modes(const AssemblyModes& found, const std::vector<double>& times, const PoseAt& motion, int start,
                                 const std::vector<LookedAt>& looked, double length);

}  // namespace pmreport::mechanics
