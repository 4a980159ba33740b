// Joint reactions, against free-body diagrams of the textbooks, and structures that rigid bodies do not determine.
#include <core/mechanics/reactions/reactions.hpp>

#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <tests/mechanics/massive.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double rounding = 1e-11;  // of a dense factorisation at condition numbers of about 100
const test::RotorNumbers rotor;

struct Solved {
  State state;
  JointFrames frames;
  double length;
  JointReactions reactions;
  VectorXd required;

  Solved(const Machine& machine, State s, const Loading& loading)
      : state(std::move(s)),
        frames(machine),
        length(characteristic_length(machine)),
        reactions(dense_reactions(machine, state, generic_model(machine, state), frames, loading, length)),
        required(inertial_wrenches(machine, state) - applied_wrenches(machine, state, loading)) {}

  const Vector6d& operator[](int joint) const { return reactions.joints[static_cast<std::size_t>(joint)]; }
  bool unique(int joint, int component) const { return (reactions.indeterminate[static_cast<std::size_t>(joint)] >> component & 1) == 0; }
};

Vector6d wrench(const Vector3d& force, const Vector3d& moment) { return (Vector6d() << force, moment).finished(); }

// What the rotor's bearings must give together, about O, in base axes: its own demand, less weight and load.
Vector6d demand(double theta, double w, double e, const Vector3d& gravity, const Vector6d& load) {
  const Eigen::AngleAxisd turn(theta, Vector3d::UnitZ());
  const double x = rotor.centre.x(), y = rotor.centre.y();
  const Vector3d c = turn * rotor.centre, weight = rotor.mass * gravity, at = turn * test::Rotor<1>::origin();
  const Vector3d force = turn * (rotor.mass * Vector3d(-x * w * w - y * e, -y * w * w + x * e, 0)) - weight - load.head<3>();
  const Vector3d moment = turn * Vector3d(rotor.xz * e - rotor.yz * w * w, rotor.yz * e + rotor.xz * w * w, rotor.zz * e) -
                          c.cross(weight) - at.cross(load.head<3>()) - load.tail<3>();
  return wrench(force, moment);
}

constexpr double theta = 0.7, speed = 5, acceleration = 11;
const Vector3d gravity(2, -3, -9);
const Vector6d load = (Vector6d() << 10, -20, 30, 4, 5, -6).finished();

}  // namespace

TEST_CASE("one bearing gives an unbalanced rotor all that it needs but the motor's torque") {
  const Machine machine = test::make_rotor();
  const Solved s(machine, test::state_of(machine, theta, speed, acceleration), {load, gravity});
  const Vector6d all = demand(theta, speed, acceleration, gravity, load);
  Vector6d bearing = all;
  bearing(5) = 0;
  CHECK((s[0] - bearing).norm() < rounding * all.norm());
  CHECK(s.reactions.actuator_forces(0) == Approx(all(5)).epsilon(rounding));
  CHECK(s.reactions.stresses.empty());
  CHECK(s.reactions.indeterminate[0] == 0);
  CHECK(s.reactions.residual < rounding);
}

TEST_CASE("two equal bearings share by symmetry, and couples by the least norm") {
  // Forces go half and half. A couple C across the axis is carried by forces +-F, 2 d F of it, and by moments m in each: 2 d F + 2 m = C
  // with 2 F^2 + 2 m^2 / L^2 least gives F = C d / (2 (d^2 + L^2)), m = C L^2 / (2 (d^2 + L^2)).
  const Machine machine = test::make_rotor_on_two_bearings();
  const Solved s(machine, test::state_of(machine, theta, speed, acceleration), {load, gravity});
  const Vector6d all = demand(theta, speed, acceleration, gravity, load);
  const double d = test::Rotor<2>::apart, reach = test::Rotor<2>::origin().x(), length = std::sqrt(d * d + reach * reach);
  CHECK(s.length == Approx(length).epsilon(rounding));
  Vector3d couple = all.tail<3>();
  couple.z() = 0;
  const Vector3d z = Vector3d::UnitZ(), share = couple.cross(z) * d / (2 * (d * d + length * length));
  const Vector3d moment = couple * length * length / (2 * (d * d + length * length));
  CHECK((s[0] - wrench(all.head<3>() / 2 - share, moment)).norm() < rounding * all.norm());
  CHECK((s[1] - wrench(all.head<3>() / 2 + share, moment)).norm() < rounding * all.norm());
  CHECK(s.reactions.actuator_forces(0) == Approx(all(5)).epsilon(rounding));
  CHECK(s.reactions.residual < rounding);

  // Five constraints too many: all that a bearing can give is shared; that it gives no moment about its axis is sure.
  CHECK(s.reactions.stresses.size() == 5);
  for (int bearing = 0; bearing < 2; ++bearing)
    for (const int component : {0, 1, 2, 4, 5}) CHECK_FALSE(s.unique(bearing, component));
  for (int bearing = 0; bearing < 2; ++bearing) CHECK(s.unique(bearing, 3));
  for (const auto& stress : s.reactions.stresses)
    CHECK(free_body_residual(machine, s.state, stress, VectorXd::Zero(1), VectorXd::Zero(6), s.length) < rounding);
}

TEST_CASE("every pin of an engine as by the free-body diagrams of its parts") {
  using E = test::Engine;
  const Machine machine = test::make_engine();
  const double w = 30, e = 400, gas = -800, g = 9.81;
  for (const double t : {0.4, 1.2, 2.0, 2.7}) {
    CAPTURE(t);
    const Solved s(machine, test::state_of(machine, t, w, e), {wrench({gas, 0, 0}, Vector3d::Zero()), {0, -g, 0}});

    // Rod angle phi below the line of the cylinder, positive when A is above it.
    const double phi = std::asin(E::r * std::sin(t) / E::l), c = std::cos(phi), q = std::sin(phi);
    const double phi_1 = E::r * std::cos(t) * w / (E::l * c);
    const double phi_2 = (E::r * std::cos(t) * e - E::r * std::sin(t) * w * w + E::l * q * phi_1 * phi_1) / (E::l * c);
    const double ax = -E::r * (std::sin(t) * e + std::cos(t) * w * w), ay = E::r * (std::cos(t) * e - std::sin(t) * w * w);
    const auto rod_x = [&](double along) { return ax - along * (q * phi_2 + c * phi_1 * phi_1); };
    const auto rod_y = [&](double along) { return ay - along * (c * phi_2 - q * phi_1 * phi_1); };

    // Piston, along x: the rod's push. Rod, moments about A, turning by -phi: the rest of the force at B. Then forces of rod and crank.
    const double bx = E::piston_mass * rod_x(E::l) - gas;
    const double gx = E::rod_mass * rod_x(E::rod_centre), gy = E::rod_mass * (rod_y(E::rod_centre) + g);
    const double about_a = -E::rod_inertia * phi_2 + E::rod_centre * (c * gy + q * gx);
    const double by = (E::l * q * -bx - about_a) / (E::l * c);  // l (c F_y + q F_x) = about_a with F = -(bx, by)
    const double side = E::piston_mass * g - by;
    const double pin_x = gx + bx, pin_y = gy + by;  // of the crank on the rod
    const double kx = E::crank_mass * E::crank_centre / E::r * ax, ky = E::crank_mass * (E::crank_centre / E::r * ay + g);
    const double torque = (E::crank_inertia * e + E::crank_centre * (std::cos(t) * ky - std::sin(t) * kx)) +
                          E::r * (std::cos(t) * pin_y - std::sin(t) * pin_x);

    const double size = std::abs(bx) + std::abs(pin_x) + std::abs(pin_y);
    CHECK(s.reactions.actuator_forces(0) == Approx(torque).epsilon(rounding));
    CHECK((s[0].head<2>() - Eigen::Vector2d(kx + pin_x, ky + pin_y)).norm() < rounding * size);  // base on crank
    CHECK((s[1].head<2>() - Eigen::Vector2d(pin_x, pin_y)).norm() < rounding * size);            // crank on rod
    CHECK((s[2].head<2>() - Eigen::Vector2d(bx, by)).norm() < rounding * size);                  // rod on piston
    CHECK(std::abs(s[3](1) - side) < rounding * size);                                           // cylinder on piston
    CHECK(std::abs(s[3](0)) < rounding * size);
    CHECK(std::abs(s[3](5)) < rounding * size * E::l);  // the pin at B is in the piston's centre of mass

    // A plane linkage knows its forces in the plane. Across it the loads are nil, and so is the least norm; but nothing tells that nobody
    // has bent the pins: force along z, moments about x and y.
    CHECK(s.reactions.stresses.size() == 3);
    for (int pin = 0; pin < 3; ++pin) {
      CHECK(std::abs(s[pin](2)) < rounding * size);
      CHECK(s[pin].segment<2>(3).norm() < rounding * size * E::l);
      for (const int base : {6 + 0, 6 + 1, 6 + 5}) CHECK(s.unique(pin, base));
      for (const int base : {6 + 2, 6 + 3, 6 + 4}) CHECK_FALSE(s.unique(pin, base));
    }
    for (const int base : {6 + 0, 6 + 1, 6 + 5}) CHECK(s.unique(3, base));
    for (const int base : {6 + 2, 6 + 3, 6 + 4}) CHECK_FALSE(s.unique(3, base));
  }
}

TEST_CASE("the shaking force of an engine is the change of all its momentum") {
  using E = test::Engine;
  const Machine machine = test::make_engine();
  const double t = 2.1, w = 30, e = -100;
  const Solved s(machine, test::state_of(machine, t, w, e), {});
  const auto momentum = [&](double time) {
    const double angle = t + w * time + 0.5 * e * time * time, rate = w + e * time;
    const double phi = std::asin(E::r * std::sin(angle) / E::l), phi_1 = E::r * std::cos(angle) * rate / (E::l * std::cos(phi));
    const Eigen::Vector2d a(-E::r * std::sin(angle) * rate, E::r * std::cos(angle) * rate);
    const auto on_rod = [&](double along) {
      return Eigen::Vector2d(a.x() - along * std::sin(phi) * phi_1, a.y() - along * std::cos(phi) * phi_1);
    };
    return Eigen::Vector2d(E::crank_mass * E::crank_centre / E::r * a + E::rod_mass * on_rod(E::rod_centre) +
                           E::piston_mass * Eigen::Vector2d(on_rod(E::l).x(), 0));
  };
  constexpr double h = 1e-4;  // [s] at 30 rad/s; fourth order: (3e-3)^4 = 1e-10
  const Eigen::Vector2d change = (8.0 * (momentum(h) - momentum(-h)) - (momentum(2 * h) - momentum(-2 * h))) / (12 * h);
  const Eigen::Vector2d from_base = s[0].head<2>() + s[3].head<2>();
  CHECK((from_base - change).norm() < 1e-8 * change.norm());
}

TEST_CASE("the residual of the free bodies finds what is wrong with any reaction") {
  const Machine machine = test::make_engine();
  const Solved s(machine, test::state_of(machine, 1.3, 30, 400), {wrench({-800, 0, 0}, Vector3d::Zero()), {0, -9.81, 0}});
  const auto residual = [&](const std::vector<Vector6d>& joints, const VectorXd& forces, const VectorXd& required) {
    return free_body_residual(machine, s.state, joints, forces, required, s.length);
  };
  REQUIRE(residual(s.reactions.joints, s.reactions.actuator_forces, s.required) < rounding);
  double largest = s.required.lpNorm<Eigen::Infinity>();
  for (const Vector6d& w : s.reactions.joints) largest = std::max(largest, w.lpNorm<Eigen::Infinity>());
  for (std::size_t j = 0; j < 4; ++j)
    for (int c = 0; c < 6; ++c) {
      CAPTURE(j, c);
      std::vector<Vector6d> wrong = s.reactions.joints;
      wrong[j](c) += 1e-3 * largest * (c < 3 ? 1 : s.length);
      const double seen = residual(wrong, s.reactions.actuator_forces, s.required);
      CHECK(seen > 1e-4);  // relative to the largest moment per length, if that is more than the largest force
      CHECK(seen < 1e-2);
    }
  VectorXd torque = s.reactions.actuator_forces;
  torque(0) += 1e-3 * largest * s.length;
  CHECK(residual(s.reactions.joints, torque, s.required) > 1e-4);
  VectorXd required = s.required;
  for (Eigen::Index i = 0; i < required.size(); ++i) {
    required(i) += 1e-3 * largest;
    CHECK(residual(s.reactions.joints, s.reactions.actuator_forces, required) > 1e-4);
    required(i) = s.required(i);
  }
  // A self-stress on top leaves it.
  std::vector<Vector6d> stressed = s.reactions.joints;
  for (std::size_t j = 0; j < 4; ++j) stressed[j] += 100 * s.reactions.stresses[0][j];
  CHECK(residual(stressed, s.reactions.actuator_forces, s.required) < rounding);
}

TEST_CASE("a component is shared when a stress reaches it, in joint axes and in base axes") {
  // One stress at the pin O of the engine, whose axis 1 is z and axis 2 x at home: z force 1, and a moment about y far below it.
  const Machine machine = test::make_engine();
  const State home = test::state_of(machine, machine.home()(0), 0, 0);
  std::vector<Vector6d> stress(4, Vector6d::Zero());
  stress[0] = wrench({0, 0, 1}, {0, 1e-9, 0});
  const auto shared = indeterminate_components(home, JointFrames(machine), {stress}, 0.1);
  CHECK(shared[0] == (1 << 0 | 1 << (6 + 2)));
  CHECK(shared[1] == 0);
  stress[3] = wrench(Vector3d::Zero(), {0, 0, 0.02});  // cylinder: axis 1 is x, axis 2 y
  CHECK(indeterminate_components(home, JointFrames(machine), {stress}, 0.1)[3] == (1 << 5 | 1 << (6 + 5)));
}

TEST_CASE("a wrench in axes is its components along them") {
  const Eigen::Matrix3d frame = Eigen::AngleAxisd(0.5, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Vector6d w = wrench(2 * frame.col(0) - frame.col(2), 3 * frame.col(1));
  CHECK((in_axes(frame, w) - wrench({2, 0, -1}, {0, 3, 0})).norm() < 1e-14);
}

TEST_CASE("a weight in the middle reaches the platform along six limbs alike") {
  const double weight = 600;
  for (const test::BaseJoint base : {test::BaseJoint::ball, test::BaseJoint::universal}) {
    const Machine machine = test::make_hexapod(base);
    const Eigen::VectorXd q = machine.home(), zero = Eigen::VectorXd::Zero(6);
    State home;
    evaluate(machine, q.data(), zero.data(), zero.data(), home);
    const Solved s(machine, home, {wrench({0, 0, -weight}, Vector3d::Zero()), Vector3d::Zero()});
    const auto limbs = limb_wrenches(machine, s.state, s.reactions);
    REQUIRE(limbs.size() == 6);
    for (int i = 0; i < 6; ++i) {
      const std::string n = std::to_string(i + 1);
      const Vector3d a = s.state.joints[static_cast<std::size_t>(test::joint_named(machine, "A" + n))].centre;
      const Vector3d b = s.state.joints[static_cast<std::size_t>(test::joint_named(machine, "B" + n))].centre;
      const Vector3d along = (b - a).normalized(), force = along * weight / 6 / along.z();
      CHECK((limbs[static_cast<std::size_t>(i)] - wrench(force, (b - s.state.bodies[1].origin).cross(force))).norm() < rounding * weight);
      CHECK(s.reactions.actuator_forces(i) == Approx(weight / 6 / along.z()).epsilon(rounding));
    }
    CHECK(s.reactions.residual < rounding);
    // The slide of a leg that hangs in two balls may be twisted or bent by nothing.
    CHECK(s.reactions.stresses.empty());
  }
}

TEST_CASE("where an actuator has lost its lever the reactions say that the pose is singular") {
  // Dead centre of the spatial slider-crank: the rod in the plane of crank pin and crank axis, no lever about the crank.
  const Machine machine = test::make(test::slider_crank());
  const auto lever = [&](double angle) {
    const State s = test::state_of(machine, angle, 0, 0);
    REQUIRE(s.status == PM_OK);
    return s.joints[1].centre.cross(s.bodies[2].rotation.col(2)).z();
  };
  double low = 2.0, high = 4.5;
  REQUIRE(lever(low) * lever(high) < 0);
  for (int i = 0; i < 60; ++i) (lever(low) * lever(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  CHECK(Solved(machine, test::state_of(machine, low, 0, 0), {load, gravity}).reactions.singular);
  CHECK_FALSE(Solved(machine, test::state_of(machine, low - 0.3, 0, 0), {load, gravity}).reactions.singular);
}
