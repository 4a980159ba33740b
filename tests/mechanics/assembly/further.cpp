// Poses that a plugin's coordinates cannot express, on mechanisms whose author left some out.
#include <core/mechanics/assembly/loops.hpp>

#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <pmreport/mechanism.hpp>
#include <tests/mechanics/assembly/actuators_at.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <Eigen/Geometry>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using test::actuators_at;

namespace {

// Two cranks of one length, 0.2 m, and a coupler as long as the base, 0.5 m: the author says that the coupler stays level. With the first
// crank held it may also lie crosswise.
class Parallelogram : public Mechanism<1> {
 public:
  static constexpr const char *name = "parallelogram", *title = "parallelogram", *source = "a test";
  static constexpr std::array<Parameter, 0> parameters{};
  static constexpr double crank = 0.2, base = 0.5;
  explicit Parallelogram(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"theta", "angle of the cranks", "rad", 1, {0.5, 1.5}}};
    t.platform = t.add(Body{"coupler", 0, false, {}});
    t.add(Body{"crank 1", 1, false, {}});
    t.add(Body{"crank 2", 2, false, {}});
    t.add(Joint{"A", JointKind::revolute, 0, 2, {}});
    t.add(Joint{"B", JointKind::revolute, 2, 1, {}});
    t.add(Joint{"D", JointKind::revolute, 0, 3, {}});
    t.add(Joint{"C", JointKind::revolute, 3, 1, {}});
    t.add(Actuator{"drive", "crank 1", "rad", 0, {-3, 3}});
    for (const char* n : {"force_x", "force_y", "force_z"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"couple_x", "couple_y"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> along(cos(q[0]), sin(q[0]), T(0.0)), z = Vector3d::UnitZ().cast<T>(), a = Vector3d::Zero().cast<T>(),
                                                          d = Vector3d(base, 0, 0).cast<T>(), b = along * T(crank), c = d + b;
    at.body(1, b, Matrix3<T>(Matrix3<T>::Identity()));
    at.body(2, a, frame_xz(along, z));
    at.body(3, d, frame_xz(along, z));
    at.joint(0, a, z), at.joint(1, b, z), at.joint(2, d, z), at.joint(3, c, z);
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Matrix6<T>::Identity();
  }
};

// Three legs, each between universal joints whose outer axes are tangents of base and platform: the author says that the platform only
// goes along. Legs of other lengths than these allow it to turn.
class ThreeUpu : public Mechanism<3> {
 public:
  static constexpr const char *name = "3-upu", *title = "3-UPU", *source = "a test";
  static constexpr std::array<Parameter, 0> parameters{};
  static constexpr double at_base = 0.4, at_platform = 0.2;
  explicit ThreeUpu(const Parameters&) {}
  static Vector3d radial(int i) { return {std::cos(2 * i * std::numbers::pi / 3), std::sin(2 * i * std::numbers::pi / 3), 0}; }
  static Vector3d tangent(int i) { return Vector3d::UnitZ().cross(radial(i)); }
  Topology topology() const {
    Topology t;
    for (const char* s : {"x", "y"}) t.coordinates.push_back({s, s, "m", 0, {-0.1, 0.1}});
    t.coordinates.push_back({"z", "z", "m", 0.5, {0.4, 0.6}});
    t.platform = t.add(Body{"platform", 0, false, {}});
    for (int i = 0; i < 3; ++i) {
      const std::string n = std::to_string(i + 1);
      t.add(Body{"cylinder " + n, i + 1, false, {}});
      t.add(Body{"piston " + n, i + 1, false, {}});
      t.add(Joint{"A" + n, JointKind::universal, 0, 2 + 2 * i, {}});
      t.add(Joint{"P" + n, JointKind::prismatic, 2 + 2 * i, 3 + 2 * i, {}});
      t.add(Joint{"B" + n, JointKind::universal, 3 + 2 * i, 1, {}});
      t.add(Actuator{"l" + n, "leg " + n, "m", 3 * i + 1, {0.3, 1}});
      t.constraints.push_back({"couple" + n, "", "N*m"});
    }
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]);
    at.body(1, p, Matrix3<T>(Matrix3<T>::Identity()));
    for (int i = 0; i < 3; ++i) {
      const Vector3<T> a = Vector3d(at_base * radial(i)).cast<T>(), b = p + Vector3d(at_platform * radial(i)).cast<T>(), leg = b - a,
                       n = unit(leg), g = tangent(i).cast<T>(), w = unit(Vector3<T>(g.cross(n)));
      at.body(2 + 2 * i, a, frame_xz(w, n));
      at.body(3 + 2 * i, b, frame_xz(w, n));
      at.joint(3 * i, a, g, w);
      at.joint(1 + 3 * i, b, n);
      at.joint(2 + 3 * i, b, w, g);
      at.actuator(i, length(leg));
    }
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    for (int i = 0; i < 3; ++i) {
      force_row<T>(g, i, at.axis(1 + 3 * i), at.centre(2 + 3 * i) - at.origin(1));
      couple_row<T>(g, 3 + i, Vector3<T>(at.axis(3 * i).cross(at.axis(3 * i, 1))));
    }
    return g;
  }
};

FurtherModes further_at(const Machine& machine, const Eigen::VectorXd& q, int starts) {
  AssemblyOptions options = test::shortly();
  options.joint_starts = starts;
  const AssemblyModes found = find_assembly_modes(machine, actuators_at(machine, q), q, options);
  REQUIRE(found.further.has_value());
  return *found.further;
}

}  // namespace

TEST_CASE("the slopes of the loop equations are those of small displacements") {
  for (const pm_mechanism* table : {&contract::mechanism<ThreeUpu>, &contract::mechanism<Parallelogram>, &test::arm(), &test::hexapod()}) {
    const Machine machine = test::make(*table);
    CAPTURE(table->name);
    const LoopEquations equations(machine, 0.3);
    const Eigen::VectorXd actuators = actuators_at(machine, machine.home()).array() + 0.05;
    std::vector<BodyState> bodies = bodies_at_rest(machine, machine.home_pose());
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    Eigen::VectorXd by(6 * static_cast<Eigen::Index>(bodies.size() - 1));
    for (double& x : by) x = 0.3 * unit(random);
    equations.displace(bodies, by);  // open everywhere
    const LoopEquations::Value here = equations.at(bodies, actuators);
    for (Eigen::Index k = 0; k < by.size(); ++k) {
      std::vector<BodyState> ahead = bodies, behind = bodies;
      equations.displace(ahead, 1e-5 * Eigen::VectorXd::Unit(by.size(), k));
      equations.displace(behind, -1e-5 * Eigen::VectorXd::Unit(by.size(), k));
      const Eigen::VectorXd seen = (equations.at(ahead, actuators).error - equations.at(behind, actuators).error) / 2e-5;
      for (Eigen::Index r = 0; r < seen.size(); ++r) {
        const bool angle = r >= seen.size() - machine.dof() &&
                           machine.topology().actuators[static_cast<std::size_t>(r - seen.size() + machine.dof())].sense() == Sense::rotary;
        // An angle's slope is that of closed joints, and the joints are open here.
        if (!angle) CHECK(here.slope(r, k) == Approx(seen(r)).margin(1e-8));
      }
    }
  }
}

TEST_CASE("the loop equations hold at every pose that place gives, and not beside it") {
  const Machine machine = test::make(contract::mechanism<ThreeUpu>);
  const LoopEquations equations(machine, 0.3);
  for (const Vector3d& p : {Vector3d(0.05, -0.02, 0.55), Vector3d(-0.07, 0.04, 0.45)}) {
    const Pose pose = machine.pose({p.data(), 3});
    std::vector<BodyState> bodies = bodies_at_rest(machine, pose);
    CHECK(equations.at(bodies, actuators_at(machine, p)).error.lpNorm<Eigen::Infinity>() < 1e-14);
    bodies[1].rotation = Eigen::AngleAxisd(0.01, Vector3d::UnitX()).toRotationMatrix();
    CHECK(equations.at(bodies, actuators_at(machine, p)).error.lpNorm<Eigen::Infinity>() > 1e-4);
  }
}

TEST_CASE("a parallelogram whose author knows it as such has its crossed pose found beyond the coordinate") {
  const Machine machine = test::make(contract::mechanism<Parallelogram>);
  for (const double theta : {0.6, 1.0, 1.4}) {
    const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, theta);
    const FurtherModes further = further_at(machine, q, 60);
    REQUIRE(further.poses.size() == 1);
    CHECK(further.missed == 0);
    CHECK(further.poses[0].isolated);
    CHECK(further.poses[0].error < 1e-10);
    // C crosswise is the mirror image of the level one in the line from B to D: as far from either.
    const Vector3d b = Parallelogram::crank * Vector3d(std::cos(theta), std::sin(theta), 0), d(Parallelogram::base, 0, 0);
    const Vector3d n = (d - b).normalized(), level = Vector3d(Parallelogram::base, 0, 0);  // from B
    const Vector3d crossed = 2 * n * n.dot(level) - level;
    CHECK((further.poses[0].origin - b).norm() < 1e-9);
    CHECK((further.poses[0].rotation.col(0) - crossed.normalized()).norm() < 1e-9);
    CHECK((further.poses[0].rotation.col(2) - Vector3d::UnitZ()).norm() < 1e-9);
  }
}

TEST_CASE("a 3-UPU has poses with its platform turned, in which legs and universal joints are what they are") {
  const Machine machine = test::make(contract::mechanism<ThreeUpu>);
  const Vector3d q(0.03, -0.02, 0.5);
  const Eigen::VectorXd legs = actuators_at(machine, q);
  const FurtherModes further = further_at(machine, q, 60);
  REQUIRE_FALSE(further.poses.empty());
  for (const FurtherPose& f : further.poses) {
    CAPTURE(f.origin.transpose(), f.rotation);
    CHECK((f.rotation - Eigen::Matrix3d::Identity()).norm() > 1e-3);  // the platform is turned: else x, y and z say where it is
    for (int i = 0; i < 3; ++i) {
      const Vector3d leg = f.origin + f.rotation * (ThreeUpu::at_platform * ThreeUpu::radial(i)) - ThreeUpu::at_base * ThreeUpu::radial(i);
      CHECK(std::abs(leg.norm() - legs(i)) < 1e-9);
      // Both joints' middle axes are across the leg, and the piston does not turn in the cylinder: the outer axes and the leg lie in a
      // plane.
      CHECK(std::abs(leg.normalized().dot(ThreeUpu::tangent(i).cross(f.rotation * ThreeUpu::tangent(i)))) < 1e-9);
    }
  }
}

TEST_CASE("the coordinates of a serial arm leave nothing beyond them") {
  const Machine arm = test::make(test::arm());
  const FurtherModes of_arm = further_at(arm, arm.home(), 30);
  CHECK(of_arm.arrivals > 0);
  CHECK(of_arm.poses.empty());
}

TEST_CASE("a search beyond the coordinates gives the same numbers again") {
  const Machine machine = test::make(contract::mechanism<Parallelogram>);
  const FurtherModes a = further_at(machine, machine.home(), 20), b = further_at(machine, machine.home(), 20);
  CHECK(a.arrivals == b.arrivals);
  REQUIRE(a.poses.size() == b.poses.size());
  for (std::size_t i = 0; i < a.poses.size(); ++i) CHECK(a.poses[i].origin == b.poses[i].origin);
}
