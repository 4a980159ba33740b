#include <core/analysis/study/limb_wrenches.hpp>
#include <core/mechanics/statics/statics.hpp>

#include <core/mechanics/mobility/wrench_system.hpp>
#include <core/mechanics/model/closed_form.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

using Eigen::Index;
using mechanics::Vector6d;

namespace {

double size_of(const Vector6d& w, double length) { return std::max(w.head<3>().norm(), w.tail<3>().norm() / length); }

// Between the platform and a body of no limb.
bool is_beside_limbs(const Topology& t, const Joint& joint) {
  if (joint.a != t.platform && joint.b != t.platform) return false;
  return t.bodies[static_cast<std::size_t>(joint.a == t.platform ? joint.b : joint.a)].limb == 0;
}

// Of the joints that stand between the platform and a body of no limb: what they and their actuators exert on the platform, about its
// reference point.
Vector6d beside_limbs(const Analysis& a, const mechanics::State& state, int sample) {
  const Topology& t = a.machine().topology();
  const auto k = static_cast<std::size_t>(sample);
  Vector6d out = Vector6d::Zero();
  for (std::size_t j = 0; j < t.joints.size(); ++j) {
    const Joint& joint = t.joints[j];
    if (!is_beside_limbs(t, joint)) continue;
    Vector6d w = Vector6d::Zero();
    for (int c = 0; c < (joint.kind == JointKind::spherical ? 3 : 6); ++c) w(c) = a.column(reaction_column(joint, c, true))[k];
    for (const Actuator& x : t.actuators)
      if (x.joint == static_cast<int>(j))
        w.segment<3>(x.sense() == Sense::linear ? 0 : 3) += a.column(column_of(x, OfActuator::dynamic_force))[k] * state.joints[j].axis[0];
    w.tail<3>() += (state.joints[j].centre - state.bodies[static_cast<std::size_t>(t.platform)].origin).cross(w.head<3>());
    out += joint.b == t.platform ? w : Vector6d(-w);
  }
  return out;
}

void take(JointLoad::Size& largest, double x, int sample) {
  if (x > largest.peak || (largest.sample < 0 && std::isfinite(x))) largest.peak = x, largest.sample = sample;
}

}  // namespace

LimbWrenches::LimbWrenches(const Analysis& a, const std::vector<int>& checked) : a_(a) {
  const Topology& t = a.machine().topology();
  for (const Joint& joint : t.joints)
    if (joint.a == t.platform || joint.b == t.platform)
      if (const int limb = t.bodies[static_cast<std::size_t>(joint.a == t.platform ? joint.b : joint.a)].limb; limb > 0)
        limbs_.push_back(limb);
  std::sort(limbs_.begin(), limbs_.end());
  limbs_.erase(std::unique(limbs_.begin(), limbs_.end()), limbs_.end());

  doubtful_.assign(limbs_.empty() ? 0 : static_cast<std::size_t>(limbs_.back()), 0);
  const bool settled = a.elastic_reactions().stresses > 0 && a.elastic_reactions().open == 0;
  for (const int sample : settled ? std::vector<int>{} : checked) {
    const mechanics::State state = state_of(a, sample);
    for (const auto& stress : self_stresses(a.machine(), state, generic_model(a.machine(), state))) {
      mechanics::JointReactions r;
      r.actuator_forces = Eigen::VectorXd::Zero(a.machine().dof());
      r.joints = at_joints(state, stress);
      double largest = 0;
      for (const Vector6d& w : r.joints) largest = std::max(largest, size_of(w, a.length()));
      const std::vector<Vector6d> shares = limb_wrenches(a.machine(), state, r);
      for (std::size_t i = 0; i < shares.size() && i < doubtful_.size(); ++i)
        for (int c = 0; c < 6; ++c)
          if (std::abs(shares[i](c)) > 1e-7 * largest * (c < 3 ? 1 : a.length())) doubtful_[i] |= 1U << c;
    }
  }
  for (const int limb : limbs_) {
    LimbPeaks p{limb, {}, {}};
    for (int k = 0; k < a.samples(); ++k) {
      const Vector6d w = bodies(limb, k);
      take(p.force, w.head<3>().norm(), k);
      take(p.moment, w.tail<3>().norm(), k);
    }
    peaks_.push_back(p);
  }
  judge();
}

Vector6d LimbWrenches::bodies(int limb, int sample) const {
  Vector6d w;
  for (int c = 0; c < 6; ++c) w(c) = a_.column(limb_column(limb, c))[static_cast<std::size_t>(sample)];
  return w;
}

// Limbs that carry an actuator's force to the platform: that of its joint, or those that stand on the body of no limb that it drives.
std::vector<int> LimbWrenches::carriers(int actuator) const {
  const Topology& t = a_.machine().topology();
  const auto limb_of = [&](int body) { return t.bodies[static_cast<std::size_t>(body)].limb; };
  const Joint& driven = t.joints[static_cast<std::size_t>(t.actuators[static_cast<std::size_t>(actuator)].joint)];
  std::vector<int> out, reached;
  for (const int body : {driven.a, driven.b}) {
    if (limb_of(body) > 0) out.push_back(limb_of(body));
    if (limb_of(body) == 0 && body != 0 && body != t.platform) reached.push_back(body);
  }
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (const Joint& joint : t.joints) {
      if (joint.a != reached[next] && joint.b != reached[next]) continue;
      const int other = joint.a == reached[next] ? joint.b : joint.a;
      if (limb_of(other) > 0)
        out.push_back(limb_of(other));
      else if (other != 0 && other != t.platform && std::find(reached.begin(), reached.end(), other) == reached.end())
        reached.push_back(other);
    }
  return out;
}

// Limbs that hold the same constraint wrench share it, and so do those that stand on one driven body its force: only together do they exert
// the rows of G.
std::vector<LimbWrenches::Group> LimbWrenches::groups(int sample) const {
  const mechanics::Machine& machine = a_.machine();
  const mechanics::State state = state_of(a_, sample);
  const std::vector<mechanics::LimbSystem> systems = limb_systems(machine, state, generic_model(machine, state));
  if (std::any_of(systems.begin(), systems.end(), [](const auto& l) { return !l.alone; })) return {};
  const mechanics::ClosedForm c = closed_form(machine, state, a_.length());

  const auto dof = static_cast<std::size_t>(machine.dof());
  std::vector<std::vector<int>> carried;
  for (int i = 0; i < machine.dof(); ++i) carried.push_back(carriers(i));
  std::vector<std::vector<std::size_t>> holders(6);  // of each row of G: indices into systems
  for (std::size_t i = 0; i < systems.size(); ++i)
    for (std::size_t row = 0; row < 6; ++row) {
      const bool holds = row < dof ? std::find(carried[row].begin(), carried[row].end(), systems[i].limb) != carried[row].end()
                                   : outside({systems[i].constraints.origin, c.jacobian.row(static_cast<Index>(row)).transpose()},
                                             systems[i].constraints, a_.length()) < 1e-6;
      if (holds) holders[row].push_back(i);
    }
  std::vector<std::size_t> root(systems.size());  // of each limb the group that it belongs to
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = i;
  for (const auto& together : holders)
    for (const std::size_t i : together) {
      const std::size_t from = root[i], to = root[together.front()];
      std::replace(root.begin(), root.end(), from, to);
    }
  std::vector<Group> out;
  for (std::size_t g = 0; g < root.size(); ++g) {
    Group group;
    for (std::size_t i = 0; i < root.size(); ++i)
      if (root[i] == g) group.limbs.push_back(systems[i].limb);
    bool constrains = false;
    for (std::size_t row = 0; row < 6; ++row)
      if (!holders[row].empty() && root[holders[row].front()] == g) group.rows.push_back(static_cast<int>(row)), constrains |= row >= dof;
    if (constrains) out.push_back(std::move(group));
  }
  return out;
}

void LimbWrenches::judge() {
  const mechanics::Machine& machine = a_.machine();
  const Topology& t = machine.topology();
  const std::vector<int> first = samples_with_forces(a_, 1);
  if (first.empty()) return;
  // What is shared with a joint that belongs to no limb cannot be allotted to the limbs.
  const bool limbs_alone = std::none_of(t.joints.begin(), t.joints.end(), [&](const Joint& joint) { return is_beside_limbs(t, joint); });
  const std::vector<Group> together = t.constraints.empty() || !limbs_alone ? std::vector<Group>{} : groups(first.front());
  mechanics::Loading loading;
  loading.gravity = a_.scenario().load.gravity;
  double largest_difference = 0;
  for (const int k : samples_with_forces(a_, a_.samples())) {
    const mechanics::State state = state_of(a_, k);
    loading.platform << a_.scenario().load.force[static_cast<std::size_t>(k)], a_.scenario().load.moment[static_cast<std::size_t>(k)];
    const Index at = 6 * t.platform - 6;
    const Vector6d inertia = inertial_wrenches(machine, state).segment<6>(at),
                   applied = applied_wrenches(machine, state, loading).segment<6>(at);
    Vector6d sum = applied - inertia + beside_limbs(a_, state, k);
    double scale = std::max(size_of(inertia, a_.length()), size_of(applied, a_.length()));
    for (const int limb : limbs_) {
      sum += bodies(limb, k);
      scale = std::max(scale, size_of(bodies(limb, k), a_.length()));
    }
    const double residual = scale > 0 ? size_of(sum, a_.length()) / scale : 0;
    if (!(residual <= imbalance_)) imbalance_ = residual;

    if (together.empty()) continue;
    const mechanics::ClosedForm c = closed_form(machine, state, a_.length());
    const Vector6d f = closed_statics(c, applied - inertia);
    for (const Group& g : together) {
      Vector6d formula = Vector6d::Zero(), actual = Vector6d::Zero();
      for (const int row : g.rows) formula += c.jacobian.row(row).transpose() * f(row);
      for (const int limb : g.limbs) actual += bodies(limb, k);
      const double difference = size_of(actual - formula, a_.length());
      if (difference <= largest_difference) continue;
      largest_difference = difference;
      differ_.share = difference / std::max(size_of(actual, a_.length()), size_of(formula, a_.length()));
      differ_.limbs = g.limbs, differ_.sample = k, differ_.by_formula = formula, differ_.by_bodies = actual;
      differ_.constraints.clear();
      for (const int row : g.rows)
        if (row >= machine.dof()) differ_.constraints.emplace_back(row, f(row));
    }
  }
}

}  // namespace pmreport::analysis
