// The largest time scaling that limits admit: cases with known roots, a walk through all smaller scalings that knows no roots, and a
// machine that runs as fast as it was told it may.
#include <core/mechanics/dynamics/speed.hpp>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/mobility/mobility.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/reactions/reactions.hpp>
#include <core/numbers.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>

#include <functional>
#include <random>

using namespace pmreport::mechanics;
using Eigen::Vector3d;
using pmreport::infinity;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
// Roots are good to a few roundings of well-conditioned polynomials; 1e-13 leaves room for those that the tests add.
constexpr double exact = 1e-13;

// `asked(s)` is what a limit is on. All scalings up to `s` keep it, and the next one does not.
void check_by_walking(double s, double limit, const std::function<double(double)>& asked) {
  constexpr int steps = 2000;
  constexpr double rounding = 1e-12;  // of evaluating `asked` at a root, relative to the limit
  CAPTURE(s, limit);
  if (asked(0) > limit) {
    CHECK(s == 0);
    return;
  }
  REQUIRE(s >= 0);
  int broken = 0;
  for (int i = 0; i <= steps; ++i) {
    // Far out the walk is geometric: the first crossing may be a thousand times nearer than the end.
    const double share = static_cast<double>(i) / steps, reach = i % 2 == 0 ? share : std::pow(10.0, 6 * (share - 1));
    broken += asked(s * reach) > limit * (1 + rounding) ? 1 : 0;
  }
  CHECK(broken == 0);
  CHECK(asked(s * (1 + 1e-6)) > limit);
}

double size(std::mt19937& generator) {
  std::uniform_real_distribution<double> exponent(-3, 3);
  return std::pow(10.0, exponent(generator));
}
double any(std::mt19937& generator) {
  std::bernoulli_distribution negative;
  const double x = size(generator);
  return negative(generator) ? -x : x;
}
Vector3d any_vector(std::mt19937& generator) {
  std::normal_distribution<double> component;
  return Vector3d(component(generator), component(generator), component(generator)) * size(generator);
}

}  // namespace

TEST_CASE("a force on its way to a limit meets the end towards which inertia takes it") {
  CHECK(speed_by_force(3, 4, 7) == Approx(1).epsilon(exact));
  CHECK(speed_by_force(3, -4, 7) == Approx(std::sqrt(2.5)).epsilon(exact));
  CHECK(speed_by_force(-3, -4, 7) == Approx(1).epsilon(exact));
  CHECK(speed_by_force(0, 2, 8) == Approx(2).epsilon(exact));
  CHECK(speed_by_force(7, 0, 7) == infinity);
  CHECK(speed_by_force(7, 1, 7) == 0);
  CHECK(speed_by_force(7, -1, 7) == Approx(std::sqrt(14)).epsilon(exact));
}

TEST_CASE("a limit that is broken at rest admits no speed, though a higher one would keep it") {
  CHECK(speed_by_force(9, -2, 7) == 0);
  CHECK(speed_by_force(-9, 0, 7) == 0);
  CHECK(speed_by_reaction({6, 0, 0}, {-1, 0, 0}, 5) == 0);
}

TEST_CASE("power grows with the third power of the speed, or with the first at rest loads alone") {
  CHECK(speed_by_power(1, 1, 1, 2) == Approx(1).epsilon(exact));     // s + s^3 = 2
  CHECK(speed_by_power(1, 1, -1, 10) == Approx(2).epsilon(exact));   // s + s^3 = 10
  CHECK(speed_by_power(-2, -3, 1, 28) == Approx(2).epsilon(exact));  // 2 s + 3 s^3 = 28
}

TEST_CASE("power without load, without inertia, without motion") {
  CHECK(speed_by_power(0, 3, 2, 48) == Approx(2).epsilon(exact));
  CHECK(speed_by_power(5, 0, -2, 40) == Approx(4).epsilon(exact));
  CHECK(speed_by_power(5, 7, 0, 1) == infinity);
  CHECK(speed_by_power(0, 0, 7, 1) == infinity);
}

TEST_CASE("where inertia relieves an actuator, the first speed that breaks its power counts, not the last that keeps it") {
  // p = 3 s - s^3: 1.375 at s = 1/2, 2 at its summit s = 1, 0.704 at s = 1.6, -1.375 at s = 1.93.
  CHECK(speed_by_power(3, -1, 1, 1.375) == Approx(0.5).epsilon(exact));
  CHECK(speed_by_power(-3, 1, 1, 1.375) == Approx(0.5).epsilon(exact));
  // Above the summit the power only falls: 3 s - s^3 = -18 at s = 3.
  CHECK(speed_by_power(3, -1, 1, 18) == Approx(3).epsilon(exact));
  CHECK(speed_by_power(3, -1, 1, 2.0001) > 2);
  CHECK(speed_by_power(3, -1, 1, 1.9999) < 1);
  // A root next to the summit is known to the square root of a rounding: p = 2 - 1e-12 at s = 1 - 5.77e-7.
  CHECK(speed_by_power(3, -1, 1, 2 - 1e-12) == Approx(1 - std::sqrt(1e-12 / 3)).margin(1e-9));
}

TEST_CASE("a reaction leaves the sphere of its limit once") {
  CHECK(speed_by_reaction({3, 0, 0}, {0, 1, 0}, 5) == Approx(2).epsilon(exact));
  CHECK(speed_by_reaction({0, 0, 0}, {0, 0, -2}, 8) == Approx(2).epsilon(exact));
  CHECK(speed_by_reaction({-3, 4, 0}, {0.6, -0.8, 0}, 5) == Approx(std::sqrt(10)).epsilon(exact));  // across, from a point of the sphere
  CHECK(speed_by_reaction({3, 0, 0}, {0, 0, 0}, 5) == infinity);
}

TEST_CASE("forces that round to nothing neither break nor bind a limit early") {
  CHECK(speed_by_power(1e-300, 1, 1, 8) == Approx(2).epsilon(exact));
  CHECK(speed_by_power(1, 1e-300, 1, 8) == Approx(8).epsilon(exact));
  CHECK(speed_by_power(1, -1e-300, 1, 8) == Approx(8).epsilon(exact));
  CHECK(speed_by_power(1e-320, -1, 1, 8) == Approx(2).epsilon(exact));
  CHECK(speed_by_power(1e200, 1e-200, 1, 8) == Approx(8e-200).epsilon(exact));
  CHECK(speed_by_reaction({3e-200, 0, 0}, {0, 1e-200, 0}, 5e-200) == Approx(2).epsilon(exact));
  CHECK(speed_by_force(1e-300, 1e-300, 1) > 1e149);
}

TEST_CASE("no speed up to the one found breaks a limit, and the next one does") {
  std::mt19937 generator(20240517);
  for (int i = 0; i < 500; ++i) {
    const double rest = any(generator), inertia = any(generator), rate = any(generator), limit = size(generator);
    CAPTURE(i, rest, inertia, rate, limit);
    check_by_walking(speed_by_force(rest, inertia, limit), limit, [&](double s) { return std::abs(rest + s * s * inertia); });
    check_by_walking(speed_by_power(rest, inertia, rate, limit), limit,
                     [&](double s) { return s * std::abs(rate) * std::abs(rest + s * s * inertia); });
    const Vector3d r = any_vector(generator), w = any_vector(generator);
    CAPTURE(r, w);
    check_by_walking(speed_by_reaction(r, w, limit), limit, [&](double s) { return (r + s * s * w).norm(); });
  }
}

namespace {

// Two actuators, one joint, three samples; no limit yet.
struct Motion {
  MotionForces forces;
  MotionLimits limits;
  Motion() {
    forces.actuator_rest = Eigen::MatrixXd{{1, 0}, {2, 0}, {3, 0}};
    forces.actuator_inertia = Eigen::MatrixXd{{3, 1}, {8, 4}, {5, -9}};
    forces.actuator_rate = Eigen::MatrixXd{{0, 0.5}, {1, 0.25}, {0, -0.1}};
    forces.joint_rest = Eigen::MatrixXd::Zero(3, 6);
    forces.joint_inertia = Eigen::MatrixXd{{1, 0, 0, 0, 0, 2}, {0, -4, 0, 0, 0, 0}, {0, 0, 2, 8, 0, 0}};
    limits.force = limits.speed = limits.power = {infinity, infinity};
    limits.joint_force = limits.joint_moment = {infinity};
  }
  FeasibleSpeed feasible() const { return feasible_speed(forces, limits); }
};

}  // namespace

TEST_CASE("without limits nothing binds") {
  const FeasibleSpeed f = Motion().feasible();
  CHECK(f.scale == infinity);
  CHECK(f.limit == -1);
  CHECK(f.sample == -1);
  CHECK(f.limits.empty());
  CHECK(f.largest == std::vector{infinity, infinity, infinity});
}

TEST_CASE("each kind of limit binds where it must") {
  using Kind = SpeedLimit::Kind;
  const auto bound = [](std::vector<double> MotionLimits::*list, std::size_t index, double limit) {
    Motion m;
    (m.limits.*list)[index] = limit;
    return m.feasible();
  };
  const FeasibleSpeed force = bound(&MotionLimits::force, 0, 34);
  REQUIRE(force.limits.size() == 1);
  CHECK(force.limits[0].kind == Kind::actuator_force);
  CHECK(force.scale == Approx(2).epsilon(exact));  // 2 + 4 * 8 at sample 1
  CHECK(force.sample == 1);
  CHECK(force.largest[0] == Approx(std::sqrt(11)).epsilon(exact));
  CHECK(force.largest == force.limits[0].largest);

  const FeasibleSpeed speed = bound(&MotionLimits::speed, 1, 2);
  CHECK(speed.limits.at(0).kind == Kind::actuator_speed);
  CHECK(speed.limits.at(0).index == 1);
  CHECK(speed.scale == 4);
  CHECK(speed.sample == 0);
  CHECK(bound(&MotionLimits::speed, 0, 3).largest == std::vector{infinity, 3.0, infinity});

  const FeasibleSpeed power = bound(&MotionLimits::power, 0, 68);  // 2 s + 8 s^3
  CHECK(power.limits.at(0).kind == Kind::actuator_power);
  CHECK(power.scale == Approx(2).epsilon(exact));
  CHECK(power.largest[0] == infinity);

  const FeasibleSpeed reaction = bound(&MotionLimits::joint_force, 0, 16);
  CHECK(reaction.limits.at(0).kind == Kind::joint_force);
  CHECK(reaction.scale == Approx(2).epsilon(exact));
  CHECK(reaction.sample == 1);
  const FeasibleSpeed moment = bound(&MotionLimits::joint_moment, 0, 32);
  CHECK(moment.limits.at(0).kind == Kind::joint_moment);
  CHECK(moment.scale == Approx(2).epsilon(exact));
  CHECK(moment.sample == 2);
  CHECK(moment.largest[1] == infinity);
}

TEST_CASE("the least over all limits and samples is the scale, and names its limit and sample") {
  Motion m;
  m.limits.force = {34, 16};       // 2 at sample 1; 4/3 at sample 2
  m.limits.speed = {infinity, 2};  // 4 at sample 0
  m.limits.joint_force = {100};    // 5 at sample 1
  const FeasibleSpeed f = m.feasible();
  REQUIRE(f.limits.size() == 4);
  CHECK(f.scale == Approx(4.0 / 3).epsilon(exact));
  CHECK(f.sample == 2);
  REQUIRE(f.limit == 1);
  CHECK(f.limits[1].index == 1);
  CHECK(f.largest[0] == Approx(std::sqrt(11)).epsilon(exact));
  CHECK(f.largest[1] == Approx(2).epsilon(exact));
  m.limits.force[0] = 2.5;  // 3 at rest of sample 2
  const FeasibleSpeed broken = m.feasible();
  CHECK(broken.scale == 0);
  CHECK(broken.limit == 0);
  CHECK(broken.sample == 2);
}

TEST_CASE("of limits that are broken even at rest the one that is broken by most binds, where it is worst") {
  Motion m;
  m.forces.actuator_rest.col(0) << 3, 8, 5;
  m.forces.actuator_rest.col(1) << 9, 1, 1;
  m.limits.force = {2, infinity};
  FeasibleSpeed f = m.feasible();
  CHECK(f.scale == 0);
  CHECK(f.sample == 1);  // four times the limit, not the first that is above it
  CHECK(f.limits[0].sample == 1);
  CHECK(f.limits[0].at_rest == Approx(4).epsilon(exact));
  m.limits.force = {2, 1};
  f = m.feasible();
  CHECK(f.limit == 1);  // nine times
  CHECK(f.sample == 0);
}

TEST_CASE("a sample without numbers does not count, and a motion of none has no speed") {
  Motion m;
  m.limits.force = {34, infinity};
  m.limits.speed = {infinity, 10};
  for (auto* part : {&m.forces.actuator_rest, &m.forces.actuator_inertia, &m.forces.actuator_rate}) part->row(1).setConstant(no_number);
  const FeasibleSpeed f = m.feasible();
  CHECK(f.scale == Approx(std::sqrt(31.0 / 5)).epsilon(exact));  // 3 + s^2 5 = 34 at sample 2
  CHECK(f.sample == 2);
  CHECK(std::isnan(f.largest[1]));
  CHECK(std::isnan(f.limits[0].largest[1]));
  CHECK(std::isfinite(f.largest[0]));
  for (auto* part : {&m.forces.actuator_rest, &m.forces.actuator_inertia, &m.forces.actuator_rate}) part->setConstant(no_number);
  CHECK(std::isnan(m.feasible().scale));
  CHECK(m.feasible().limit == -1);
}

TEST_CASE("limits on actuators need no reactions, and limits on joints no actuator forces") {
  Motion m;
  m.limits.speed = {2, 2};
  m.forces.joint_rest.resize(0, 0);
  m.forces.joint_inertia.resize(0, 0);
  CHECK(m.feasible().scale == 2);
  Motion joints;
  joints.limits.joint_force = {1};
  for (auto* part : {&joints.forces.actuator_rest, &joints.forces.actuator_inertia, &joints.forces.actuator_rate}) part->resize(0, 0);
  CHECK(joints.feasible().scale == Approx(0.5).epsilon(exact));
}

namespace {

// What is asked of a slider-crank that runs through its poses `s` times as fast as it stands: what the limits are on, a column each.
struct Demands {
  Eigen::MatrixXd force, rate;             // of the actuator
  Eigen::MatrixXd reactions;               // 6 a joint
  Eigen::ArrayXXd all(int joints) const {  // in the order of FeasibleSpeed::limits, ball joints with their moments of zero
    Eigen::ArrayXXd out(force.rows(), 3 + 2 * joints);
    out << force.array().abs(), rate.array().abs(), (force.array() * rate.array()).abs(), Eigen::ArrayXXd::Zero(force.rows(), 2 * joints);
    for (Eigen::Index k = 0; k < force.rows(); ++k)
      for (int j = 0; j < joints; ++j) {
        out(k, 3 + j) = reactions.row(k).segment<3>(6 * j).norm();
        out(k, 3 + joints + j) = reactions.row(k).segment<3>(6 * j + 3).norm();
      }
    return out;
  }
};

Demands running(const Machine& machine, double s) {
  constexpr int poses = 11;
  const int joints = static_cast<int>(machine.topology().joints.size());
  Demands out{Eigen::MatrixXd(poses, 1), Eigen::MatrixXd(poses, 1), Eigen::MatrixXd(poses, 6 * joints)};
  const JointFrames frames(machine);
  Loading loading;
  loading.platform << 20, -10, 5, 0, 0, 3;
  loading.gravity << 0, -9.81, 0;
  for (int k = 0; k < poses; ++k) {  // theta = 0.8 + 0.3 sin 2 t
    const double t = 0.3 * k, q = 0.8 + 0.3 * std::sin(2 * t), rate = s * 0.6 * std::cos(2 * t),
                 acceleration = -s * s * 1.2 * std::sin(2 * t);
    State state;
    evaluate(machine, &q, &rate, &acceleration, state);
    out.force(k, 0) = virtual_work(machine, state, tangent(machine, state), loading).total()(0);
    out.rate(k, 0) = state.actuators[0].rate;
    const JointReactions r =
        dense_reactions(machine, state, generic_model(machine, state), frames, loading, characteristic_length(machine));
    for (int j = 0; j < joints; ++j) out.reactions.row(k).segment<6>(6 * j) = r.joints[static_cast<std::size_t>(j)].transpose();
  }
  return out;
}

}  // namespace

TEST_CASE("a machine that runs as fast as it may meets the limit that binds, there, and breaks none") {
  const Machine machine = pmreport::test::make(pmreport::test::slider_crank());
  const int joints = static_cast<int>(machine.topology().joints.size());
  const auto unlimited = static_cast<std::size_t>(joints);
  const Demands rest = running(machine, 0), moving = running(machine, 1);
  const MotionForces forces{rest.force, moving.force - rest.force, moving.rate, rest.reactions, moving.reactions - rest.reactions};
  const Eigen::ArrayXXd at_rest = rest.all(joints), in_motion = moving.all(joints);
  int tried = 0;
  for (Eigen::Index column = 0; column < at_rest.cols(); ++column) {
    const double largest = std::max(at_rest.col(column).maxCoeff(), in_motion.col(column).maxCoeff());
    if (largest < 1e-9) continue;  // the moment of a ball
    const double limit = 1.5 * largest;
    CAPTURE(column, limit);
    MotionLimits limits{{infinity}, {infinity}, {infinity}, std::vector(unlimited, infinity), std::vector(unlimited, infinity)};
    (column < 3            ? std::array{&limits.force, &limits.speed, &limits.power}[static_cast<std::size_t>(column)]->front()
     : column < 3 + joints ? limits.joint_force[static_cast<std::size_t>(column - 3)]
                           : limits.joint_moment[static_cast<std::size_t>(column - 3 - joints)]) = limit;
    const FeasibleSpeed f = feasible_speed(forces, limits);
    REQUIRE(f.scale > 0);
    REQUIRE(std::isfinite(f.scale));
    const Eigen::ArrayXXd fast = running(machine, f.scale).all(joints), faster = running(machine, 1.001 * f.scale).all(joints);
    // Reactions of the system over all bodies are good to some 1e-12, and differences of them likewise.
    CHECK(fast(f.sample, column) == Approx(limit).epsilon(1e-10));
    CHECK(fast.col(column).maxCoeff() <= limit * (1 + 1e-10));
    CHECK(faster(f.sample, column) > limit);
    ++tried;
  }
  CHECK(tried == 3 + joints + 2);  // forces in four joints, moments in two
}
