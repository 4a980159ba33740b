// One mode, followed in time.
#pragma once

#include <core/mechanics/assembly/follow.hpp>
#include <core/mechanics/displacement/displacement.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace pmreport::mechanics {

struct ModePlace {
  std::size_t word = 0;
  SmallVector q;
  Pose pose;
};

class ModeFollower {
 public:
  ModeFollower(const std::vector<WorkingMode>& words, const std::vector<double>& times, const PoseAt& motion, double length);

  static constexpr double same = 1e-5;  // of the characteristic length: two modes that are one

  const Pose& pose(int sample) const { return poses_[static_cast<std::size_t>(sample)]; }  // of the motion
  int samples() const { return static_cast<int>(times_.size()); }
  SmallVector actuators(const Pose& pose) const;
  double apart(const Pose& a, const Pose& b) const;
  bool one(const Pose& a, const Pose& b) const;
  bool is_own(const Pose& p, int sample) const { return one(p, pose(sample)); }

  // Where a mode is at each sample.
  using Places = std::vector<std::optional<ModePlace>>;

  // The end of a track in one direction, and the mode beyond the fold where there is one.
  struct Stop {
    ModeEnd end;
    int sample = 0;                    // the last at which the mode is
    std::optional<ModePlace> partner;  // at that sample
    ModePlace last;                    // of the mode, at the time of its end
  };
  // From a sample on, forwards or backwards; fills where the mode is. Ends where it comes upon a mode of `others`: then they have met, and
  // cannot be told apart from there on.
  Stop run(ModePlace place, int sample, int direction, Places& places, const std::vector<Places>& others);

  // Whether another mode, at a sample, is about in the same place at the time of an end: where more than two meet, none is beyond a fold.
  bool near_at(const Stop& stop, const std::optional<ModePlace>& other);

  // A mode at the actuator values of a sample, by Newton's method from a place that may be far.
  std::optional<ModePlace> from_afar(const ModePlace& from, int sample);

 private:
  bool step(ModePlace& place, double& t, double to);
  bool neighbours(std::size_t a, std::size_t b) const;
  std::optional<ModePlace> solve(const ModePlace& from, const SmallVector& actuators, std::size_t word, double reach);
  std::optional<ModePlace> beyond_the_fold(const ModePlace& place, double t);
  bool leaves_reach(const ModePlace& place, double t, double to);
  SmallMatrix slope(std::size_t word, const SmallVector& u) const;
  double meeting_time(ModePlace a, std::optional<ModePlace> b, double from, double to);

  const std::vector<WorkingMode>& words_;
  const std::vector<double>& times_;
  const PoseAt& motion_;
  double length_;
  SmallVector scale_;  // of the coordinates: characteristic length, or 1 rad
  std::vector<std::unique_ptr<ForwardSolver>> solvers_;
  std::vector<Pose> poses_;
};

}  // namespace pmreport::mechanics
