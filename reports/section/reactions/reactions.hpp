// Section `reactions`, and its parts.
#pragma once

#include <reports/section/kind.hpp>

#include <core/mechanics/mobility/mobility.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pmreport::section {

struct ReactionsOptions : scenario::Options {
  std::vector<int> joints;  // whose reactions are drawn; empty: those with the largest
};

Result reactions_section(const Analysis& a, const ReactionsOptions& request);

// A component, or a joint, whose value is not determined by rigid bodies: the mark beside its least-norm value.
inline constexpr const char* least_norm_mark = "†";

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
  Indeterminate doubtful = 0;  // components, in joint axes, that the joint transmits and rigid bodies do not determine; bits 0-5
  bool doubtful_force() const { return (doubtful & 7) != 0; }
  bool doubtful_moment() const { return (doubtful & 56) != 0; }
};
// Of every joint of the topology. What is below 1e-9 of the largest force, or moment, of any joint counts as none.
std::vector<JointLoad> joint_loads(const Analysis& a);

document::Table bearing_table(const Analysis& a, const std::vector<JointLoad>& loads);
document::Table direction_table(const Analysis& a, const std::vector<JointLoad>& loads);
// The components of each joint at its largest force, and at its largest moment where that is another sample.
document::Table component_table(const Analysis& a, const std::vector<JointLoad>& loads);

// To the fourth digit of `largest`: no bearing is chosen by more, and a component that vanishes beside others reads as zero.
double rounded(double x, double largest);

// The state of a sample that has a pose.
mechanics::State state_of(const Analysis& a, int sample);
// About `count` samples that have forces, spread evenly over the motion; none: no sample has.
std::vector<int> samples_with_forces(const Analysis& a, int count);

// A self-stress as wrenches on body b of every joint about its centre, as mechanics::JointReactions has them.
std::vector<mechanics::Vector6d> at_joints(const mechanics::State& state, const mechanics::SelfStress& stress);

// The wrenches of the limbs on the platform.
class LimbWrenches {
 public:
  LimbWrenches(const Analysis& a, const std::vector<int>& checked);  // `checked`: samples whose self-stresses are looked at

  bool any() const { return !limbs_.empty(); }  // some limb ends at the platform
  figure::Figure figure() const;
  document::Table table() const;
  // The 6 x 6 formula against the free bodies, where they differ: text, then a table. Empty: they agree, or there is no constraint wrench.
  std::vector<document::Block> formula() const;
  document::Evidence platform_in_balance() const;

 private:
  struct Group {             // limbs that hold a constraint wrench, and all that share an actuator with them
    std::vector<int> limbs;  // numbers
    std::vector<int> rows;   // of G: their actuators and the constraint wrenches that they hold
  };
  void judge();  // the formula and the platform's balance, sample by sample
  std::vector<int> carriers(int actuator) const;
  std::vector<Group> groups(int sample) const;
  mechanics::Vector6d bodies(int limb, int sample) const;  // from the columns
  bool doubtful(int limb, int component) const { return doubtful_[static_cast<std::size_t>(limb - 1)] >> component & 1; }

  const Analysis& a_;
  std::vector<int> limbs_;          // numbers of those that end at the platform
  std::vector<unsigned> doubtful_;  // of limb n at [n - 1]: bit c, component c of its wrench on the platform is not determined

  double imbalance_ = std::numeric_limits<double>::quiet_NaN();
  // Where formula and bodies differ most, relative to the largest wrench there.
  Group worst_;
  int worst_sample_ = -1;
  double difference_ = 0;
  mechanics::Vector6d by_formula_ = mechanics::Vector6d::Zero(), by_bodies_ = mechanics::Vector6d::Zero();
  std::vector<std::pair<int, double>> constraints_;  // row of G, value by the formula
};

}  // namespace pmreport::section
