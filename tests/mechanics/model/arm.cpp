#include <pmreport/mechanism.hpp>
#include <tests/mechanics/mechanisms.hpp>

namespace pmreport::test {

namespace {

using Eigen::Vector3d;

class Arm : public Mechanism<3> {
 public:
  static constexpr const char *name = "arm", *title = "a turning arm with a sleeve", *source = "a test";
  static constexpr std::array<Parameter, 0> parameters{};
  enum { boom = 1, sleeve = 2 };

  explicit Arm(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"theta", "boom", "rad", 0.2, {-0.5, 0.9}}, {"d", "sleeve", "m", 0.3, {0.2, 0.4}}, {"phi", "roll", "rad", 0, {-1, 1}}};
    t.add(Body{"boom", 0, false, {}});
    t.platform = t.add(Body{"sleeve", 0, false, {}});
    t.add(Joint{"O", JointKind::revolute, 0, boom, {}});
    t.add(Joint{"S", JointKind::cylindrical, boom, sleeve, {}});
    t.add(Actuator{"theta_motor", "", "rad", 0, {-3, 3}});
    t.add(Actuator{"slide", "", "m", 1, {0, 1}});
    t.add(Actuator{"roll", "", "rad", 1, {-3, 3}});
    t.constraints = {{"couple_y", "", "N*m"}, {"force_z", "", "N"}, {"force_y", "", "N"}};
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Matrix3<T> turned = rotation_z(q[0]);
    const Vector3<T> x = turned.col(0), origin = Vector3d::Zero().cast<T>();
    const Vector3<T> p = x * q[1];
    at.body(boom, origin, turned);
    at.body(sleeve, p, turned * rotation_x(q[2]));
    at.joint(0, origin, Vector3d::UnitZ().cast<T>());
    at.joint(1, p, x);
    for (int i = 0; i < 3; ++i) at.actuator(i, q[static_cast<std::size_t>(i)]);
  }
  // With x and y of the boom: theta' = w_z, d' = x . v, phi' = x . w; and 0 = y . w, 0 = v_z, 0 = y . v - d w_z.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Matrix3<T> r = at.rotation(boom);
    Matrix6<T> g = Matrix6<T>::Constant(T(0.0));
    g(0, 5) = g(4, 2) = T(1.0);
    for (int k = 0; k < 3; ++k) g(1, k) = g(2, k + 3) = r(k, 0), g(3, k + 3) = g(5, k) = r(k, 1);
    g(5, 5) = -at.actuator(1);
    return g;
  }
};

}  // namespace

const pm_mechanism& arm() { return contract::mechanism<Arm>; }

}  // namespace pmreport::test
