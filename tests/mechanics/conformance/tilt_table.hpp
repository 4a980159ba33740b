// The usual mistakes of an author, each in a mechanism of its own.
//
// A table on a universal joint, tipped by two legs (2-SPS-U): alpha about X in the base, then beta about the table's Y. Legs i from A_i
// below to B_i on the table's edge. Written as an author would write it, and sound unless a mistake says otherwise.
#pragma once

#include <core/mechanics/conformance/properties.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <pmreport/mechanism.hpp>

#include <catch2/catch.hpp>
#include <map>

namespace pmreport::test {

using namespace pmreport::mechanics;
using Eigen::Vector3d;

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
  wrong_moment,         // the first row's moment is taken about the wrong point
  row_zero,             // jacobian does not fill the row of fx
  row_twice,            // the row of fz is twice a unit wrench
  couple_thousandfold,  // that of mz a thousand times
  rows_exchanged,       // fz and mz stand in each other's row
  row_repeated,         // the row of fy is that of fx again
  home_stretched,       // leg 1 points to the table's centre at home
  legs_alike,           // both legs tip the table about X
  heading_jumps,        // a derived angle passes the cut of its arc tangent at home
  only_behind,          // edge_not_turned, with the other choice
  only_when_wide,       // edge_not_turned, on a table that is wider
  negative_mass,        // of the table
  no_mass,              // of the table, which has an inertia
  inertia_impossible,   // of the table: one moment exceeds the sum of the others
  joint_unnamed,        // A1
  joints_alike,         // B1 is called A1 too
  quantities_alike,     // the first actuator is called alpha
  shape_unknown,        // of a kind that there is not
  shape_not_finite      // its radius is a NaN
};

constexpr double height = 0.3;

// Tables are made with this mistake; one class for all of them, for to compile a mechanism takes long.
inline Mistake made_with = Mistake::none;
struct With {  // while it lives
  explicit With(Mistake m) { made_with = m; }
  ~With() { made_with = Mistake::none; }
  With(const With&) = delete;
  With& operator=(const With&) = delete;
};

// One degree of freedom is declared with Mistake::one_coordinate alone.
template <int declared = 2>
class Table : public Mechanism<declared> {
 public:
  using Base = Mechanism<declared>;
  template <class T>
  using Coordinates = typename Base::template Coordinates<T>;
  static constexpr const char *name = "table", *title = "tilt table", *source = "a test";
  static constexpr const char* sides[] = {"front", "back"};
  static constexpr Parameter parameters[] = {Parameter::choice("side", sides, 0, "where the legs stand"),
                                             Parameter::length("edge", 0.2, "of the table, from its centre", {0.1, 0.25})};
  explicit Table(const Parameters& p)
      : mistake_(made_with),
        legs_(declared == 1 || with(Mistake::leg_left_out) ? 1 : 2),
        radius_(p.choice("side") == "back" ? -p["edge"] : p["edge"]),
        edge_not_turned_(with(Mistake::edge_not_turned) || (with(Mistake::only_behind) && radius_ < 0) ||
                         (with(Mistake::only_when_wide) && p["edge"] > 0.22)) {}

  Topology topology() const {
    Topology t;
    t.coordinates = {{"alpha", "tilt about X", "rad", 0, {-0.3, 0.3}}, {"beta", "tilt about Y1", "rad", 0, {-0.3, 0.3}}};
    if (with(Mistake::one_coordinate) || with(Mistake::one_coordinate_less)) t.coordinates.pop_back();
    Inertia inertia;
    if (with(Mistake::negative_mass)) inertia.mass = -1;
    if (with(Mistake::no_mass)) inertia.about_centre = Vector3d(0.1, 0.1, 0.2).asDiagonal();
    if (with(Mistake::inertia_impossible)) inertia = Inertia::axisymmetric(1, 0, 0.1, 0.3);
    t.platform = t.add(Body{"table", 0, false, inertia});
    if (with(Mistake::heading_jumps)) t.derived = {{"heading", "", "rad", false}};
    if (with(Mistake::shape_unknown)) t.shapes.push_back({t.platform, static_cast<ShapeKind>(7), {0, 0, 0}, {0, 0, 0}, 0.1});
    if (with(Mistake::shape_not_finite)) t.shapes.push_back({t.platform, ShapeKind::ball, {0, 0, 0}, {0, 0, 0}, std::nan("")});
    t.add(Joint{"U", with(Mistake::other_kind) ? JointKind::revolute : JointKind::universal, 0, t.platform, {}});
    for (int i = 1; i <= legs_; ++i) {
      const std::string n = std::to_string(i);
      const int cylinder = t.add(Body{"cylinder " + n, i, true, {}}), piston = t.add(Body{"piston " + n, i, true, {}});
      if (with(Mistake::leg_not_connected) && i == 2) continue;
      const bool hangs = with(Mistake::leg_hangs) && i == 2;
      if (!hangs) t.add(Joint{with(Mistake::joint_unnamed) && i == 1 ? "" : "A" + n, JointKind::spherical, 0, cylinder, {}});
      const int slide = t.add(Joint{"P" + n, JointKind::prismatic, cylinder, piston, {}});
      t.add(Joint{(with(Mistake::joints_alike) && i == 1 ? "A" : "B") + n, JointKind::spherical, piston, t.platform, {}});
      t.add(Actuator{with(Mistake::quantities_alike) && i == 1 ? "alpha" : "l" + n, "length of leg " + n, "m", slide, {0.2, 0.4}});
    }
    if (with(Mistake::leg_not_connected)) t.add(Actuator{"l2", "length of leg 2", "m", 2, {0.2, 0.4}});
    t.constraints = {{"fx", "", "N"}, {"fy", "", "N"}, {"fz", "", "N"}, {"mz", "", "N*m"}};
    if (with(Mistake::one_coordinate)) t.constraints.push_back({"my", "", "N*m"});
    t.idle = with(Mistake::spins_not_declared) ? 0 : legs_;
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const T alpha = q[0], beta = second(q);
    const Matrix3<T> tilted = rotation_x(alpha),
                     r = with(Mistake::turns_swapped) ? (rotation_y(beta) * tilted).eval() : (tilted * rotation_y(beta)).eval();
    const Vector3<T> p = Vector3d(0, 0, height).cast<T>(), x = Vector3d::UnitX().cast<T>(), y = Vector3d::UnitY().cast<T>();
    at.body(1, p, r);
    if (with(Mistake::other_kind))
      at.joint(0, p, x);
    else if (with(Mistake::axis_not_given))
      at.joint(0, p);
    else
      at.joint(0, p, x, with(Mistake::axis_left_behind) ? y : tilted.col(1));
    if (with(Mistake::heading_jumps)) at.derived(0, atan2(sin(alpha), T(-1.0)));
    int joint = 1;
    for (int i = 0; i < legs_; ++i) {
      const Vector3d foot = foot_of(i), end = edge_of(i);
      const Vector3<T> a = foot.cast<T>(), edge = r * end;
      const Vector3<T> b = edge_not_turned_ && i == 0 ? (p + end.cast<T>()).eval() : (p + edge).eval();
      const Vector3<T> leg = b - a, n = unit(leg);
      at.slender(2 + 2 * i, a, with(Mistake::axis_not_unit) && i == 0 ? leg : n);
      if (!with(Mistake::body_not_placed) || i == 0) at.slender(3 + 2 * i, b, n);
      at.actuator(i, with(Mistake::drive_backwards) && i == 0 ? T(-length(leg)) : length(leg));
      if (with(Mistake::leg_not_connected) && i == 1) continue;
      if (!with(Mistake::leg_hangs) || i == 0) at.joint(joint++, a);
      at.joint(joint++, b, n);
      if (!with(Mistake::joint_not_given) || i == 0) at.joint(joint, b);
      ++joint;
    }
  }

  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    for (int i = 0; i < legs_; ++i) {
      const Vector3<T> n = at.spine(2 + 2 * i);
      const Vector3d edge = edge_of(i);
      const Vector3<T> arm = with(Mistake::wrong_moment) && i == 0 ? edge.cast<T>().eval() : (at.rotation(1) * edge).eval();
      force_row<T>(g, i, n, arm);
    }
    for (int k = 0; k < 3; ++k) g(Base::dof + k, k) = T(1.0);
    const Vector3<T> x = Vector3d::UnitX().cast<T>(), y1 = at.rotation(1).col(1);
    couple_row<T>(g, 5, x.cross(y1));
    if (with(Mistake::one_coordinate)) couple_row<T>(g, 4, y1);
    if (with(Mistake::row_zero)) g.row(2).setZero();
    if (with(Mistake::row_twice)) g.row(4) *= T(2.0);
    if (with(Mistake::couple_thousandfold)) g.row(5) *= T(1000.0);
    if (with(Mistake::rows_exchanged)) g.row(4).swap(g.row(5));
    if (with(Mistake::row_repeated)) g.row(3) = g.row(2);
    return g;
  }

 private:
  bool with(Mistake m) const { return mistake_ == m; }
  // From the table's centre to the end of leg i, table's axes; its foot, base axes.
  Vector3d edge_of(int i) const { return i == 0 || with(Mistake::legs_alike) ? Vector3d(0, radius_, 0) : Vector3d(radius_, 0, 0); }
  Vector3d foot_of(int i) const { return i == 0 && with(Mistake::home_stretched) ? Vector3d(0, 2 * radius_, height) : edge_of(i); }

  Mistake mistake_;
  int legs_;
  double radius_;  // negative: the legs stand on the other side
  bool edge_not_turned_;

  template <class T>
  static T second(const Coordinates<T>& q) {
    if constexpr (std::tuple_size_v<Coordinates<T>> == 1)
      return T(0.0);
    else
      return q[1];
  }
};

// One that was made while With lives.
const pm_mechanism& table_of(Mistake m);
Machine machine_of(Mistake m);

// The properties that fail, with where they do.
std::map<std::string, std::string> failures(Mistake m);
std::string failure(Mistake m, const std::string& claim);
std::string refusal(Mistake m);

}  // namespace pmreport::test
