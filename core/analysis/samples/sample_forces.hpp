// The forces in motion of samples, a chunk at a time: every output number, and the residuals that prove them.
#pragma once

#include <core/analysis/residuals.hpp>
#include <core/analysis/samples/force_columns.hpp>
#include <core/analysis/samples/reaction_findings.hpp>
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
               const mechanics::Machine& m, const mechanics::JointFrames& frames, double length, bool evidence);

  struct Order {
    int sample;     // one with a pose that is not singular
    bool compared;  // far enough from singular poses for two ways to the forces to be compared
    bool judged;    // by the system over all bodies as well
  };
  struct Into {  // where their numbers go
    const ForceColumns& columns;
    std::vector<Row>& rows;
    int first;  // the sample that columns and rows begin with
  };
  ReactionFindings run(std::span<const Order> orders, const Into& into);

 private:
  void solve(std::span<const Order> orders);
  bool take(std::size_t k, std::size_t count);  // pose k of the chunk: its reactions; false where it has none
  // Row k of the columns.
  void put_actuators(const ForceColumns& to, std::size_t k, const mechanics::ForceShares& shares, const mechanics::SmallVector& total);
  void put_drives(const ForceColumns& to, std::size_t k, const mechanics::Tangent& tangent, const mechanics::SmallVector& total);
  void put_reactions(const ForceColumns& to, std::size_t k);
  void prove(const Order& order, const mechanics::ForceShares& shares, const mechanics::SmallVector& total, Row& row) const;
  double judge() const;
  void settle(std::size_t k, std::size_t count, int sample);  // pose k of the chunk, by elasticity

  const mechanics::Trajectory& trajectory_;
  const scenario::Load& load_;
  const std::vector<mechanics::DriveTrain>& drives_;
  const mechanics::Machine& machine_;
  const mechanics::JointFrames& frames_;
  double length_;
  bool evidence_;
  mechanics::InverseDynamics dynamics_;
  std::vector<double> jets_, loads_;
  mechanics::MotionReactions chunk_;
  mechanics::State state_;
  mechanics::Loading loading_;
  mechanics::JointReactions reactions_;
  mechanics::ElasticSplit split_;
  std::vector<mechanics::Vector6d> least_norm_;  // of the joints, before elasticity
  ReactionFindings found_;
};

}  // namespace pmreport::analysis
