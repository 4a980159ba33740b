// What the elements of the mechanisms carry: self-stresses that elasticity settles, preload, weight, and their shares in a deflection.
#include <core/mechanics/stiffness/elastic_split.hpp>
#include <tests/plugins/elastic_machines.hpp>

#include <Eigen/Dense>

using namespace pmreport;
using namespace pmreport::mechanics;
using namespace test;
using Eigen::Vector3d;
using Eigen::VectorXd;

TEST_CASE("the stiffer of two redundant limbs carries what both could") {
  // Limbs 2 and 3 hold the platform along X by one force between them. With limb 3 a thousand times as stiff, limb 2 is left a thousandth.
  Machine m = made("p2prpu-prps");
  ElasticSettings settings;
  for (const Element& e : m.topology().elements)
    if (e.name == "limb3" || e.name == "rail3") {
      Element stiffer = e;
      stiffer.material.modulus *= 1e3, stiffer.material.shear_modulus *= 1e3;
      settings.added.push_back(stiffer);
    }
  const auto shares = [&] {
    InverseDynamics dynamics(m);
    MotionReactions r;
    std::vector<double> jets(15, 0.0), loads{1000, 0, 0, 0, 0, 0};
    const VectorXd q = m.home();
    for (std::size_t i = 0; i < 5; ++i) jets[3 * i] = q(static_cast<Eigen::Index>(i));
    dynamics.solve(1, jets.data(), loads.data(), Vector3d::Zero(), r);
    std::vector<Vector6d> joints(m.topology().joints.size());
    for (std::size_t i = 0; i < 6 * joints.size(); ++i) joints[i / 6](static_cast<Eigen::Index>(i % 6)) = r.joints[i];
    const auto answer = ElasticSplit(m).add(m.home_pose().numbers.data(), 1, r, 0, 1, joints);
    CHECK(answer.settled == 2);
    CHECK(answer.open.empty());
    return std::pair(joints[static_cast<std::size_t>(joint_named(m, "U2"))](0), joints[static_cast<std::size_t>(joint_named(m, "U3"))](0));
  };
  const auto [even2, even3] = shares();
  CHECK(even2 == Approx(even3).epsilon(1e-9));  // mirror images, loaded in their mirror
  m.give(settings);
  const auto [left2, left3] = shares();
  CHECK(left2 + left3 == Approx(even2 + even3).epsilon(1e-9));
  CHECK(std::abs(left2 / left3) < 3e-3);
}

TEST_CASE("a self-stress that no element gives energy is left open, and told") {
  Machine m = made("p2prpu-prps");
  std::vector<Element> drives;
  for (int i = 0; i < 5; ++i) drives.push_back(spring_drive("k" + std::to_string(i), i, 1e7));
  m.give(only(m, drives));
  const ElasticPose at = at_home(m);
  CHECK(at.known);
  CHECK(at.settled == 0);
  CHECK(at.open == 2);
  // The couple along n is held by joints alone.
  CHECK(rank_of(at.compliance, characteristic_length(m)) == 5);
  CHECK_FALSE(stiffness_of(at.compliance, characteristic_length(m)));
}

TEST_CASE("elements that no self-stress meets settle none, not even by rounding") {
  Machine m = made("2q-spr");
  m.give(only(m, {bearing("seat", joint_named(m, "R3"), 1e8, 1e8)}));
  const ElasticPose at = at_home(m, (Vector6d() << 30, -20, 50, 3, -2, 4).finished(), down);
  CHECK(at.settled == 0);
  CHECK(at.open == 6);
  CHECK(at.forces.cwiseAbs().maxCoeff() < 1e4);
}

TEST_CASE("a rail that is too long pushes its slider outward, on either side of zero") {
  Machine m = made("p2prpu-prps");
  ElasticSettings settings = only(m, {m.topology().elements[1]});
  REQUIRE(m.topology().elements[1].name == "rail1");
  settings.misfits = {{"rail1", 1e-3}};
  m.give(settings);
  for (const double y : {0.2, -0.2}) {
    VectorXd q = m.home();
    q(1) = y;
    const ElasticPose at = Elastostatics(m).at(q, Vector6d::Zero(), Vector3d::Zero(), everything);
    CHECK(at.by_strain(1) == Approx(y > 0 ? 1e-3 : -1e-3).epsilon(1e-9));
  }
}

TEST_CASE("what a beam carries does not ask whether it gives") {
  for (const char* how : {"full", "couples"}) {
    const Machine m = made("p2prpu-prps", {{"limb_bending", {choice(plugin("p2prpu-prps"), "limb_bending", how)}}});
    const ElasticPose at = at_home(m, (Vector6d() << 0, 100, 0, 0, 0, 0).finished());
    REQUIRE(m.topology().elements[0].name == "limb1");
    CHECK(beam_forces(at, m.topology().elements.size(), at.forces)[0].bending == Approx(100 * at.parts.lengths[0]).epsilon(1e-9));
  }
}

TEST_CASE("the platform's weight hangs on its own compliance, as its mass swings on it") {
  Machine m = made("gough");
  ElasticSettings settings = only(m, {});
  settings.platform = 1e-6 * Matrix6d::Identity();
  m.give(settings);
  const ElasticPose at = at_home(m, Vector6d::Zero(), down);
  const double weight = m.topology().bodies[static_cast<std::size_t>(m.topology().platform)].inertia.mass * 9.81;
  CHECK(at.by_weights(2) == Approx(-1e-6 * weight).epsilon(1e-9));
  // g / omega^2 is the sag of a mass on a spring.
  const double omega = 2 * pi * whole_modes(at, 6).front().frequency;
  CHECK(9.81 / (omega * omega) == Approx(1e-6 * weight).epsilon(1e-3));
}

TEST_CASE("warmer legs move the platform as longer ones do") {
  Machine m = made("gough");
  VectorXd q = m.home();
  q << 0.05, -0.08, 0.97, 0.1, -0.05, 0.12;
  const double warmer = 20;
  ElasticSettings settings;
  settings.warmer = warmer;
  m.give(settings);
  const ElasticPose at = Elastostatics(m).at(q, Vector6d::Zero(), Vector3d::Zero(), everything);
  // G^-1 takes changes of the legs' lengths to the platform's displacement.
  const Pose pose = m.pose({q.data(), 6});
  Vector6d longer;
  for (int i = 0; i < 6; ++i) longer(i) = steel.expansion * warmer * pose.numbers[m.layout().actuator(i)];
  const Vector6d expected = m.jacobian(pose).matrix.inverse() * longer;
  CHECK((at.by_strain - expected).norm() <= 1e-12 * expected.norm());
  CHECK(at.forces.cwiseAbs().maxCoeff() <= 1e-9);  // nothing opposes it
}

TEST_CASE("a limb that is too long preloads its twin, and the load is shared no differently for it") {
  Machine m = made("p2prpu-prps");
  ElasticSettings settings;
  settings.misfits = {{"rail2", 50e-6}};
  m.give(settings);
  const ElasticPose alone = at_home(m);
  REQUIRE(alone.forces.cwiseAbs().maxCoeff() > 0.1);
  // Preload is self-stress: no load, no work on the platform.
  const VectorXd c = [&] {
    VectorXd out(static_cast<Eigen::Index>(alone.parts.springs.size()));
    for (std::size_t i = 0; i < alone.parts.springs.size(); ++i) out(static_cast<Eigen::Index>(i)) = alone.parts.springs[i].compliance;
    return out;
  }();
  CHECK((alone.unit.transpose() * c.cwiseProduct(alone.forces)).norm() <= 1e-9 * c.cwiseProduct(alone.forces).norm() * alone.unit.norm());
  const Vector6d load = (Vector6d() << 100, -40, 60, 0, 0, 0).finished();
  const ElasticPose both = at_home(m, load);
  CHECK((both.forces - alone.forces - both.loaded).norm() <= 1e-9 * both.loaded.norm());
  CHECK((both.by_strain - alone.by_strain).norm() <= 1e-12 * alone.by_strain.norm());
}

TEST_CASE("shares of the elements sum to the deflection they make") {
  for (const char* name : {"gough", "2q-spr", "p2prpu-prps", "parallel-cross", "delta"}) {
    CAPTURE(name);
    const Machine m = made(name);
    const ElasticPose at = at_home(m, (Vector6d() << 40, -25, 60, 1, 2, -1).finished(), down);
    const Vector6d along = (Vector6d() << Vector3d(1, -2, 0.5).normalized(), Vector3d::Zero()).finished();
    double sum = 0;
    for (const double x : shares(at, m.topology().elements.size(), along, at.loaded, false)) sum += x;
    CHECK(sum == Approx(along.dot(at.deflection)).epsilon(1e-9));
  }
}

TEST_CASE("the foot of a limb that a force bends carries force times length") {
  Machine m = made("p2prpu-prps");
  m.give([&] {  // limb 2 carries what there is along X
    ElasticSettings s;
    s.misfits = {};
    return s;
  }());
  const ElasticPose at = at_home(m, (Vector6d() << 0, 100, 0, 0, 0, 0).finished());
  // Along Y limb 1 alone holds the platform, by its ball: a cantilever clamped at its hinge, whose axis is Y.
  const auto& elements = m.topology().elements;
  for (std::size_t e = 0; e < elements.size(); ++e)
    if (elements[e].name == "limb1") {
      const BeamForces f = beam_forces(at, elements.size(), at.forces)[e];
      CHECK(f.bending == Approx(100 * at.parts.lengths[e]).epsilon(1e-9));
      CHECK(f.torque <= 1e-9);
      CHECK(buckling_load(elements[e], at.parts.lengths[e]) ==
            Approx(pi * pi * 2.1e11 * pi * std::pow(0.03, 4) / 64 / std::pow(at.parts.lengths[e], 2)));
    }
}

TEST_CASE("what presses a leg shrinks evenly as its platform is lifted, also where its upper end is pulled harder") {
  const Machine m = made("gough");
  std::vector<double> pressing;
  bool pulled_harder = false;
  for (double lift = 0; lift <= 2000; lift += 20) {
    const ElasticPose at = at_home(m, (Vector6d() << 0, 0, lift, 0, 0, 0).finished(), down);
    const BeamForces leg = beam_forces(at, m.topology().elements.size(), at.forces)[0];
    pressing.push_back(leg.compression);
    pulled_harder = pulled_harder || (leg.axial > 0 && leg.compression > 0);
  }
  CHECK(pulled_harder);
  const double step = pressing[0] - pressing[1];
  REQUIRE(step > 0);
  for (std::size_t i = 1; i < pressing.size(); ++i)
    CHECK(pressing[i] == Approx(std::max(0.0, pressing[0] - static_cast<double>(i) * step)).margin(1e-9 * pressing[0]));
  CHECK(pressing.back() == 0);
}
