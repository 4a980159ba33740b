// Inverse dynamics of a state, both ways, as reference cases meet it: actuator forces by virtual work, and by the free bodies with all
// reactions.
#pragma once

#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/reactions/reactions.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/plugin.hpp>

#include <Eigen/Geometry>

namespace pmreport::test {

class Dynamics {
 public:
  Dynamics(const mechanics::Machine& machine, const mechanics::State& state, const mechanics::Loading& loading)
      : machine_(machine), state_(state) {
    REQUIRE(state.status == PM_OK);
    by_virtual_work = mechanics::virtual_work(machine, state, mechanics::tangent(machine, state), loading);
    reactions = mechanics::dense_reactions(machine, state, mechanics::generic_model(machine, state), mechanics::JointFrames(machine),
                                           loading, length());
    REQUIRE_FALSE(reactions.singular);
    CHECK(reactions.residual < tolerance);
  }

  double length() const { return mechanics::characteristic_length(machine_); }
  const mechanics::JointState& joint(const std::string& name) const {
    return state_.joints[static_cast<std::size_t>(joint_named(machine_, name))];
  }
  // What a joint exerts on the named body: force; moment about the joint's centre.
  mechanics::Vector6d on(const std::string& body, const std::string& joint) const {
    const int j = joint_named(machine_, joint);
    const Joint& of = machine_.topology().joints[static_cast<std::size_t>(j)];
    const auto name = [&](int b) { return machine_.topology().bodies[static_cast<std::size_t>(b)].name; };
    const mechanics::Vector6d& wrench = reactions.joints[static_cast<std::size_t>(j)];
    if (name(of.b) == body) return wrench;
    if (name(of.a) == body) return -wrench;
    throw std::out_of_range(joint + " does not touch " + body);
  }
  Eigen::Vector3d force_on(const std::string& body, const std::string& joint) const { return on(body, joint).head<3>(); }
  Eigen::Vector3d moment_on(const std::string& body, const std::string& joint) const { return on(body, joint).tail<3>(); }
  // The limbs' wrenches on the platform about its reference point; limb 1 is number 0.
  std::vector<mechanics::Vector6d> limbs() const { return mechanics::limb_wrenches(machine_, state_, reactions); }

  bool unique(const std::string& joint, int component) const {
    return (reactions.indeterminate[static_cast<std::size_t>(joint_named(machine_, joint))] >> component & 1) == 0;
  }
  bool unique(const std::string& joint) const {
    return reactions.indeterminate[static_cast<std::size_t>(joint_named(machine_, joint))] == 0;
  }

  void check_actuators(const Eigen::VectorXd& expected) const {
    check_equal("actuator forces by virtual work", by_virtual_work.total(), expected);
    check_equal("actuator forces of the free bodies", reactions.actuator_forces, expected);
  }
  // The least norm there is: the reactions are orthogonal to every self-stress, moments counted per characteristic length.
  void check_least_norm() const {
    for (const auto& stress : reactions.stresses) {
      double product = 0, of_stress = 0, of_reactions = 0;
      for (std::size_t j = 0; j < stress.size(); ++j) {
        mechanics::Vector6d s = stress[j], r = reactions.joints[j];
        s.tail<3>() /= length(), r.tail<3>() /= length();
        product += s.dot(r), of_stress += s.squaredNorm(), of_reactions += r.squaredNorm();
      }
      CHECK(std::abs(product) < tolerance * std::sqrt(of_stress * of_reactions));
    }
  }

  mechanics::ForceShares by_virtual_work;
  mechanics::JointReactions reactions;

 private:
  const mechanics::Machine& machine_;
  const mechanics::State& state_;
};

}  // namespace pmreport::test
