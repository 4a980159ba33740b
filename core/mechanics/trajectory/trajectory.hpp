// A motion that was solved: where the independent coordinates are at every sample, and between the samples.
#pragma once

#include <Eigen/Core>
#include <core/program/intervals/bounds.hpp>
#include <functional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

// Coordinates, or actuators, at a time [s], with their rates and accelerations, each dof long, SI. False where there are none.
using Path = std::function<bool(double t, double* value, double* rate, double* acceleration)>;

// Coordinates, or actuators, over a span of time [s]: bounds that hold at every instant of it, rounding included. dof long, SI. Where a
// value jumps within, or at an end, both sides are in, and the rate is not bounded; nor is the acceleration where the rate jumps: what is
// bounded is the derivative of what stands before it at every instant. False where nothing is known.
struct Bounded {
  program::Bounds value, rate, acceleration;
};
using Enclosure = std::function<bool(program::Bounds time, Bounded* out)>;

// A prescribed motion that is not smooth: the lowest of its derivatives that jumps at a time.
struct Break {
  enum class Of { value, rate, acceleration } of = Of::value;
  std::string what, unit;  // the coordinate or actuator that is prescribed, "x", and its own unit, SI
  double time = 0;         // [s]
  double jump = 0;         // its size, SI
};

struct Trajectory {
  std::vector<double> time;                   // [s], rising; empty: there is no motion
  Eigen::MatrixXd value, rate, acceleration;  // one row a sample, one column an independent coordinate, SI; NaN: no pose
  Path at;         // the same at any time from the first sample to the last; safe in threads. The machine that it was solved for must live
  Enclosure over;  // of prescribed coordinates: the same over spans of time; safe in threads. Else none
  // Of a prescribed motion, inside it, rising: times at which a derivative may jump, however high, and the breaks among them.
  std::vector<double> knots;
  std::vector<Break> breaks;
  std::string ending;  // why it ends before it should: "meets a singular surface at t = 3.314 s: ..."; empty: it does not
  // Of a motion under given forces.
  double work = 0;                // of actuators and load, to the last sample with a pose [J]
  double energy_drift = 0;        // energy that the integration lost or gained [J]
  double energy_drift_share = 0;  // the same, relative to the largest energy or work on the way

  int samples() const { return static_cast<int>(time.size()); }
  bool reaches(int sample) const { return value.row(sample).allFinite(); }  // it has a pose there; whether it can be assembled, is another
};

// Keeps the first samples, and of knots and breaks those before the last of them.
void cut_off(Trajectory& trajectory, std::size_t samples);

// A path known beforehand, at these times. What is not finite stays so: the caller judges.
Trajectory sampled(Path path, std::vector<double> times, int dof);

}  // namespace pmreport::mechanics
