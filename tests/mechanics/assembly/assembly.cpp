#include <core/mechanics/assembly/assembly.hpp>

#include <core/numbers.hpp>
#include <pmreport/mechanism.hpp>
#include <tests/mechanics/assembly/actuators_at.hpp>
#include <tests/mechanics/assembly/crank_angles.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using test::actuators_at, test::crank_angles, test::modes_at, test::shortly;

namespace {

// A rod of length L between a slider on X and a slider on Y: x^2 + y^2 = L^2. The slider on X drives and stands on one side of the other's
// axis, by the working mode; the slider on Y carries the load.
class Ellipsograph : public Mechanism<1> {
 public:
  static constexpr const char *name = "ellipsograph", *title = "ellipsograph", *source = "a test";
  static constexpr const char* sides[] = {"right", "left"};
  static constexpr Parameter parameters[] = {Parameter::working_mode("slider", sides, 0, "side of the driving slider")};
  static constexpr double length = 0.5;

  explicit Ellipsograph(const Parameters& p) : side_(p.choice("slider") == "right" ? 1 : -1) {}

  Topology topology() const {
    Topology t;
    t.coordinates = {{"y", "height", "m", 0.3, {0.2, 0.4}}};
    t.platform = t.add(Body{"platform", 0, false, {}});
    t.add(Body{"rod", 1, false, {}});
    t.add(Body{"slider", 1, false, {}});
    t.add(Joint{"P1", JointKind::prismatic, 0, 1, {}});
    t.add(Joint{"B", JointKind::revolute, 1, 2, {}});
    t.add(Joint{"C", JointKind::revolute, 2, 3, {}});
    t.add(Joint{"P2", JointKind::prismatic, 0, 3, {}});
    t.add(Actuator{"s", "slider", "m", 3, {0, 1}});
    t.constraints = {{"force_x", "", "N"}, {"force_z", "", "N"}, {"couple_x", "", "N*m"}, {"couple_y", "", "N*m"}, {"couple_z", "", "N*m"}};
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const T radicand = length * length - q[0] * q[0];
    at.require(radicand, "the rod is too short");
    const T s = side_ * sqrt(radicand);
    const Vector3<T> b(T(0.0), q[0], T(0.0)), c(s, T(0.0), T(0.0)), z = Eigen::Vector3d::UnitZ().cast<T>();
    const Vector3<T> along = (c - b) * T(1.0 / length);
    const Matrix3<T> level = Eigen::Matrix3d::Identity().cast<T>();
    at.body(1, b, level);
    at.body(2, b, frame_xz(along, z));
    at.body(3, c, level);
    at.joint(0, b, Vector3<T>(level.col(1)));
    at.joint(1, b, z);
    at.joint(2, c, z);
    at.joint(3, c, Vector3<T>(level.col(0)));
    at.actuator(0, s);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Constant(T(0.0));
    g(0, 1) = -at.origin(1)(1) / at.actuator(0);
    g(1, 0) = g(2, 2) = g(3, 3) = g(4, 4) = g(5, 5) = T(1.0);
    return g;
  }

 private:
  double side_;
};

}  // namespace

TEST_CASE("a slider-crank has the two assembly modes of a circle met by a sphere") {
  const Machine machine = test::make(test::slider_crank());
  for (const double theta : {0.5, 0.8, 1.2}) {
    const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, theta);
    const AssemblyModes found = modes_at(machine, q);
    REQUIRE(found.modes.size() == 2);
    const std::vector<double> expected = crank_angles(actuators_at(machine, q)(0));
    for (const AssemblyMode& m : found.modes) {
      const double nearest = std::min(std::abs(std::remainder(m.coordinates(0) - expected[0], 2 * pi)),
                                      std::abs(std::remainder(m.coordinates(0) - expected[1], 2 * pi)));
      CHECK(nearest < 1e-12);  // condition about 10, actuator to a few roundings
    }
    CHECK(found.modes[0].coordinates(0) == Approx(theta).epsilon(1e-12));
    CHECK(found.modes[0].distance < 1e-12);
    CHECK(found.modes[0].determinant * found.modes[1].determinant < 0);
  }
}

TEST_CASE("a serial arm has one assembly mode, and a whole turn more of its actuator is the same") {
  const Machine machine = test::make(test::arm());
  const Eigen::VectorXd q = machine.home();
  Eigen::VectorXd actuators = actuators_at(machine, q);
  CHECK(find_assembly_modes(machine, actuators, q).modes.size() == 1);
  for (int i = 0; i < machine.dof(); ++i)
    if (machine.topology().actuators[static_cast<std::size_t>(i)].sense() == Sense::rotary) actuators(i) += 2 * pi;
  const AssemblyModes turned = find_assembly_modes(machine, actuators, q);
  REQUIRE(turned.modes.size() == 1);
  CHECK(turned.modes[0].distance < 1e-9);
}

TEST_CASE("modes in another working mode are found, and left out when only the machine's own is asked for") {
  const Machine machine = test::make(contract::mechanism<Ellipsograph>);
  const Eigen::VectorXd home = machine.home();
  // x = -0.3 is the left side; y = +-0.4 there.
  const AssemblyModes found = find_assembly_modes(machine, Eigen::VectorXd::Constant(1, -0.3), home);
  REQUIRE(found.words.size() == 2);
  CHECK(found.words[0].name.empty());
  CHECK(found.words[1].name == "slider left");
  REQUIRE(found.modes.size() == 2);
  for (const AssemblyMode& m : found.modes) CHECK(m.word == 1);
  CHECK(found.modes[0].coordinates(0) == Approx(0.4).epsilon(1e-12));
  CHECK(found.modes[1].coordinates(0) == Approx(-0.4).epsilon(1e-12));
  AssemblyOptions own;
  own.working_modes = false;
  CHECK(find_assembly_modes(machine, Eigen::VectorXd::Constant(1, -0.3), home, own).modes.empty());
}

TEST_CASE("the modes of a flat hexapod come in pairs mirrored in its base, fulfil its leg lengths and differ in their bodies") {
  const Machine machine = test::make_hexapod(test::BaseJoint::ball);
  std::mt19937_64 random(17);
  for (int k = 0; k < 2; ++k) {
    const Eigen::VectorXd q = test::random_motion(machine, random).q;
    CAPTURE(q.transpose());
    const Eigen::VectorXd legs = actuators_at(machine, q);
    const AssemblyModes found = modes_at(machine, q);
    CHECK(found.modes.size() >= 2);
    CHECK(found.modes.size() % 2 == 0);
    CHECK(found.modes.size() <= 40);  // what Gough's platform of any geometry can have
    CHECK(found.modes.front().distance < 1e-9);
    for (std::size_t i = 0; i < found.modes.size(); ++i) {
      const Pose& pose = found.modes[i].pose;
      for (int leg = 0; leg < 6; ++leg)
        CHECK(std::abs((machine.centre(pose, 3 * leg + 2) - machine.centre(pose, 3 * leg)).norm() - legs(leg)) < 1e-10);
      CHECK(found.modes[i].gap < 1e-12);
      // B_i of one mode is B_i of its partner with the other sign of Z.
      const auto mirrored = [&](const AssemblyMode& other) {
        for (int leg = 0; leg < 6; ++leg) {
          const Eigen::Vector3d b = machine.centre(pose, 3 * leg + 2), c = machine.centre(other.pose, 3 * leg + 2);
          if ((b - Eigen::Vector3d(c.x(), c.y(), -c.z())).norm() > 1e-8) return false;
        }
        return true;
      };
      CHECK(std::count_if(found.modes.begin(), found.modes.end(), mirrored) == 1);
      for (std::size_t j = 0; j < i; ++j) CHECK(distance(machine, pose, found.modes[j].pose, 0.25) > 1e-6);
    }
  }
}

TEST_CASE("a search for assembly modes gives the same numbers again") {
  const Machine machine = test::make(contract::mechanism<Ellipsograph>);
  const AssemblyModes a = modes_at(machine, machine.home()), b = modes_at(machine, machine.home());
  REQUIRE(a.modes.size() == b.modes.size());
  for (std::size_t i = 0; i < a.modes.size(); ++i) CHECK(a.modes[i].coordinates == b.modes[i].coordinates);
  CHECK(a.starts == b.starts);
  CHECK(a.placements == b.placements);
}

TEST_CASE("actuator values that no pose has give no mode") {
  const Machine machine = test::make(test::slider_crank());
  const AssemblyModes found = find_assembly_modes(machine, Eigen::VectorXd::Constant(1, 2.0), machine.home(), shortly());  // 2 m out
  CHECK(found.modes.empty());
  CHECK(found.arrivals == 0);
}

TEST_CASE("modes beyond the stroke of an actuator are told as such") {
  const Machine machine = test::make(contract::mechanism<Ellipsograph>);  // stroke from 0 to 1 m, the joints turn freely
  const auto at = [&](double s) { return find_assembly_modes(machine, Eigen::VectorXd::Constant(1, s), machine.home(), shortly()).modes; };
  const std::vector<AssemblyMode> inside = at(0.3), outside = at(-0.3);
  REQUIRE(inside.size() == 2);
  REQUIRE(outside.size() == 2);
  for (const AssemblyMode& m : inside) CHECK(m.within_limits);
  for (const AssemblyMode& m : outside) CHECK_FALSE(m.within_limits);
}

TEST_CASE("the distance of two poses counts the way and the turn, weighed by a length") {
  const Machine machine = test::make_hexapod(test::BaseJoint::ball);
  const Eigen::VectorXd home = machine.home();
  Eigen::VectorXd moved = home;
  moved(0) += 0.03;
  moved(3) += 0.2;  // about Z alone: the angle between the orientations
  const Pose a = machine.pose({home.data(), 6}), b = machine.pose({moved.data(), 6});
  CHECK(distance(machine, a, b, 0.2) == Approx(0.05).epsilon(1e-12));
  CHECK(distance(machine, b, a, 0.2) == Approx(0.05).epsilon(1e-12));
  CHECK(distance(machine, a, a, 0.2) == Approx(0).margin(1e-7));  // the angle of a rounding is the root of it
}
