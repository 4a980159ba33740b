// Two machines of the textbooks, with masses: an unbalanced rotor, and the crank, rod and piston of an engine.
#pragma once

#include <pmreport/mechanism.hpp>
#include <tests/mechanics/mechanisms.hpp>

namespace pmreport::test {

// A rotor on the Z axis of the base, driven there. One bearing at O, or two at the same distance on either side. Its body frame turns with
// it about Z, its origin stands off the axis.
template <int bearings>
class Rotor : public Mechanism<1> {
 public:
  static constexpr const char *name = bearings == 1 ? "rotor" : "rotor-2", *title = "unbalanced rotor", *source = "a test";
  static constexpr std::array<Parameter, 0> parameters{};
  static constexpr double apart = 0.4;  // of a bearing from O, where there are two [m]
  static Eigen::Vector3d origin() { return {0.3, 0, 0}; }
  static Inertia inertia() {
    Eigen::Matrix3d about_centre;
    about_centre << 0.05, 0.004, -0.007, 0.004, 0.06, 0.009, -0.007, 0.009, 0.08;
    return {3.0, {-0.1, 0.15, 0.05}, about_centre};
  }

  explicit Rotor(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"theta", "angle", "rad", 0.3, {-3, 3}}};
    t.platform = t.add(Body{"rotor", 0, false, inertia()});
    for (int i = 0; i < bearings; ++i)
      t.add(Joint{bearings == 1 ? "O" : i == 0 ? "below" : "above", JointKind::revolute, 0, t.platform, {}});
    t.add(Actuator{"motor", "motor", "rad", 0, {-4, 4}});
    t.constraints = {{"fx", "", "N"}, {"fy", "", "N"}, {"fz", "", "N"}, {"mx", "", "N*m"}, {"my", "", "N*m"}};
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Matrix3<T> r = rotation_z(q[0]);
    const Vector3<T> z = Eigen::Vector3d::UnitZ().cast<T>();
    at.body(1, r * origin(), r);
    for (int i = 0; i < bearings; ++i) at.joint(i, z * T(bearings == 1 ? 0 : (2 * i - 1) * apart), z);
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    const Vector3<T> z = Eigen::Vector3d::UnitZ().cast<T>(), to_axis = -at.origin(1);
    couple_row<T>(g, 0, z);
    for (int k = 0; k < 3; ++k) force_row<T>(g, 1 + k, Eigen::Vector3d::Unit(k).cast<T>(), to_axis);
    for (int k = 0; k < 2; ++k) couple_row<T>(g, 4 + k, Eigen::Vector3d::Unit(k).cast<T>());
    return g;
  }
};

// In the plane z = 0: crank O to A, rod A to B, piston B along x. The crank drives; the piston carries the load. All pins are revolute
// joints about z, so that three constraints are more than needed.
class Engine : public Mechanism<1> {
 public:
  static constexpr const char *name = "engine", *title = "crank, rod and piston", *source = "a test";
  static constexpr std::array<Parameter, 0> parameters{};
  static constexpr double r = 0.05, l = 0.16;                           // crank, rod [m]
  static constexpr double crank_mass = 1.5, crank_centre = 0.01;        // [kg], [m] from O towards A
  static constexpr double rod_mass = 0.6, rod_centre = 0.055;           // [m] from A towards B
  static constexpr double piston_mass = 0.4;                            // in B
  static constexpr double crank_inertia = 0.003, rod_inertia = 0.0021;  // about the centres of mass and z [kg m^2]
  enum { crank = 1, rod = 2, piston = 3 };

  explicit Engine(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"theta", "crank angle", "rad", 0.8, {0.3, 2.8}}};
    const auto flat = [](double mass, double centre, double about_z) {
      return Inertia{mass, {centre, 0, 0}, Eigen::Vector3d(0.4 * about_z, 0.6 * about_z, about_z).asDiagonal()};
    };
    t.add(Body{"crank", 0, false, flat(crank_mass, crank_centre, crank_inertia)});
    t.add(Body{"rod", 0, false, flat(rod_mass, rod_centre, rod_inertia)});
    t.platform = t.add(Body{"piston", 0, false, flat(piston_mass, 0, 0)});
    t.add(Joint{"O", JointKind::revolute, 0, crank, {}});
    t.add(Joint{"A", JointKind::revolute, crank, rod, {}});
    t.add(Joint{"B", JointKind::revolute, rod, piston, {}});
    t.add(Joint{"cylinder", JointKind::prismatic, 0, piston, {}});
    t.add(Actuator{"crank", "crank", "rad", 0, {-4, 4}});
    t.constraints = {{"fy", "", "N"}, {"fz", "", "N"}, {"mx", "", "N*m"}, {"my", "", "N*m"}, {"mz", "", "N*m"}};
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> o = Eigen::Vector3d::Zero().cast<T>(), x = Eigen::Vector3d::UnitX().cast<T>(), z = Eigen::Vector3d::UnitZ().cast<T>();
    const Matrix3<T> turned = rotation_z(q[0]);
    const Vector3<T> a = turned.col(0) * T(r);
    const Vector3<T> b = x * T(a.x() + sqrt(l * l - square(a.y())));
    at.body(crank, o, turned);
    at.body(rod, a, frame_xz(unit(Vector3<T>(b - a)), z));
    at.body(piston, b, Eigen::Matrix3d::Identity().cast<T>());
    at.joint(0, o, z);
    at.joint(1, a, z);
    at.joint(2, b, z);
    at.joint(3, b, x);
    at.actuator(0, q[0]);
  }
  // The rod keeps its length: n . (theta' z x a) = n . x v_x.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    const Vector3<T> a = at.centre(1), n = at.centre(2) - a;
    g(0, 0) = n.x() / (n.y() * a.x() - n.x() * a.y());
    for (int k = 1; k < 6; ++k) g(k, k) = T(1.0);
    return g;
  }
};

mechanics::Machine make_rotor();
mechanics::Machine make_rotor_on_two_bearings();
mechanics::Machine make_engine();

mechanics::State state_of(const mechanics::Machine& machine, double q, double rate, double acceleration);

// The rotor's mass and inertia about O, in axes that turn with it, written out: the centre of mass by Steiner.
struct RotorNumbers {
  double mass = 3.0;
  Eigen::Vector3d centre{0.2, 0.15, 0.05};  // from O
  // Entries xz, yz, zz of the tensor about O: those about the centre less m x z, less m y z, and plus m (x^2 + y^2).
  double xz = -0.007 - 3.0 * 0.2 * 0.05, yz = 0.009 - 3.0 * 0.15 * 0.05, zz = 0.08 + 3.0 * (0.04 + 0.0225);
};

}  // namespace pmreport::test
