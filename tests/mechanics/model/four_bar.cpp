#include <pmreport/mechanism.hpp>
#include <tests/mechanics/mechanisms.hpp>

namespace pmreport::test {

namespace {

using Eigen::Vector3d;

class FourBar : public Mechanism<1> {
 public:
  static constexpr const char *name = "four-bar", *title = "planar four-bar linkage", *source = "a test";
  static constexpr std::array<Parameter, 0> parameters{};
  enum { crank = 1, coupler = 2, rocker = 3 };

  explicit FourBar(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"theta", "crank angle", "rad", 1.0, {0.5, 1.5}}};
    t.add(Body{"crank", 0, false, {}});
    t.platform = t.add(Body{"coupler", 0, false, {}});
    t.add(Body{"rocker", 0, false, {}});
    t.add(Joint{"A", JointKind::revolute, 0, crank, {}});
    t.add(Joint{"B", JointKind::revolute, crank, coupler, {}});
    t.add(Joint{"C", JointKind::revolute, coupler, rocker, {}});
    t.add(Joint{"D", JointKind::revolute, 0, rocker, {}});
    t.add(Actuator{"q", "crank", "rad", 0, {-3, 3}});
    t.constraints = {
        {"force_crank", "", "N"}, {"force_rocker", "", "N"}, {"force_z", "", "N"}, {"couple_x", "", "N*m"}, {"couple_y", "", "N*m"}};
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> z = Vector3d::UnitZ().cast<T>(), a = Vector3d::Zero().cast<T>(), d = Vector3d(0.5, 0, 0).cast<T>();
    const Vector3<T> along(cos(q[0]), sin(q[0]), T(0.0));
    const Vector3<T> b = along * T(0.2);
    // C is where the circles about B (coupler) and D (rocker) meet, on the side of positive z x BD.
    const Vector3<T> bd = d - b;
    const T distance = length(bd);
    const T foot = (square(distance) + 0.45 * 0.45 - 0.35 * 0.35) / (2.0 * distance);
    const T radicand = 0.45 * 0.45 - square(foot);
    at.require(radicand, "coupler and rocker do not reach each other");
    const Vector3<T> across = z.cross(bd);
    const Vector3<T> c = b + (bd * foot + across * sqrt(radicand)) * T(1.0 / distance);
    at.body(crank, a, frame_xz(along, z));
    at.body(coupler, b, frame_xz(unit(Vector3<T>(c - b)), z));
    at.body(rocker, d, frame_xz(unit(Vector3<T>(c - d)), z));
    at.joint(0, a, z);
    at.joint(1, b, z);
    at.joint(2, c, z);
    at.joint(3, d, z);
    at.actuator(0, q[0]);
  }
  // The crank's torque reaches the coupler as a force across the crank at B; crank and rocker hold it along themselves.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Vector3<T> b = at.centre(1), c = at.centre(2), u = unit(Vector3<T>(b - at.centre(0))), e = unit(Vector3<T>(c - at.centre(3)));
    const Vector3<T> across = at.axis(0).cross(u) * T(1.0 / 0.2), moment = (c - b).cross(e);
    Matrix6<T> g = Matrix6<T>::Constant(T(0.0));
    for (int k = 0; k < 3; ++k) g(0, k) = across(k), g(1, k) = u(k), g(2, k) = e(k), g(2, k + 3) = moment(k);
    g(3, 2) = g(4, 3) = g(5, 4) = T(1.0);
    return g;
  }
};

}  // namespace

const pm_mechanism& four_bar() { return contract::mechanism<FourBar>; }

}  // namespace pmreport::test
