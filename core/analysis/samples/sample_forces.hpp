// The forces in motion of samples, a chunk at a time: every output number, and the residuals that prove them.
#pragma once

#include <core/analysis/residuals.hpp>
#include <core/analysis/samples/elastic_reactions.hpp>
#include <core/analysis/samples/force_columns.hpp>
#include <core/mechanics/dynamics/drive.hpp>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/reactions/inverse_dynamics.hpp>
#include <core/mechanics/reactions/reactions.hpp>
#include <core/mechanics/stiffness/elastic_split.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/scenario/load.hpp>

#include <span>
#include <vector>

namespace pmreport::analysis {

// Each thread has its own, with the buffers it reuses.
class SampleForces {
 public:
  // `drives`: one an actuator, where they have columns; `length`: characteristic length [m]; `evidence`: with residuals.
  SampleForces(const mechanics::Trajectory& trajectory, const scenario::Load& load, const std::vector<mechanics::DriveTrain>& drives,
               const mechanics::Machine& m, const mechanics::JointFrames& frames, double length, const ForceColumns& columns,
               bool evidence);

  struct Order {
    int sample;     // one with a pose that is not singular
    bool compared;  // far enough from singular poses for two ways to the forces to be compared
    bool judged;    // by the system over all bodies as well
  };
  // `residuals`: of all samples.
  void run(std::span<const Order> orders, Residuals& residuals);

  // Over all samples so far.
  const std::vector<mechanics::Indeterminate>& indeterminate() const { return indeterminate_; }
  int self_stresses() const { return self_stresses_; }
  const ElasticReactions& elastic() const { return elastic_; }

 private:
  void solve(std::span<const Order> orders);
  bool take(std::size_t k, std::size_t count);  // pose k of the chunk: its reactions; false where it has none
  void put_actuators(std::size_t sample, const mechanics::ForceShares& shares, const mechanics::SmallVector& total);
  void put_drives(std::size_t sample, const mechanics::Tangent& tangent, const mechanics::SmallVector& total);
  void put_reactions(std::size_t sample);
  void prove(const Order& order, const mechanics::ForceShares& shares, const mechanics::SmallVector& total, Row& row) const;
  double judge() const;
  void settle(std::size_t k, std::size_t count, std::size_t sample);  // pose k of the chunk, by elasticity

  const mechanics::Trajectory& trajectory_;
  const scenario::Load& load_;
  const std::vector<mechanics::DriveTrain>& drives_;
  const mechanics::Machine& machine_;
  const mechanics::JointFrames& frames_;
  double length_;
  const ForceColumns& columns_;
  bool evidence_;
  mechanics::InverseDynamics dynamics_;
  std::vector<double> jets_, loads_;
  mechanics::MotionReactions chunk_;
  mechanics::State state_;
  mechanics::Loading loading_;
  mechanics::JointReactions reactions_;
  std::vector<mechanics::Indeterminate> indeterminate_;
  int self_stresses_ = 0;
  mechanics::ElasticSplit split_;
  std::vector<mechanics::Vector6d> least_norm_;  // of the joints, before elasticity
  ElasticReactions elastic_;
};

}  // namespace pmreport::analysis
