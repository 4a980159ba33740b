// Laws that forces and reactions of every mechanism obey, whatever their values.
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/reactions/reactions.hpp>
#include <tests/plugins/every_mechanism.hpp>

#include <Eigen/Geometry>
#include <Eigen/QR>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double laws_tolerance = 1e-9;  // roundings of 1e-16 times condition numbers of up to 1e3, squared where weights are added

// Reactions of one mechanism at one state, one below the other, moments per characteristic length; below them the actuator forces.
class Solver {
 public:
  explicit Solver(const Machine& machine) : machine_(machine), frames_(machine), length_(characteristic_length(machine)) {}

  JointReactions solve(const State& s, const Loading& loading) const {
    return dense_reactions(machine_, s, generic_model(machine_, s), frames_, loading, length_);
  }
  VectorXd operator()(const State& s, const Loading& loading) const { return stacked(solve(s, loading)); }
  VectorXd stacked(const JointReactions& r) const {
    VectorXd out(6 * static_cast<Eigen::Index>(r.joints.size()) + r.actuator_forces.size());
    for (std::size_t j = 0; j < r.joints.size(); ++j) {
      out.segment<6>(6 * static_cast<Eigen::Index>(j)) = r.joints[j];
      out.segment<3>(6 * static_cast<Eigen::Index>(j) + 3) /= length_;
    }
    out.tail(r.actuator_forces.size()) = r.actuator_forces;
    return out;
  }
  double length() const { return length_; }

 private:
  const Machine& machine_;
  JointFrames frames_;
  double length_;
};

}  // namespace

TEST_CASE("actuator forces by virtual work and by the free bodies of every mechanism are the same") {
  for (const test::Named& named : test::every_mechanism()) {
    const Machine& machine = *named.machine;
    const Solver solver(machine);
    std::mt19937_64 random(51);
    for (int pose = 0; pose < 3; ++pose) {
      const test::RandomMotion motion = test::random_motion(machine, random);
      INFO(named.name << ", q = " << motion.q.transpose());
      const State s = motion.state(machine);
      const Loading loading{test::random_load(solver.length(), random), test::random_gravity(random)};
      const VectorXd forces = virtual_work(machine, s, tangent(machine, s), loading).total();
      const JointReactions r = solver.solve(s, loading);
      CHECK_FALSE(r.singular);
      CHECK((forces - r.actuator_forces).lpNorm<Eigen::Infinity>() < laws_tolerance * forces.lpNorm<Eigen::Infinity>());
      CHECK(r.residual < laws_tolerance);
      CHECK(static_cast<int>(r.stresses.size()) == mobility(machine, s).redundant);
    }
  }
}

TEST_CASE("forces and reactions are linear in load and gravity, and quadratic in the speed of a motion") {
  for (const test::Named& named : test::every_mechanism()) {
    const Machine& machine = *named.machine;
    const Solver solver(machine);
    std::mt19937_64 random(52);
    const test::RandomMotion motion = test::random_motion(machine, random);
    INFO(named.name << ", q = " << motion.q.transpose());
    test::RandomMotion still = motion, fast = motion;
    still.rate.setZero(), still.acceleration.setZero();
    constexpr double faster = 1.7;  // the same path in less time: rates times 1.7, accelerations times its square
    fast.rate *= faster, fast.acceleration *= faster * faster;
    // Of the size of the machine's weight, so that of a light one the forces of its motion are not lost beside those of the load.
    double weight = 0;  // [N]
    for (const Body& b : machine.topology().bodies) weight += 9.81 * b.inertia.mass;
    const double scale = weight / 100;
    const Vector6d load = scale * test::random_load(solver.length(), random), other = scale * test::random_load(solver.length(), random);
    const Vector3d gravity = test::random_gravity(random), none = Vector3d::Zero();
    const State s = motion.state(machine), rest = still.state(machine);

    const VectorXd of_motion = solver(s, {Vector6d::Zero(), none}), of_load = solver(rest, {load, none}),
                   of_weights = solver(rest, {Vector6d::Zero(), gravity}), of_all = solver(s, {load, gravity});
    const double size = of_all.lpNorm<Eigen::Infinity>();
    REQUIRE(of_motion.lpNorm<Eigen::Infinity>() > 1e-3 * size);
    REQUIRE(of_load.lpNorm<Eigen::Infinity>() > 1e-3 * size);
    REQUIRE(of_weights.lpNorm<Eigen::Infinity>() > 1e-3 * size);
    CHECK((of_motion + of_load + of_weights - of_all).lpNorm<Eigen::Infinity>() < laws_tolerance * size);
    CHECK((solver(rest, {2 * load - 3 * other, none}) - 2 * of_load + 3 * solver(rest, {other, none})).lpNorm<Eigen::Infinity>() <
          laws_tolerance * 10 * size);
    CHECK((solver(fast.state(machine), {Vector6d::Zero(), none}) - faster * faster * of_motion).lpNorm<Eigen::Infinity>() <
          laws_tolerance * size);
  }
}

TEST_CASE("a unique component stays whatever the joints' stiffness, an indeterminate one does not") {
  // With other stiffnesses the least energy, sum of lambda^2 / k, picks another solution of the same equilibrium. What all solutions share
  // is what is unique.
  for (const test::Named& named : test::every_mechanism()) {
    const Machine& machine = *named.machine;
    const Solver solver(machine);
    std::mt19937_64 random(53);
    const test::RandomMotion motion = test::random_motion(machine, random);
    INFO(named.name << ", q = " << motion.q.transpose());
    const State s = motion.state(machine);
    const Loading loading{test::random_load(solver.length(), random), test::random_gravity(random)};
    const GenericModel model = generic_model(machine, s);
    const JointReactions r = solver.solve(s, loading);
    const JointFrames frames(machine);

    const Eigen::Index rows = model.constraints.rows();
    MatrixXd system(model.constraints.cols(), rows + model.actuation.rows());
    system << model.constraints.transpose(), model.actuation.transpose();
    const VectorXd required = inertial_wrenches(machine, s) - applied_wrenches(machine, s, loading);
    std::vector<std::vector<Vector6d>> solutions;  // wrenches on body b about the joint's centre, in joint axes and base axes
    for (int k = 0; k < 3; ++k) {
      VectorXd weight(system.cols());
      for (double& w : weight) w = std::exp(std::uniform_real_distribution<double>(-1, 1)(random));
      const VectorXd x =
          weight.cwiseProduct(Eigen::CompleteOrthogonalDecomposition<MatrixXd>(system * weight.asDiagonal()).solve(required));
      solutions.emplace_back(2 * s.joints.size(), Vector6d::Zero());
      for (Eigen::Index row = 0; row < rows; ++row) {
        const auto j = static_cast<std::size_t>(model.joint_of_row[static_cast<std::size_t>(row)]);
        const Joint& joint = machine.topology().joints[j];
        const int body = joint.b;
        REQUIRE(body > 0);
        Vector6d w = model.constraints.block<1, 6>(row, 6 * body - 6).transpose() * x(row);
        w.tail<3>() -= Vector3d(s.joints[j].centre - s.bodies[static_cast<std::size_t>(body)].origin).cross(w.head<3>());
        solutions.back()[2 * j] += in_axes(frames(s, static_cast<int>(j)), w);
        solutions.back()[2 * j + 1] += w;
      }
    }
    double size = 0;
    for (const Vector6d& w : solutions[0])
      size = std::max({size, w.head<3>().lpNorm<Eigen::Infinity>(), w.tail<3>().lpNorm<Eigen::Infinity>() / solver.length()});
    int shared = 0;
    for (std::size_t j = 0; j < s.joints.size(); ++j)
      for (std::size_t c = 0; c < 12; ++c) {
        const auto component = [&](std::size_t k) {
          const double x = solutions[k][2 * j + c / 6](static_cast<Eigen::Index>(c % 6));
          return c % 6 < 3 ? x : x / solver.length();
        };
        const double spread = std::max(std::abs(component(0) - component(1)), std::abs(component(0) - component(2)));
        const bool unique = (r.indeterminate[j] >> c & 1) == 0;
        INFO(machine.topology().joints[j].name << ", component " << c << ", spread " << spread << " of " << size);
        // A share of a random load that changes by less than 1e-6 of the largest would be a coincidence.
        CHECK((unique ? spread < laws_tolerance * size : spread > 1e-6 * size));
        shared += !unique;
      }
    CHECK((shared > 0) == (mobility(machine, s).redundant > 0));
  }
}

TEST_CASE("limbs, other joints, load and weight together give the platform its change of momentum") {
  for (const test::Named& named : test::every_mechanism()) {
    const Machine& machine = *named.machine;
    const Solver solver(machine);
    std::mt19937_64 random(54);
    const test::RandomMotion motion = test::random_motion(machine, random);
    INFO(named.name << ", q = " << motion.q.transpose());
    const Loading loading{test::random_load(solver.length(), random), test::random_gravity(random)};
    const State s = motion.state(machine);
    const auto platform = static_cast<std::size_t>(machine.topology().platform);
    const Inertia& inertia = machine.topology().bodies[platform].inertia;
    const Vector3d fixed = s.bodies[platform].origin;  // a point of the base, where the platform's reference point is now

    // Momentum, and moment of momentum about that point, a moment before and after.
    const auto momentum = [&](double t) {
      const VectorXd q = motion.q + t * motion.rate + 0.5 * t * t * motion.acceleration, rate = motion.rate + t * motion.acceleration;
      State then;
      evaluate(machine, q.data(), rate.data(), motion.acceleration.data(), then);
      const BodyState& b = then.bodies[platform];
      const Vector3d c = b.rotation * inertia.centre, p = inertia.mass * (b.velocity + b.angular_velocity.cross(c));
      const Vector3d spin = b.rotation * inertia.about_centre * b.rotation.transpose() * b.angular_velocity;
      return (Vector6d() << p, (b.origin + c - fixed).cross(p) + spin).finished();
    };
    constexpr double h = 1e-3;  // fourth order: 1e-12; roundings 1e-16 / h
    const Vector6d change = (8.0 * (momentum(h) - momentum(-h)) - (momentum(2 * h) - momentum(-2 * h))) / (12 * h);
    const Vector3d weight = inertia.mass * loading.gravity;
    Vector6d sum = loading.platform;
    sum.head<3>() += weight;
    sum.tail<3>() += (s.bodies[platform].rotation * inertia.centre).cross(weight);
    double size = change.lpNorm<Eigen::Infinity>();
    const JointReactions reactions = solver.solve(s, loading);
    const auto add = [&](const Vector6d& w) {
      sum += w;
      size = std::max(size, w.lpNorm<Eigen::Infinity>());
    };
    for (const Vector6d& limb : limb_wrenches(machine, s, reactions)) add(limb);
    // A platform of several bodies hangs on the others by joints that belong to no limb, here without drives.
    for (std::size_t j = 0; j < reactions.joints.size(); ++j) {
      const Joint& joint = machine.topology().joints[j];
      const bool is_a = joint.a == machine.topology().platform, is_b = joint.b == machine.topology().platform;
      if ((!is_a && !is_b) || machine.topology().bodies[static_cast<std::size_t>(is_a ? joint.b : joint.a)].limb != 0) continue;
      Vector6d w = reactions.joints[j];
      w.tail<3>() += (s.joints[j].centre - fixed).cross(w.head<3>());
      add(is_b ? w : Vector6d(-w));
    }
    CHECK((sum - change).lpNorm<Eigen::Infinity>() < 1e-8 * size);
  }
}
