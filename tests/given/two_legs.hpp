// A table that slides in a plane, held by two legs: one from O, one from A at (apart, 0). Where their lengths are given, the table's centre
// is on a circle about either: they meet in two points, touch in one, or are the same circle.
#pragma once

#include <pmreport/mechanism.hpp>

namespace pmreport::test {

class TwoLegs : public Mechanism<2> {
 public:
  static constexpr const char *name = "two-legs", *title = "two legs in a plane", *source = "a test";
  static constexpr Parameter parameters[] = {Parameter::length("apart", 0.3, "distance of A from O", {0, 10})};
  explicit TwoLegs(const Parameters& p) : apart_(p["apart"]) {}

  Topology topology() const {
    Topology t;
    t.coordinates = {{"x", "x", "m", 0.1, {0.05, 0.25}}, {"y", "y", "m", 0.2, {0.1, 0.3}}};
    t.platform = t.add(Body{"table", 0, false, {}});
    t.add(Body{"carriage", 0, false, {}});
    t.add(Joint{"X", JointKind::prismatic, 0, 2, {}});
    t.add(Joint{"Y", JointKind::prismatic, 2, 1, {}});
    for (int i = 0; i < 2; ++i) {
      const std::string n = std::to_string(i + 1);
      t.add(Body{"cylinder " + n, i + 1, false, {}});
      t.add(Body{"piston " + n, i + 1, false, {}});
      t.add(Joint{"A" + n, JointKind::revolute, 0, 3 + 2 * i, {}});
      t.add(Joint{"P" + n, JointKind::prismatic, 3 + 2 * i, 4 + 2 * i, {}});
      t.add(Joint{"B" + n, JointKind::revolute, 4 + 2 * i, 1, {}});
      t.add(Actuator{"l" + n, "leg " + n, "m", 3 * i + 3, {0, 1}});
    }
    t.constraints = {{"force_z", "", "N"}, {"couple_x", "", "N*m"}, {"couple_y", "", "N*m"}, {"couple_z", "", "N*m"}};
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], T(0.0)), x = Eigen::Vector3d::UnitX().cast<T>(), y = Eigen::Vector3d::UnitY().cast<T>(),
                                            z = Eigen::Vector3d::UnitZ().cast<T>(), foot(q[0], T(0.0), T(0.0));
    const Matrix3<T> level = Eigen::Matrix3d::Identity().cast<T>();
    at.body(1, p, level);
    at.body(2, foot, level);
    at.joint(0, foot, x);
    at.joint(1, p, y);
    for (int i = 0; i < 2; ++i) {
      const Vector3<T> a = Eigen::Vector3d(i * apart_, 0, 0).cast<T>(), leg = p - a, n = unit(leg);
      at.body(3 + 2 * i, a, frame_xz(n, z));
      at.body(4 + 2 * i, p, frame_xz(n, z));
      at.joint(2 + 3 * i, a, z);
      at.joint(3 + 3 * i, p, n);
      at.joint(4 + 3 * i, p, z);
      at.actuator(i, length(leg));
    }
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 3; ++k) g(i, k) = at.axis(3 + 3 * i)(k);
    for (int k = 0; k < 4; ++k) g(2 + k, 2 + k) = T(1.0);
    return g;
  }

 private:
  double apart_;
};

// Compiled once for all tests: of the table of a mechanism much is made.
const pm_mechanism& two_legs();

}  // namespace pmreport::test
