// The forces in motion of samples, a chunk at a time: every output number, and the residuals that prove them.
#pragma once

#include <core/analysis/force_columns.hpp>
#include <core/analysis/sample_work.hpp>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/reactions/inverse_dynamics.hpp>

#include <span>
#include <vector>

namespace pmreport::analysis {

// Each thread has its own, with the buffers it reuses.
class SampleForces {
 public:
  // `length`: characteristic length [m].
  SampleForces(const scenario::Scenario& s, const mechanics::Machine& m, const mechanics::JointFrames& frames, double length,
               const ForceColumns& columns);

  struct Order {
    int sample;     // one with a pose that is not singular
    bool compared;  // far enough from singular poses for two ways to the forces to be compared
    bool judged;    // by the system over all bodies as well
  };
  // `rows`: of all samples.
  void run(std::span<const Order> orders, std::vector<Row>& rows);

  // Over all samples so far.
  const std::vector<Indeterminate>& indeterminate() const { return indeterminate_; }
  int self_stresses() const { return self_stresses_; }

 private:
  void solve(std::span<const Order> orders);
  bool take(std::size_t k, std::size_t count);  // pose k of the chunk: its reactions; false where it has none
  void put_actuators(std::size_t sample, const mechanics::ForceShares& shares, const mechanics::SmallVector& total);
  void put_drives(std::size_t sample, const mechanics::Tangent& tangent, const mechanics::SmallVector& total);
  void put_reactions(std::size_t sample);
  double judge() const;

  const scenario::Scenario& scenario_;
  const mechanics::Machine& machine_;
  const mechanics::JointFrames& frames_;
  double length_;
  const ForceColumns& columns_;
  mechanics::InverseDynamics dynamics_;
  std::vector<double> jets_, loads_;
  mechanics::MotionReactions chunk_;
  mechanics::State state_;
  mechanics::Loading loading_;
  mechanics::JointReactions reactions_;
  std::vector<Indeterminate> indeterminate_;
  int self_stresses_ = 0;
};

}  // namespace pmreport::analysis
