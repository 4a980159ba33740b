// Section `speed`, and its parts.
#pragma once

#include <core/mechanics/dynamics/speed.hpp>
#include <reports/section/kind.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

Result speed_section(const Analysis& a);

// With four digits, rounded so that a motion of the speed, or the duration, that a reader takes from it keeps the limit.
std::string speed_words(double scale);       // down: "1.643"
std::string duration_words(double seconds);  // up: "1.218 s"

// The motion of a scenario at any speed: what it asks for, and how fast it may run.
class SpeedStudy {
 public:
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

  std::string subject(const mechanics::SpeedLimit& l) const;        // "torque of θ₁ (angle of arm 1)", "force in joint B1"
  std::string brief_subject(const mechanics::SpeedLimit& l) const;  // "torque of θ₁", for a table
  std::string unit(const mechanics::SpeedLimit& l) const;           // SI
  double bound(const mechanics::SpeedLimit& l) const;
  // The limited number, with its sign where it has one, at each sample of the motion run `s` times as fast.
  std::vector<double> demand(const mechanics::SpeedLimit& l, double s) const;

  figure::Figure phase_plane() const;
  figure::Figure at_scale() const;  // what is limited, at the largest speed, against its limits
  // By inverse dynamics anew, with s times the rates and s^2 times the accelerations: nothing of the split into rest and inertia.
  std::vector<document::Evidence> evidence() const;

 private:
  double asked_anew(const mechanics::SpeedLimit& l, int sample, double s) const;  // magnitude over its limit

  const Analysis& a_;
  mechanics::MotionForces forces_;
  mechanics::FeasibleSpeed feasible_;
};

}  // namespace pmreport::section
