// The usual mistakes of an author, each in a mechanism of its own, and the sentence that leads to it.
//
// A table on a universal joint, tipped by two legs (2-SPS-U): alpha about X in the base, then beta about the table's Y. Legs i from A_i
// below to B_i on the table's edge. Written as an author would write it, and sound unless a mistake says otherwise.
#include <core/mechanics/conformance/properties.hpp>
#include <pmreport/mechanism.hpp>

#include <catch2/catch.hpp>
#include <map>

using namespace pmreport;
using namespace pmreport::mechanics;
using Catch::Contains;
using Catch::StartsWith;
using Eigen::Vector3d;

namespace {

enum class Mistake {
  none,
  edge_not_turned,      // B1 of leg 1 moves with the table at home only: its joint does not close
  joint_not_given,      // place forgets joint B2
  body_not_placed,      // place forgets piston 2
  axis_not_given,       // place forgets the axes of the universal joint
  axis_left_behind,     // the universal joint's second axis stays where it was at home
  turns_swapped,        // beta first, then alpha: the axes of the joint do not stay perpendicular
  other_kind,           // the table is held by a revolute joint
  leg_not_connected,    // leg 2 has bodies but no joints
  leg_left_out,         // neither bodies nor joints nor drive of leg 2
  leg_hangs,            // leg 2 has no joint on the base
  one_coordinate,       // declares alpha and leg 1 alone: the table can still tip about Y
  one_coordinate_less,  // two degrees of freedom, one coordinate
  spins_not_declared,   // the idle spins of the legs
  axis_not_unit,        // the axis of cylinder 1 is the whole leg
  drive_backwards,      // the first actuator shortens with its leg's length
  wrong_moment          // the first row's moment is taken about the wrong point
};

constexpr double height = 0.3, radius = 0.2;

template <Mistake mistake>
class Table : public Mechanism<mistake == Mistake::one_coordinate ? 1 : 2> {
 public:
  using Base = Mechanism<mistake == Mistake::one_coordinate ? 1 : 2>;
  template <class T>
  using Coordinates = typename Base::template Coordinates<T>;
  static constexpr const char *name = "table", *title = "tilt table", *source = "a test";
  static constexpr Parameter parameters[] = {Parameter::length("spare", 1, "not used")};
  static constexpr int legs = mistake == Mistake::one_coordinate || mistake == Mistake::leg_left_out ? 1 : 2;

  explicit Table(const Parameters&) {}

  Topology topology() const {
    Topology t;
    t.coordinates = {{"alpha", "tilt about X", "rad", 0, {-0.3, 0.3}}, {"beta", "tilt about Y1", "rad", 0, {-0.3, 0.3}}};
    if constexpr (mistake == Mistake::one_coordinate || mistake == Mistake::one_coordinate_less) t.coordinates.pop_back();
    t.platform = t.add(Body{"table", 0, false, {}});
    t.add(Joint{"U", mistake == Mistake::other_kind ? JointKind::revolute : JointKind::universal, 0, t.platform, {}});
    for (int i = 1; i <= legs; ++i) {
      const std::string n = std::to_string(i);
      const int cylinder = t.add(Body{"cylinder " + n, i, true, {}}), piston = t.add(Body{"piston " + n, i, true, {}});
      if (mistake == Mistake::leg_not_connected && i == 2) continue;
      const bool hangs = mistake == Mistake::leg_hangs && i == 2;
      if (!hangs) t.add(Joint{"A" + n, JointKind::spherical, 0, cylinder, {}});
      const int slide = t.add(Joint{"P" + n, JointKind::prismatic, cylinder, piston, {}});
      t.add(Joint{"B" + n, JointKind::spherical, piston, t.platform, {}});
      t.add(Actuator{"l" + n, "length of leg " + n, "m", slide, {0.2, 0.4}});
    }
    if (mistake == Mistake::leg_not_connected) t.add(Actuator{"l2", "length of leg 2", "m", 2, {0.2, 0.4}});
    t.constraints = {{"fx", "", "N"}, {"fy", "", "N"}, {"fz", "", "N"}, {"mz", "", "N*m"}};
    if constexpr (mistake == Mistake::one_coordinate) t.constraints.push_back({"my", "", "N*m"});
    t.idle = mistake == Mistake::spins_not_declared ? 0 : legs;
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const T alpha = q[0], beta = second(q);
    const Matrix3<T> tilted = rotation_x(alpha),
                     r = mistake == Mistake::turns_swapped ? (rotation_y(beta) * tilted).eval() : (tilted * rotation_y(beta)).eval();
    const Vector3<T> p = Vector3d(0, 0, height).cast<T>(), x = Vector3d::UnitX().cast<T>(), y = Vector3d::UnitY().cast<T>();
    at.body(1, p, r);
    if constexpr (mistake == Mistake::other_kind)
      at.joint(0, p, x);
    else if constexpr (mistake == Mistake::axis_not_given)
      at.joint(0, p);
    else
      at.joint(0, p, x, mistake == Mistake::axis_left_behind ? y : tilted.col(1));
    int joint = 1;
    for (int i = 0; i < legs; ++i) {
      const Vector3d foot = i == 0 ? Vector3d(0, radius, 0) : Vector3d(radius, 0, 0);
      const Vector3<T> a = foot.cast<T>(), edge = r * foot;
      const Vector3<T> b = mistake == Mistake::edge_not_turned && i == 0 ? (p + a).eval() : (p + edge).eval();
      const Vector3<T> leg = b - a, n = unit(leg);
      at.slender(2 + 2 * i, a, mistake == Mistake::axis_not_unit && i == 0 ? leg : n);
      if (mistake != Mistake::body_not_placed || i == 0) at.slender(3 + 2 * i, b, n);
      at.actuator(i, mistake == Mistake::drive_backwards && i == 0 ? T(-length(leg)) : length(leg));
      if (mistake == Mistake::leg_not_connected && i == 1) continue;
      if (mistake != Mistake::leg_hangs || i == 0) at.joint(joint++, a);
      at.joint(joint++, b, n);
      if (mistake != Mistake::joint_not_given || i == 0) at.joint(joint, b);
      ++joint;
    }
  }

  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    for (int i = 0; i < legs; ++i) {
      const Vector3<T> n = at.spine(2 + 2 * i);
      const Vector3d foot = i == 0 ? Vector3d(0, radius, 0) : Vector3d(radius, 0, 0);
      const Vector3<T> arm = mistake == Mistake::wrong_moment && i == 0 ? foot.cast<T>().eval() : (at.rotation(1) * foot).eval();
      force_row<T>(g, i, n, arm);
    }
    for (int k = 0; k < 3; ++k) g(Base::dof + k, k) = T(1.0);
    const Vector3<T> x = Vector3d::UnitX().cast<T>(), y1 = at.rotation(1).col(1);
    couple_row<T>(g, 5, x.cross(y1));
    if constexpr (mistake == Mistake::one_coordinate) couple_row<T>(g, 4, y1);
    return g;
  }

 private:
  template <class T>
  static T second(const Coordinates<T>& q) {
    if constexpr (std::tuple_size_v<Coordinates<T>> == 1)
      return T(0.0);
    else
      return q[1];
  }
};

// The properties that fail, with where they do.
template <Mistake mistake>
std::map<std::string, std::string> failures() {
  const pm_mechanism& table = contract::mechanism<Table<mistake>>;
  const Machine machine(table, default_values(describe(table)));
  std::map<std::string, std::string> out;
  for (const Property& p : check_properties(machine, {50, 1}))
    if (!p.passed()) out[p.claim] = p.where;
  return out;
}
template <Mistake mistake>
std::string failure(const std::string& claim) {
  const auto all = failures<mistake>();
  const auto found = all.find(claim);
  return found == all.end() ? "it passed" : found->second;
}
template <Mistake mistake>
std::string refusal() {
  const pm_mechanism& table = contract::mechanism<Table<mistake>>;
  try {
    const Machine machine(table, default_values(describe(table)));
  } catch (const MechanismError& e) {
    CHECK(e.status == PM_FAILED);
    return e.what();
  }
  return "it was taken";
}

}  // namespace

TEST_CASE("the table without a mistake has every property") { CHECK(failures<Mistake::none>().empty()); }

TEST_CASE("a joint that does not close is named with both bodies and the gap") {
  const std::string where = failure<Mistake::edge_not_turned>("joints close");
  CHECK_THAT(where, StartsWith("joint B1 (spherical, piston 1 and table) at alpha = ") &&
                        Contains("the point where piston 1 and table meet at home is ") && Contains(" mm away from itself; look at "));
  // The gap told is the largest, and that of the property: the edge rises by up to 0.2 m sin(0.3).
  const auto at = where.find("at home is ");
  CHECK(std::stod(where.substr(at + 11)) < 1e3 * radius * std::sin(0.3));
  CHECK(std::stod(where.substr(at + 11)) > 0.9e3 * radius * std::sin(0.3));
}

TEST_CASE("a joint that place does not give is named") {
  CHECK_THAT(failure<Mistake::joint_not_given>("joints close"), StartsWith("joint B2 (spherical, piston 2 and table)") &&
                                                                    Contains("its centre is (0, 0, 0), at home too") &&
                                                                    Contains("does place give joint B2?"));
}

TEST_CASE("a body that place does not put anywhere is named") {
  CHECK_THAT(failure<Mistake::body_not_placed>("axes and rotations are unit"),
             StartsWith("home: body piston 2: its axis is zero; does place put it anywhere?"));
}

TEST_CASE("a body whose axis is not of unit length is named with its length") {
  const std::string where = failure<Mistake::axis_not_unit>("axes and rotations are unit");
  CHECK_THAT(where, Contains(": body cylinder 1: its axis has length 0.") && Contains("is it divided by its length"));
  // The leg is shortest where it is farthest from unit length: near 0.3 m less 0.2 m sin(0.3).
  CHECK(std::stod(where.substr(where.find("has length ") + 11)) == Approx(height - radius * std::sin(0.3)).epsilon(0.05));
}

TEST_CASE("axes that place does not give are named") {
  CHECK_THAT(failure<Mistake::axis_not_given>("axes and rotations are unit"),
             StartsWith("home: axis 1 of joint U (universal, base and table) is zero; does place give this joint with its axes?"));
}

TEST_CASE("an axis that does not follow its body is found by the motion, and the joint named") {
  CHECK_THAT(failure<Mistake::axis_left_behind>("relative velocities are allowed"),
             StartsWith("joint U (universal, base and table) at alpha = ") &&
                 Contains("base and table move against each other as no universal joint allows") && Contains("look at its kind, its axes"));
}

TEST_CASE("a wrong axis is named with the angle by which it is wrong") {
  CHECK_THAT(failure<Mistake::turns_swapped>("joint axes agree"),
             StartsWith("joint U (universal, base and table) at alpha = ") && Contains(" deg from perpendicular; axis 1 must be fixed in "
                                                                                       "base, axis 2 in table"));
}

TEST_CASE("a joint of the wrong kind is named with what it forbids") {
  CHECK_THAT(failure<Mistake::other_kind>("joint axes agree"),
             StartsWith("joint U (revolute, base and table)") &&
                 Contains("its axis as base carries it and as table carries it differ by ") && Contains(" deg; it must be fixed in both"));
  CHECK_THAT(failure<Mistake::other_kind>("mobility is as declared"),
             Contains("found 1 degrees of freedom and 2 idle, declared 2 and 2; the joints hold more than the coordinates move"));
}

TEST_CASE("a forgotten limb is told by what nothing holds") {
  CHECK(refusal<Mistake::leg_not_connected>() ==
        "no chain of joints leads from the base to: cylinder 2, piston 2; is a joint, or a limb, forgotten?");
  CHECK(refusal<Mistake::leg_left_out>() == "declares 2 degrees of freedom, but 1 actuators; is a limb forgotten?");
  CHECK_THAT(failure<Mistake::leg_hangs>("mobility is as declared"),
             Contains("with every actuator held table, cylinder 2 and piston 2 can still move, the platform can turn about (0.000, 1.000, "
                      "0.000): a coordinate with its actuator is missing, or a joint or a limb, or a joint allows too much"));
}

TEST_CASE("too few coordinates are told by the motion that is left") {
  CHECK(refusal<Mistake::one_coordinate_less>() ==
        "declares 2 degrees of freedom, but 1 independent coordinates; Mechanism<2> and topology() must say the same");
  CHECK_THAT(failure<Mistake::one_coordinate>("mobility is as declared"),
             Contains("found 2 degrees of freedom and 1 idle, declared 1 and 1; with every actuator held table") &&
                 Contains("can still move, the platform can turn about (0.000, 1.000, 0.000): a coordinate with its actuator is missing"));
}

TEST_CASE("idle spins that are not declared are counted, and their bodies named") {
  CHECK_THAT(failure<Mistake::spins_not_declared>("mobility is as declared"),
             Contains("found 2 degrees of freedom and 2 idle, declared 2 and 0; about themselves spin cylinder 1, piston 1, cylinder 2 and "
                      "piston 2: declare 2 idle freedoms"));
}

TEST_CASE("an actuator that does not measure its joint is named with both rates") {
  CHECK_THAT(failure<Mistake::drive_backwards>("actuators measure their joints"),
             Contains(": actuator l1 changes by ") && Contains(" m/s, joint P1 (prismatic, cylinder 1 and piston 1) by ") &&
                 Contains("look at its sign"));
}

TEST_CASE("the wrong row of a Jacobian is named") {
  CHECK_THAT(failure<Mistake::wrong_moment>("jacobian gives the actuator rates"), Contains(": row 1 of the Jacobian (l1)"));
}
