// The motion of a scenario at any speed: what it asks for, and how fast it may run.
#pragma once

#include <core/analysis/analysis.hpp>
#include <core/mechanics/dynamics/speed.hpp>

#include <optional>
#include <vector>

namespace pmreport::analysis {

bool of_joint(const mechanics::SpeedLimit& l);

class SpeedStudy {
 public:
  // The run must have forces in motion, and must live as long.
  explicit SpeedStudy(const Analysis& a);

  const mechanics::FeasibleSpeed& feasible() const { return feasible_; }
  double scale() const { return feasible_.scale; }
  double duration(double scale) const;  // [s]

  // One limit over the motion: its own largest s, and where that is.
  struct Own {
    std::size_t limit;  // index into feasible().limits
    double scale;       // infinite: it never binds
    int sample;         // -1: nowhere
  };
  std::vector<Own> own() const;  // the tightest first

  double bound(const mechanics::SpeedLimit& l) const;  // SI
  // The limited number, with its sign where it has one, at each sample of the motion run `s` times as fast.
  std::vector<double> demand(const mechanics::SpeedLimit& l, double s) const;

  // By inverse dynamics anew, with s times the rates and s^2 times the accelerations: nothing of the split into rest and inertia. Relative
  // to the limits.
  struct Proof {
    double binding;  // deviation of what binds from its limit, where it binds
    double excess;   // largest over its limit of any other at its worst sample
  };
  std::optional<Proof> proof() const;  // nothing where no limit binds at a speed above 0

 private:
  double asked_anew(const mechanics::SpeedLimit& l, int sample, double s) const;  // magnitude over its limit

  const Analysis& a_;
  mechanics::MotionForces forces_;
  mechanics::FeasibleSpeed feasible_;
};

}  // namespace pmreport::analysis
