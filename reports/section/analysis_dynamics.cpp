// Forces in motion, of every sample: columns of the sections dynamics, drives and reactions, and their residuals.
#include <reports/section/analysis.hpp>

#include <core/mechanics/virtual_work.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using mechanics::Vector6d;

void Analysis::run_dynamics(const Progress& progress) {
  const Topology& t = machine_.topology();
  const mechanics::JointFrames frames(machine_);
  indeterminate_.assign(t.joints.size(), 0);
  mechanics::State state;
  for (int k = 0; k < samples(); ++k) {
    if (k % 64 == 0) progress.stop_if_asked();
    if (condition(k) != Condition::good) continue;
    const auto sample = static_cast<std::size_t>(k);
    const scenario::Motion& motion = scenario_.motion;
    const Eigen::VectorXd q = motion.value.row(k), rate = motion.rate.row(k), acceleration = motion.acceleration.row(k);
    evaluate(machine_, q.data(), rate.data(), acceleration.data(), state);
    mechanics::Loading loading;
    loading.platform << scenario_.load.force[sample], scenario_.load.moment[sample];
    loading.gravity = scenario_.load.gravity;
    const auto put = [&](const std::string& name, double value) { columns_.at(name)[sample] = value + 0.0; };

    const mechanics::ForceShares forces = virtual_work(machine_, state, tangent(machine_, state), loading);
    const mechanics::SmallVector total = forces.total();
    double power = 0;
    for (std::size_t i = 0; i < t.actuators.size(); ++i) {
      const std::string& name = t.actuators[i].name;
      const auto at = static_cast<Eigen::Index>(i);
      put(name + "_dynamic_force", total(at));
      put(name + "_load_force", forces.load(at));
      put(name + "_gravity_force", forces.gravity(at));
      put(name + "_inertia_force", forces.inertia(at));
      put(name + "_power", total(at) * state.actuators[i].rate);
      power += total(at) * state.actuators[i].rate;
    }
    put("total_power", power);
    put("load_power", loading.platform.dot(state.bodies[static_cast<std::size_t>(t.platform)].twist()));
    put("kinetic_energy", kinetic_energy(machine_, state));
    put("potential_energy", potential_energy(machine_, state, loading.gravity));

    const auto r = dense_reactions(machine_, state, generic_model(machine_, state), frames, loading, length_);
    self_stresses_ = std::max(self_stresses_, static_cast<int>(r.stresses.size()));
    for (std::size_t j = 0; j < t.joints.size(); ++j) {
      const Joint& joint = t.joints[j];
      indeterminate_[j] = static_cast<Indeterminate>(indeterminate_[j] | r.indeterminate[j]);
      const Vector6d local = mechanics::in_axes(frames(state, static_cast<int>(j)), r.joints[j]);
      put(joint.name + "_force", r.joints[j].head<3>().norm());
      if (joint.kind != JointKind::spherical) put(joint.name + "_moment", r.joints[j].tail<3>().norm());
      for (int c = 0; c < 6; ++c) {
        if (mechanics::transmits(joint.kind, c)) put(mechanics::reaction_column(joint, c, false), local(c));
        if (c < 3 || joint.kind != JointKind::spherical) put(mechanics::reaction_column(joint, c, true), r.joints[j](c));
      }
    }
    const std::vector<Vector6d> limbs = limb_wrenches(machine_, state, r);
    for (std::size_t i = 0; i < limbs.size(); ++i)
      for (int c = 0; c < 6; ++c) put("limb" + std::to_string(i + 1) + (c < 3 ? "_force_" : "_moment_") + "xyz"[c % 3], limbs[i](c));
    const double scale = std::max(total.lpNorm<Eigen::Infinity>(), 1e-300);
    measures_[sample][static_cast<std::size_t>(Measure::newton_euler)] = (total - r.actuator_forces).lpNorm<Eigen::Infinity>() / scale;
    measures_[sample][static_cast<std::size_t>(Measure::free_body)] = r.residual;
  }
}

}  // namespace pmreport::section
