// Modes that are not isolated. Where the actuators' slopes have lost rank at a mode, three things may be so: two modes have met there, and
// it is a double root; the coordinates alone are singular, as angles are where two of their axes fall together; or the mechanism can be
// moved on with all actuators held, and the mode is one pose of a continuum.
#pragma once

#include <core/mechanics/assembly/assembly.hpp>
#include <core/mechanics/assembly/held_actuators.hpp>

#include <optional>
#include <vector>

namespace pmreport::mechanics {

enum class Root { simple, chart, twofold, continuum };

class ContinuumSearch {
 public:
  explicit ContinuumSearch(const AssemblyTarget& target) : target_(target), held_(target) {}

  // What kind of mode stands at a site where the actuators have their values.
  Root judge(const Site& mode) const;

  // The continuum, of those found before, that holds the mode; its number.
  std::optional<std::size_t> holding(const Site& mode);

  // Enters the continuum that goes through a mode: a curve is followed to its ends, of a family of more dimensions this pose is kept, and
  // those that `holding` joins to it.
  void enter(const Site& mode);

  // All that were entered, with their poses: those of more dimensions whose poses can be joined after all, as one.
  std::vector<ModeContinuum> take();
  std::size_t size() const { return found_.size(); }
  void count_start(std::size_t continuum) { ++found_[continuum].reached_by_starts; }
  int least_starts() const;  // that reached one of the curves

 private:
  using Spot = HeldActuators::Spot;

  bool follow(const Spot& start, SmallVector direction, double bound, std::vector<Spot>& passed, bool& whole) const;
  bool join(std::size_t into, std::size_t from);
  void keep(std::size_t continuum, Spot s, bool in_front);

  const AssemblyTarget& target_;
  HeldActuators held_;
  std::vector<ModeContinuum> found_;
  std::vector<std::vector<Spot>> spots_;  // of each, in the order of its poses
  std::vector<double> bounds_;            // what singular values of the slopes on it may be by rounding
  std::vector<double> joined_;            // how far a pose found on it may be off
};

}  // namespace pmreport::mechanics
