// Simbody judges the dynamics: the same bodies, joints, masses, motion and load, other equations and other code.
//
// Compared, for every mechanism, in random states with random loads and gravity in random directions:
//   - whether Simbody's constraints hold at our positions and velocities, and its bodies are where ours are;
//   - the accelerations of all bodies: Simbody is told those of the actuators alone and finds the rest by its own equations;
//   - the actuator forces: by virtual work, by the system over all bodies, and limb by limb;
//   - every component of every joint's reaction that is called unique, by the latter two;
//   - that the others differ by a self-stress and no more, and that there are as many self-stresses as redundant constraints in Simbody.
// Not compared: the values that are not unique (where constraints are redundant, Simbody takes some least-squares multipliers, others than
// ours); actuators that share a joint; stiffness, friction and everything else that is no rigid body.
#include <catch2/catch.hpp>

#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/reactions/inverse_dynamics.hpp>
#include <tests/judges/random_state.hpp>
#include <tests/judges/simbody_model.hpp>
#include <tests/plugins/plugin.hpp>

#include <Eigen/QR>

using namespace pmreport;
using namespace pmreport::mechanics;
using judges::SimbodyModel;

namespace {

constexpr int states = 16;

// Relative to the largest of their kind. Positions and velocities are a few products of rotations. Accelerations and forces are what linear
// systems leave of 1e-15: Simbody's for the multipliers, of a condition up to 1e7 (2q-spr, its redundant constraints set aside).
constexpr double same_kinematics = 1e-12, same_accelerations = 1e-10, same_forces = 1e-8;

struct Variant {  // a mechanism with its default parameters, but for one choice
  const char *name, *parameter = "", *word = "";

  ParameterValues values() const {
    const pm_mechanism& table = test::plugin(name);
    if (*parameter == 0) return default_values(describe(table));
    return test::values_with(table, {{parameter, {test::choice(table, parameter, word)}}});
  }
};

struct Subject {
  Machine machine;
  JointFrames frames{machine};
  double length = characteristic_length(machine);
  InverseDynamics limbs{machine};
  SimbodyModel judge{machine};

  explicit Subject(const Variant& of) : machine(test::plugin(of.name), of.values()) {}
};

// Calls f(state, loading) in random states.
template <class F>
void in_random_states(const Subject& s, F&& f) {
  std::mt19937_64 random(20);
  for (int k = 0; k < states; ++k) {
    const State state = judges::random_state(s.machine, random);
    const Loading loading = judges::random_loading(random);
    CAPTURE(s.machine.info().name, k);
    f(state, loading);
  }
}

void ask(Subject& s, const State& state, const Loading& loading) {
  s.judge.set_gravity(loading.gravity);
  s.judge.solve(s.judge.input(state, loading.platform));
}

Variant any_mechanism() {
  return GENERATE(Variant{"gough"}, Variant{"stewart"}, Variant{"parallel-cross"}, Variant{"4sps-spr"}, Variant{"2q-spr"},
                  Variant{"2q-spr", "rods_1", "crossed"}, Variant{"5pus-upu"}, Variant{"5pus-upu", "constraint", "ideal"},
                  Variant{"p2prpu-prps"}, Variant{"delta"}, Variant{"par4"});
}

Eigen::VectorXd vector(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
}

JointReactions over_all_bodies(const Subject& s, const State& state, const Loading& loading) {
  return dense_reactions(s.machine, state, generic_model(s.machine, state), s.frames, loading, s.length);
}

JointReactions limb_by_limb(Subject& s, const State& state, const Loading& loading) {
  MotionReactions one;
  s.limbs.solve(1, state.coordinate_jets.data(), loading.platform.data(), loading.gravity, one);
  const auto wrenches = [&](const double* from) {
    std::vector<Vector6d> out;
    for (std::size_t j = 0; j < state.joints.size(); ++j) out.emplace_back(from + 6 * j);
    return out;
  };
  JointReactions out;
  out.actuator_forces = vector(one.actuator_forces);
  out.joints = wrenches(one.joints.data());
  out.indeterminate = one.indeterminate;
  for (int k = 0; k < one.stress_count; ++k)
    out.stresses.push_back(wrenches(one.stresses.data() + 6 * state.joints.size() * static_cast<std::size_t>(k)));
  return out;
}

// Moments per length: all components in newtons.
Eigen::VectorXd stacked(const std::vector<Vector6d>& joints, double length) {
  Eigen::VectorXd out(6 * static_cast<Eigen::Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    out.segment<6>(6 * static_cast<Eigen::Index>(j)) = joints[j];
    out.segment<3>(6 * static_cast<Eigen::Index>(j) + 3) /= length;
  }
  return out;
}

}  // namespace

TEST_CASE("Simbody's constraints hold where the bodies are placed, at the velocities they have") {
  Subject s(any_mechanism());
  in_random_states(s, [&](const State& state, const Loading& loading) {
    ask(s, state, loading);
    double fastest = 0;
    for (const BodyState& b : state.bodies) fastest = std::max(fastest, b.twist().lpNorm<Eigen::Infinity>());
    const SimbodyModel::Deviation d = s.judge.deviation(state);
    CHECK(d.position < same_kinematics);
    CHECK(d.velocity < same_kinematics * fastest);
  });
}

// They do not depend on the load, which would only bring in the rounding of forces that cancel.
TEST_CASE("Simbody finds the accelerations of all bodies from those of the actuators") {
  Subject s(any_mechanism());
  in_random_states(s, [&](const State& state, const Loading&) {
    ask(s, state, {});
    double largest = 0;
    for (const BodyState& b : state.bodies)
      for (const double a : {b.acceleration.lpNorm<Eigen::Infinity>(), s.length * b.angular_acceleration.lpNorm<Eigen::Infinity>()})
        largest = std::max(largest, a);
    CHECK(s.judge.deviation(state).acceleration < same_accelerations * largest);
  });
}

TEST_CASE("Simbody needs the same actuator forces") {
  Subject s(any_mechanism());
  in_random_states(s, [&](const State& state, const Loading& loading) {
    ask(s, state, loading);
    const Eigen::VectorXd theirs = vector(s.judge.actuator_forces());
    const Eigen::VectorXd by_work = virtual_work(s.machine, state, tangent(s.machine, state), loading).total();
    for (const Eigen::VectorXd& ours :
         {by_work, over_all_bodies(s, state, loading).actuator_forces, limb_by_limb(s, state, loading).actuator_forces})
      CHECK((ours - theirs).lpNorm<Eigen::Infinity>() < same_forces * theirs.lpNorm<Eigen::Infinity>());
  });
}

TEST_CASE("every component of a reaction that is called unique is the one that Simbody finds") {
  Subject s(any_mechanism());
  in_random_states(s, [&](const State& state, const Loading& loading) {
    ask(s, state, loading);
    const std::vector<Vector6d> theirs = s.judge.joint_reactions(state);
    for (const JointReactions& ours : {over_all_bodies(s, state, loading), limb_by_limb(s, state, loading)}) {
      const double largest = stacked(ours.joints, s.length).lpNorm<Eigen::Infinity>();
      for (std::size_t j = 0; j < theirs.size(); ++j) {
        CAPTURE(s.machine.topology().joints[j].name, ours.joints[j].transpose(), theirs[j].transpose());
        const Vector6d in_base = ours.joints[j] - theirs[j], in_joint = in_axes(s.frames(state, static_cast<int>(j)), in_base);
        for (int c = 0; c < 6; ++c) {
          const double allowed = same_forces * largest * (c < 3 ? 1 : s.length);
          if ((ours.indeterminate[j] >> c & 1) == 0) CHECK(std::abs(in_joint(c)) < allowed);
          if ((ours.indeterminate[j] >> (6 + c) & 1) == 0) CHECK(std::abs(in_base(c)) < allowed);
        }
      }
    }
  });
}

TEST_CASE("Simbody's reactions differ from ours by a self-stress and no more") {
  Subject s(any_mechanism());
  in_random_states(s, [&](const State& state, const Loading& loading) {
    ask(s, state, loading);
    const Eigen::VectorXd theirs = stacked(s.judge.joint_reactions(state), s.length);
    for (const JointReactions& ours : {over_all_bodies(s, state, loading), limb_by_limb(s, state, loading)}) {
      CHECK(static_cast<int>(ours.stresses.size()) == s.judge.redundant_constraints());
      const Eigen::VectorXd own = stacked(ours.joints, s.length);
      Eigen::VectorXd rest = theirs - own;
      if (!ours.stresses.empty()) {
        Eigen::MatrixXd stress(rest.size(), static_cast<Eigen::Index>(ours.stresses.size()));
        for (Eigen::Index k = 0; k < stress.cols(); ++k) stress.col(k) = stacked(ours.stresses[static_cast<std::size_t>(k)], s.length);
        rest -= stress * stress.colPivHouseholderQr().solve(rest);
      }
      CHECK(rest.lpNorm<Eigen::Infinity>() < same_forces * own.lpNorm<Eigen::Infinity>());
    }
  });
}
