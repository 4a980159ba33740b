// What the joints carry along a motion.
#pragma once

#include <core/analysis/analysis.hpp>
#include <core/mechanics/mobility/mobility.hpp>

#include <Eigen/Core>
#include <vector>

namespace pmreport::analysis {

// What one joint carries over the motion.
struct JointLoad {
  struct Size {  // of the force, or of the moment about the joint's centre
    double peak = 0, rms = 0;
    int sample = -1;  // of the peak; -1: the joint carries none
  };
  Size force, moment;  // [N], [N m]
  // Mean direction of the force, unit, joint axes, and the half-angle [rad] of the smallest cone about it that holds every force. Where the
  // cone would be wider than a half space the force reverses: the line that the forces keep to, and the half-angle of the double cone.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double cone = 0;
  bool reverses = false;
  // Components, in joint axes, that the joint transmits; bits 0-5: those that nothing determines, and those that rigid bodies leave open
  // and elasticity determines.
  Indeterminate doubtful = 0, elastic = 0;
  bool doubtful_force() const { return (doubtful & 7) != 0; }
  bool doubtful_moment() const { return (doubtful & 56) != 0; }
};
// Of every joint of the topology. What is below 1e-9 of the largest force, or moment, of any joint counts as none.
std::vector<JointLoad> joint_loads(const Analysis& a);

// Component c of a joint's reaction at a sample, in joint axes; zero where the joint transmits none.
double component(const Analysis& a, const Joint& joint, int c, int sample);

// Forces below this share of a joint's peak have no direction that matters: by the cube of the force, a smaller one has no thousandth of it
// in a bearing's life.
inline constexpr double directionless = 0.1;

// The state of a sample that has a pose.
mechanics::State state_of(const Analysis& a, int sample);
// About `count` samples that have forces, spread evenly over the motion; none: no sample has.
std::vector<int> samples_with_forces(const Analysis& a, int count);

// A self-stress as wrenches on body b of every joint about its centre, as mechanics::JointReactions has them.
std::vector<mechanics::Vector6d> at_joints(const mechanics::State& state, const mechanics::SelfStress& stress);

}  // namespace pmreport::analysis
