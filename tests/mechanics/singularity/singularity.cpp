// Singularities whose place and type are known from geometry: a knee at dead centre, a slider-crank, a flat parallelogram, a hexapod
// turned by a quarter.
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/singularity/singularity.hpp>

#include <pmreport/mechanism.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// A planar linkage of two bars in the plane z = 0. As a press: crank of 0.2 about the origin, rod of 0.4, slider along X, which carries the
// load. As a parallelogram: two cranks of 0.2, base and coupler of 0.4; the coupler carries the load.
template <bool Press>
class Linkage : public Mechanism<1> {
 public:
  static constexpr const char *name = "linkage", *title = "planar linkage", *source = "this test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Linkage(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"theta", "crank angle", "rad", 1, {-3, 3}}};
    t.add(Body{"crank", 0, false, {}});
    t.add(Body{"rod", 0, false, {}});
    t.add(Body{"last", 0, false, {}});
    t.platform = Press ? 3 : 2;
    t.add(Joint{"A", JointKind::revolute, 0, 1, {}});
    t.add(Joint{"B", JointKind::revolute, 1, 2, {}});
    t.add(Joint{"C", JointKind::revolute, 2, 3, {}});
    t.add(Joint{"D", Press ? JointKind::prismatic : JointKind::revolute, 0, 3, {}});
    t.add(Actuator{"q", "crank", "rad", 0, {-4, 4}});
    for (const char* n : {"c1", "c2", "c3", "c4", "c5"}) t.constraints.push_back({n, "", "N"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> z = Vector3d::UnitZ().cast<T>(), a = Vector3d::Zero().cast<T>(), x = Vector3d::UnitX().cast<T>();
    const Vector3<T> along(cos(q[0]), sin(q[0]), T(0.0)), b = along * T(0.2);
    Vector3<T> c = b + x * T(0.4), d = x * T(0.4);
    if (Press) c = Vector3<T>(b(0) + sqrt(T(0.16) - b(1) * b(1)), T(0.0), T(0.0)), d = c;
    at.body(1, a, frame_xz(along, z));
    at.body(2, b, frame_xz(unit(Vector3<T>(c - b)), z));
    at.body(3, c, Matrix3<T>(Matrix3<T>::Identity()));
    at.joint(0, a, z);
    at.joint(1, b, z);
    at.joint(2, c, z);
    at.joint(3, d, Press ? x : z);
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Matrix6<T>(Matrix6<T>::Identity());
  }
};

template <class M>
LockedFreedoms locked(const VectorXd& q) {
  static const Machine machine = test::make(contract::mechanism<M>);
  const Mobility home = mobility(machine, state_at_rest(machine, machine.home()));
  return locked_freedoms(machine, state_at_rest(machine, q), home, 0.2);
}
VectorXd angle(double theta) { return VectorXd::Constant(1, theta); }

// Pure yaw of the hexapod at home height.
VectorXd yaw(const Machine& machine, double alpha) {
  VectorXd q = machine.home();
  q(3) = alpha;
  return q;
}
constexpr double quarter = std::numbers::pi / 2;

}  // namespace

TEST_CASE("a press at dead centre is a singularity of type 1: its crank moves, its slider does not") {
  const LockedFreedoms regular = locked<Linkage<true>>(angle(1));
  CHECK(type_of(regular, 1) == SingularityType::regular);
  CHECK(regular.inverse_margin > 0.01);
  const LockedFreedoms dead = locked<Linkage<true>>(angle(0));
  CHECK(type_of(dead, 1) == SingularityType::inverse);
  CHECK(dead.actuators == 1);
  CHECK(dead.platform == 0);
  CHECK(dead.inverse_margin < 1e-12);
  CHECK(dead.constraint_margin > 0.01);
}

TEST_CASE("a flat parallelogram is a constraint singularity: its coupler turns as well as translates") {
  CHECK(type_of(locked<Linkage<false>>(angle(1)), 1) == SingularityType::regular);
  const LockedFreedoms flat = locked<Linkage<false>>(angle(0));
  CHECK(flat.free == 2);
  CHECK(type_of(flat, 1) == SingularityType::constraint);
  CHECK(flat.constraint_margin < 1e-12);
}

TEST_CASE("a slider that drives a crank loses it at dead centre, type 2, and the crank turns about its own axis") {
  const Machine machine = test::make(test::slider_crank());
  const Mobility home = mobility(machine, state_at_rest(machine, machine.home()));
  // Dead centre by bisection of the rod's lever on the crank, which is not the determinant.
  const auto lever = [&](double theta) {
    const State s = state_at_rest(machine, angle(theta));
    return s.joints[1].centre.cross(s.bodies[2].rotation.col(2)).z();
  };
  double low = 2.0, high = 4.5;
  REQUIRE(lever(low) * lever(high) < 0);
  for (int i = 0; i < 100; ++i) (lever(low) * lever(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  const auto s = singularity_at(machine, angle(low), home, 0.2);
  REQUIRE(s.has_value());
  CHECK(s->type == SingularityType::direct);
  REQUIRE(s->freedoms.escapes.dimension() == 1);
  const Screw turn = screw_of_twist(s->freedoms.escapes.basis.col(0), s->freedoms.escapes.origin, 0.2);
  CHECK(turn.same_axis(Vector3d::Zero(), Vector3d::UnitZ(), 0.2));
  CHECK(turn.is_line());
  CHECK(singularity_at(machine, machine.home(), home, 0.2)->type == SingularityType::regular);
}

TEST_CASE("a hexapod turned by a quarter about its axis escapes along a screw that changes no limb's length") {
  const Machine machine = test::make_hexapod(test::BaseJoint::ball);
  const Mobility home = mobility(machine, state_at_rest(machine, machine.home()));
  const double length = characteristic_length(machine);
  const auto regular = singularity_at(machine, yaw(machine, 0.3), home, length);
  REQUIRE(regular.has_value());
  CHECK(regular->type == SingularityType::regular);
  CHECK(regular->ranks.wrenches == 6);
  CHECK(regular->conditioning.smallest > 0.01);
  for (const double side : {-1.0, 1.0}) {
    const auto s = singularity_at(machine, yaw(machine, side * quarter), home, length);
    REQUIRE(s.has_value());
    CHECK(s->type == SingularityType::direct);
    CHECK(s->ranks.lines == 5);
    CHECK(s->ranks.wrenches == 5);
    CHECK(s->ranks.pitch == std::vector<double>(6, 0.0));
    CHECK(s->conditioning.smallest < 1e-12);
    const Screw escape = screw_of_twist(s->conditioning.escape, s->freedoms.escapes.origin, length);
    CHECK(escape.same_axis({0, 0, 0}, Vector3d::UnitZ(), length));
    CHECK(std::abs(escape.pitch) > 0.01);
    // The platform's joints moved along the twist by a small amount: lengths change by its square alone.
    constexpr double step = 1e-4;
    const Vector6d t = s->conditioning.escape / s->conditioning.escape.norm();
    for (int limb = 0; limb < 6; ++limb) {
      const Vector3d a = s->state.joints[static_cast<std::size_t>(3 * limb)].centre,
                     b = s->state.joints[static_cast<std::size_t>(3 * limb + 2)].centre;
      const Vector3d there = b + step * (t.head<3>() + t.tail<3>().cross(b - s->freedoms.escapes.origin));
      CHECK(std::abs((there - a).norm() - (b - a).norm()) < 10 * step * step);
    }
  }
}

TEST_CASE("the measures do not depend on the unit of length") {
  // Values of G^ belong to one length: a machine and its length scaled alike have the same. Here the length alone is scaled twice over.
  const Machine machine = test::make_hexapod(test::BaseJoint::universal);
  const State s = state_at_rest(machine, yaw(machine, 0.2));
  std::vector<double> placement(machine.layout().size());
  const VectorXd q = yaw(machine, 0.2);
  double g[36];
  machine.place(PM_VALUE, 1, q.data(), placement.data());
  machine.jacobian(PM_VALUE, 1, placement.data(), g);
  const Matrix6d jacobian = Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(g);
  const Conditioning one = conditioning(machine, jacobian, 0.25);
  Matrix6d in_mm = jacobian;  // lengths of arms in millimetres, forces as before
  in_mm.rightCols<3>() *= 1000;
  const Conditioning other = conditioning(machine, in_mm, 250);
  CHECK(one.determinant == Approx(other.determinant).epsilon(1e-12));
  CHECK(one.smallest == Approx(other.smallest).epsilon(1e-10));
  CHECK(one.condition() == Approx(other.condition()).epsilon(1e-10));
}

TEST_CASE("a rounded pose is put onto the singular surface that it means, and one far from it is left alone") {
  const Machine machine = test::make_hexapod(test::BaseJoint::ball);
  const double length = characteristic_length(machine);
  const auto on = onto_surface(machine, yaw(machine, quarter + 3e-5), length);
  REQUIRE(on.has_value());
  CHECK(on->coordinate == 3);
  CHECK(on->coordinates(3) == Approx(quarter).epsilon(1e-12));
  CHECK(on->moved == Approx(-3e-5).epsilon(1e-6));
  CHECK_FALSE(onto_surface(machine, yaw(machine, 0.3), length).has_value());
}

TEST_CASE("a row of zeros adds nothing to the ranks of lines") {
  const Machine machine = test::make_hexapod(test::BaseJoint::universal);
  std::vector<double> placement(machine.layout().size());
  const VectorXd q = yaw(machine, 0.2);
  machine.place(PM_VALUE, 1, q.data(), placement.data());
  const double length = characteristic_length(machine);
  linear::Matrix6d g = machine.jacobian(placement.data()).matrix;
  CHECK(line_ranks(machine, g, length).wrenches == 6);
  g.row(3).setZero();
  const LineRanks ranks = line_ranks(machine, g, length);
  CHECK(ranks.lines == 5);
  CHECK(ranks.wrenches == 5);
  CHECK(line_ranks(machine, linear::Matrix6d::Zero(), length).wrenches == 0);
}

namespace {

// A platform on a rail, and nothing else.
class Rail : public Mechanism<1> {
 public:
  static constexpr const char *name = "rail", *title = "a platform on a rail", *source = "this test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Rail(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"x", "position", "m", 0, {-1, 1}}};
    t.platform = t.add(Body{"platform", 0, false, {}});
    t.add(Joint{"P", JointKind::prismatic, 0, 1, {}});
    t.add(Actuator{"q", "position", "m", 0, {-1, 1}});
    for (const char* n : {"fy", "fz"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"mx", "my", "mz"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], T(0.0), T(0.0));
    at.body(1, p, Matrix3<T>(Matrix3<T>::Identity()));
    at.joint(0, p, Vector3d::UnitX().cast<T>());
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Matrix6<T>(Matrix6<T>::Identity());
  }
};

}  // namespace

TEST_CASE("a platform on one slide has no other body that could move, and is regular") {
  const Machine machine = test::make(contract::mechanism<Rail>);
  const State home = state_at_rest(machine, machine.home());
  const LockedFreedoms f = locked_freedoms(machine, home, mobility(machine, home), characteristic_length(machine));
  CHECK(type_of(f, machine.dof()) == SingularityType::regular);
  CHECK(f.free == 1);
  CHECK(f.inverse_margin == 0);
}
