// How the mechanisms give way and vibrate, against other ways to the same: exact cases, energies of displaced geometries, one system over
// all bodies.
#include <core/linear/eigenvalues.hpp>
#include <core/mechanics/dynamics/momentum.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <core/mechanics/stiffness/answers.hpp>
#include <core/mechanics/stiffness/elastic_split.hpp>
#include <core/mechanics/stiffness/whole_system.hpp>
#include <pmreport/elastic.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/elastic_machines.hpp>

#include <Eigen/Dense>
#include <numbers>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace test;

namespace {

void give_drives(Machine& m, double k) {
  std::vector<Element> drives;
  for (std::size_t i = 0; i < m.topology().actuators.size(); ++i)
    drives.push_back(spring_drive("k" + std::to_string(i + 1), static_cast<int>(i), k));
  m.give(only(m, drives));
}

// Legs along the edges of a cube, joints on its two triangles Hc apart (Jafari and McInroy's cubic hexapod), platform in the middle.
constexpr double cube = 0.1, thickness = 0.04, mass = 6;
Machine cubic_hexapod() {
  const double radius = cube * std::sqrt(3.0) * std::sqrt(2.0 / 3);
  std::vector<double> base, top;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 2; ++k) {
      const double low = 2 * pi / 3 * i, high = low + (k == 1 ? 1 : -1) * pi / 3;
      for (const double x : {radius * std::cos(low), radius * std::sin(low), -cube / 2}) base.push_back(x);
      for (const double x : {radius * std::cos(high), radius * std::sin(high), cube / 2}) top.push_back(x);
    }
  return made("gough", {{"base_points", base},
                        {"platform_points", top},
                        {"home_position", {0, 0, 0}},
                        {"stroke_min", {0.05}},
                        {"stroke_max", {0.5}},
                        {"platform_mass", {mass}},
                        {"platform_thickness", {thickness}},
                        {"platform_radius", {radius}}});
}

Vector6d scaled(const Vector6d& d, double length) { return (Vector6d() << d.head<3>(), length * d.tail<3>()).finished(); }
double difference(const Matrix6d& a, const Matrix6d& b, double length) {
  const Vector6d s = (Vector6d() << 1, 1, 1, Vector3d::Constant(1 / length)).finished();
  return Matrix6d(s.asDiagonal() * (a - b) * s.asDiagonal()).norm() / Matrix6d(s.asDiagonal() * b * s.asDiagonal()).norm();
}

}  // namespace

TEST_CASE("the stiffness of a cubic hexapod is k diag(2, 2, 2, 0.015, 0.015, 0.06)") {
  Machine m = cubic_hexapod();
  const double k = 3e6;
  give_drives(m, k);
  const ElasticPose at = at_home(m);
  REQUIRE(at.known);
  const auto stiffness = stiffness_of(at.compliance, characteristic_length(m));
  REQUIRE(stiffness);
  const Vector6d expected = k * (Vector6d() << 2, 2, 2, 0.015, 0.015, 0.06).finished();
  CHECK((*stiffness - Matrix6d(expected.asDiagonal())).cwiseAbs().maxCoeff() <= 1e-11 * k);  // the inverse of a matrix of condition 133

  // Decoupled: each frequency is that of one spring under one mass, a solid disc.
  const double radius = cube * std::sqrt(2.0), across = mass * (3 * radius * radius + thickness * thickness) / 12;
  std::vector<double> f;
  for (int i = 0; i < 6; ++i) f.push_back(std::sqrt(expected(i) / (i < 3 ? mass : i < 5 ? across : mass * radius * radius / 2)) / (2 * pi));
  std::sort(f.begin(), f.end());
  const auto all = modes(at.compliance, at.platform_inertia, characteristic_length(m));
  REQUIRE(all.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) CHECK(all[i].frequency == Approx(f[i]).epsilon(1e-12));
}

// Legs as springs along themselves: the energy of the displaced platform, by lengths of vectors alone, made least under a small load by
// Newton with differences in extended precision. It knows nothing of joints, reactions or G.
TEST_CASE("the compliance of a hexapod is that of springs between displaced points") {
  Machine m = made("gough");
  std::vector<double> k{15e6, 16e6, 14e6, 15.5e6, 16.5e6, 13e6};
  std::vector<Element> drives;
  for (int i = 0; i < 6; ++i) drives.push_back(spring_drive("k" + std::to_string(i), i, k[static_cast<std::size_t>(i)]));
  m.give(only(m, drives));
  VectorXd q = m.home();
  q << 0.07, -0.05, 0.99, 0.12, -0.09, 0.15;
  const Pose pose = m.pose({q.data(), 6});
  REQUIRE(pose.status == PM_OK);

  using Real = long double;
  using Vector = Eigen::Matrix<Real, 3, 1>;
  using Twist = Eigen::Matrix<Real, 6, 1>;
  std::vector<Vector> a, b;
  std::vector<Real> rest;
  const Vector p = m.origin(pose, m.topology().platform).cast<Real>();
  for (int i = 0; i < 6; ++i) {
    const std::string n = std::to_string(i + 1);
    a.push_back(m.centre(pose, joint_named(m, "A" + n)).cast<Real>());
    b.push_back(m.centre(pose, joint_named(m, "B" + n)).cast<Real>() - p);
    rest.push_back((p + b.back() - a.back()).norm());
  }
  // Forces of the springs on the platform, by the displacement d: what Newton makes equal to the load.
  const auto resistance = [&](const Twist& d) {
    const Vector w = d.tail<3>();
    const Real angle = w.norm();
    const Eigen::Matrix<Real, 3, 3> r = angle > 0 ? Eigen::AngleAxis<Real>(angle, w / angle).toRotationMatrix()
                                                  : Eigen::Matrix<Real, 3, 3>(Eigen::Matrix<Real, 3, 3>::Identity());
    Twist out = Twist::Zero();
    for (std::size_t i = 0; i < 6; ++i) {
      const Vector arm = r * b[i], leg = p + d.head<3>() + arm - a[i];
      const Real l = leg.norm(), force = static_cast<Real>(k[i]) * (l - rest[i]);
      const Vector f = leg / l * force;
      out.head<3>() += f;
      out.tail<3>() += arm.cross(f);
    }
    return out;
  };
  const ElasticPose at = Elastostatics(m).at(q, Vector6d::Zero(), Vector3d::Zero(), compliance_alone);
  REQUIRE(at.known);
  for (int c = 0; c < 6; ++c) {
    // Small enough for the geometry to stay linear to 1e-9, large enough for lengths of 1 m to tell it to 1e-9.
    const Real size = c < 3 ? 1e-2L : 1e-3L;
    Twist load = Twist::Zero(), d = Twist::Zero();
    load(c) = size;
    for (int iteration = 0; iteration < 8; ++iteration) {
      Eigen::Matrix<Real, 6, 6> slope;
      for (int i = 0; i < 6; ++i) {
        Twist step = Twist::Zero();
        step(i) = 1e-9L;
        slope.col(i) = (resistance(d + step) - resistance(d - step)) / 2e-9L;
      }
      d += slope.partialPivLu().solve(load - resistance(d));
    }
    const Vector6d seen = (d / size).cast<double>();
    CAPTURE(c, seen.transpose(), at.compliance.col(c).transpose());
    CHECK((scaled(seen - Vector6d(at.compliance.col(c)), 0.2)).norm() <= 1e-7 * scaled(at.compliance.col(c), 0.2).norm());
  }
}

TEST_CASE("on every mechanism the force method equals one system over all bodies, joints and springs") {
  std::mt19937_64 random(20261130);
  for (const test::Named& each : test::every_mechanism()) {
    const Machine& m = *each.machine;
    if (m.topology().elements.empty()) continue;
    const double length = characteristic_length(m);
    for (int trial = 0; trial < 3; ++trial) {
      const VectorXd q = test::random_motion(m, random).q;
      CAPTURE(each.name, q.transpose());
      Elastostatics statics(m);
      const ElasticPose at = statics.at(q, Vector6d::Zero(), down, everything);
      REQUIRE(at.known);
      const State state = state_at_rest(m, q);
      const WholeSystem whole(statics.plan(), state);
      const MatrixXd u = whole.under_unit_wrenches();
      const auto platform = [&](const MatrixXd& of) { return of.middleRows<6>(6 * m.topology().platform - 6); };
      CHECK(difference(at.compliance, platform(u), length) <= 1e-9);
      Matrix6d inertia = Matrix6d::Zero();
      for (std::size_t b = 1; b < state.bodies.size(); ++b) {
        const auto shape = u.middleRows<6>(6 * static_cast<Eigen::Index>(b) - 6);
        inertia += shape.transpose() * mass_matrix(m.topology().bodies[b].inertia, state.bodies[b]) * shape;
      }
      CHECK(difference(at.inertia, inertia, length) <= 1e-9);
      const Vector6d sag = platform(whole.displacements(weights(m, state, down)));
      CHECK(scaled(sag - at.by_weights, length).norm() <= 1e-9 * scaled(sag, length).norm());
    }
  }
}

// All bodies as one system: flexibility F of every body under every load on any, M their mass matrices, (F M) u = u / omega^2.
TEST_CASE("natural frequencies are those of all masses on the one system over all bodies") {
  std::mt19937_64 random(20261201);
  for (const test::Named& each : test::every_mechanism()) {
    const Machine& m = *each.machine;
    if (m.topology().elements.empty()) continue;
    const VectorXd q = test::random_motion(m, random).q;
    CAPTURE(each.name, q.transpose());
    Elastostatics statics(m);
    const ElasticPose at = statics.at(q, Vector6d::Zero(), Vector3d::Zero(), everything);
    REQUIRE(at.known);
    const State state = state_at_rest(m, q);
    const auto n = 6 * (static_cast<Eigen::Index>(state.bodies.size()) - 1);
    MatrixXd mass = MatrixXd::Zero(n, n);
    for (std::size_t b = 1; b < state.bodies.size(); ++b) {
      Inertia inertia = m.topology().bodies[b].inertia;
      if (m.topology().bodies[b].slender) inertia.about_centre(2, 2) = 0;  // an idle spin is nobody's
      mass.block<6, 6>(6 * static_cast<Eigen::Index>(b) - 6, 6 * static_cast<Eigen::Index>(b) - 6) = mass_matrix(inertia, state.bodies[b]);
    }
    const MatrixXd flexible = WholeSystem(statics.plan(), state).displacements(mass);  // F M
    Eigen::VectorXd values = flexible.eigenvalues().real();
    std::sort(values.begin(), values.end(), std::greater<>());
    const auto modes = whole_modes(at, 6);
    REQUIRE(modes.size() == 6);
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(modes[k].frequency == Approx(1 / (2 * pi * std::sqrt(values(static_cast<Eigen::Index>(k))))).epsilon(1e-7));
      // The shape under its own inertia is itself: A y = y / omega^2, and of unit kinetic energy in all masses.
      CHECK(modes[k].masses.norm() == Approx(1));
    }
  }
}

TEST_CASE("a compliance is symmetric, and its energy never negative") {
  for (const test::Named& each : test::every_mechanism()) {
    CAPTURE(each.name);
    const ElasticPose at = at_home(*each.machine);
    REQUIRE(at.known);
    const double length = characteristic_length(*each.machine);
    const Vector6d s = (Vector6d() << 1, 1, 1, Vector3d::Constant(1 / length)).finished();
    const auto values = linear::symmetric_eigen(Matrix6d(s.asDiagonal() * at.compliance * s.asDiagonal())).values;
    CHECK(values(0) >= -1e-14 * values(5));
    CHECK(values(5) > 0);
  }
}

TEST_CASE("a tool is as stiff as a machine whose reference point it were") {
  // By displacements: the tool at r moves by d + w x r, under a force there that has a moment about the reference point.
  Machine m = made("2q-spr");
  const ElasticPose at = at_home(m);
  const Vector3d r(0.03, -0.02, 0.11), force(3, -7, 2), moment(0.5, 0.1, -0.3);
  const Vector6d w = (Vector6d() << force, moment + r.cross(force)).finished(), d = at.compliance * w;
  const Vector3d tool = d.head<3>() + Vector3d(d.tail<3>()).cross(r);
  const Matrix6d t = to_tool(r, Matrix3d::Identity());
  const Vector6d seen = t.transpose() * at.compliance * t * (Vector6d() << force, moment).finished();
  CHECK((seen.head<3>() - tool).norm() <= 1e-13 * tool.norm());
  CHECK((seen.tail<3>() - d.tail<3>()).norm() <= 1e-13 * d.tail<3>().norm());
}

TEST_CASE("elements a thousand times as stiff leave a thousandth of the compliance, and the split of the reactions") {
  Machine soft = made("p2prpu-prps"), stiff = made("p2prpu-prps", {{"young_modulus", {2.1e14}}, {"shear_modulus", {8e13}}});
  const Vector6d load = (Vector6d() << 30, 15, 20, 1, 2, 3).finished();
  const ElasticPose a = at_home(soft, load, down), b = at_home(stiff, load, down);
  CHECK((1e3 * b.compliance - a.compliance).norm() <= 1e-12 * a.compliance.norm());
  CHECK((a.forces - b.forces).norm() <= 1e-9 * a.forces.norm());
}

TEST_CASE("at a singular pose there is no compliance") {
  Machine m = made("5pus-upu", {{"platform", {choice(plugin("5pus-upu"), "platform", "pentagon")}}});
  VectorXd level = VectorXd::Zero(5);  // the pentagon is singular where it is centred and level
  CHECK_FALSE(Elastostatics(m).at(level, Vector6d::Zero(), Vector3d::Zero(), compliance_alone).known);
}

TEST_CASE("a base and a platform that give are in series with the limbs") {
  Machine m = made("gough");
  VectorXd q = m.home();
  q << 0.05, -0.08, 0.97, 0.1, -0.05, 0.12;
  const Matrix6d limbs = Elastostatics(m).at(q, Vector6d::Zero(), Vector3d::Zero(), everything).compliance;
  ElasticSettings settings;
  const MatrixXd half = MatrixXd::Random(6, 6) * 1e-4;
  settings.platform = half * half.transpose();
  settings.base = half.transpose() * half;
  m.give(settings);
  const ElasticPose at = Elastostatics(m).at(q, Vector6d::Zero(), Vector3d::Zero(), everything);
  // A wrench on the platform, about the base's origin; what moves the base moves the platform with it.
  const Pose pose = m.pose({q.data(), 6});
  const int platform = m.topology().platform;
  const Matrix3d r = m.rotation(pose, platform);
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = r, turn.bottomRightCorner<3, 3>() = r;
  const Matrix6d shift = to_tool(m.origin(pose, platform), Matrix3d::Identity());
  const Matrix6d expected = limbs + turn * settings.platform * turn.transpose() + shift.transpose() * settings.base * shift;
  CHECK((at.compliance - expected).norm() <= 1e-12 * expected.norm());
}

TEST_CASE("elements are refused by what is wrong with them") {
  const Machine m = made("gough");
  const Topology& t = m.topology();
  const int a1 = joint_named(m, "A1"), b1 = joint_named(m, "B1"), b2 = joint_named(m, "B2");
  const auto fault = [&](const Element& e) { return fault_of(e, t); };
  CHECK(fault(beam("x", a1, b1, steel, solid(0.02))).empty());
  CHECK_THAT(fault(beam("x", a1, b2, steel, solid(0.02))), Catch::Contains("no bodies lead from joint A1 to joint B2"));
  CHECK_THAT(fault(beam("x", a1, b1, Material{-1, 1, 0}, solid(0.02))), Catch::Contains("expected a modulus above zero, seen -1 Pa"));
  CHECK_THAT(fault(beam("x", a1, b1, Material{std::nan(""), 1, 0}, solid(0.02))), Catch::Contains("expected a modulus above zero"));
  CHECK_THAT(fault(beam("1x", a1, b1, steel, solid(0.02))), Catch::Contains("begins with a letter"));
  CHECK_THAT(fault(beam("x", a1, 99, steel, solid(0.02))), Catch::Contains("joint 99 does not exist"));
  CHECK_THAT(fault(rail("x", a1, b1, steel, solid(0.02))), Catch::Contains("joint A1 is no slide with an actuator"));
  CHECK_THAT(fault(rail("x", joint_named(m, "P1"), b1, steel, solid(0.02), -0.1)), Catch::Contains("expected an offset from zero up"));
  CHECK_THAT(fault(spring_drive("x", 0, 0)), Catch::Contains("expected a stiffness above zero"));
  CHECK_THAT(fault(spring_drive("x", 6, 1e6)), Catch::Contains("actuator 6 does not exist"));
  CHECK_THAT(fault(bearing("x", b1, 1e6, -5)), Catch::Contains("above zero, seen -5"));
}
