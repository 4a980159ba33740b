// A mechanism under given forces, at one instant: how it accelerates.
#pragma once

#include <core/mechanics/forward_dynamics/forward_problem.hpp>
#include <core/mechanics/model/outcome.hpp>

#include <stdexcept>

namespace pmreport::mechanics {

// Why there is no acceleration: an obstacle to the motion, not an error of the program.
struct NoMotion : std::runtime_error {
  NoMotion(Outcome outcome, const std::string& why) : std::runtime_error(why), outcome(outcome) {}
  Outcome outcome;  // unreachable, or failed
};

// Keeps its buffers: make one a thread.
class ForcedMotion {
 public:
  // Both must live as long.
  ForcedMotion(const Machine& machine, const ForwardProblem& problem);

  // Accelerations, and the power of actuators and load [W]. Throws NoMotion, or MechanismError when the plugin breaks.
  struct Answer {
    SmallVector acceleration;
    double power = 0;
  };
  Answer at(double t, const SmallVector& q, const SmallVector& rate);

  // Kinetic and potential [J]. Throws likewise.
  struct Energy {
    double kinetic = 0, potential = 0;
    double total() const { return kinetic + potential; }
  };
  Energy energy(const SmallVector& q, const SmallVector& rate);

  std::size_t evaluations() const { return evaluations_; }

 private:
  void place(const SmallVector& q, const SmallVector& rate);

  const Machine& machine_;
  const ForwardProblem& problem_;
  State state_;
  SmallVector none_;  // accelerations
  SmallVector forces_;
  std::size_t evaluations_ = 0;
};

}  // namespace pmreport::mechanics
