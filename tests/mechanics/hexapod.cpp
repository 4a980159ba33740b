#include <core/numbers.hpp>
#include <pmreport/mechanism.hpp>
#include <tests/mechanics/mechanisms.hpp>

namespace pmreport::test {

namespace {

using Eigen::Vector3d;

constexpr const char* base_joints[] = {"ball", "universal"};
constexpr double azimuth_a[] = {15 * deg, 105 * deg, 135 * deg, 225 * deg, 255 * deg, 345 * deg};
constexpr double azimuth_b[] = {45 * deg, 75 * deg, 165 * deg, 195 * deg, 285 * deg, 315 * deg};

constexpr int platform = 1;
constexpr int cylinder(int i) { return 2 + 2 * i; }
constexpr int piston(int i) { return 3 + 2 * i; }

class Hexapod : public Mechanism<6> {
 public:
  static constexpr const char *name = "hexapod", *title = "Gough's platform", *source = "a test";
  static constexpr Parameter parameters[] = {Parameter::choice("base_joint", base_joints, 0, "joint at the base")};

  explicit Hexapod(const Parameters& p) : universal_(p.choice("base_joint") == "universal") {
    for (std::size_t i = 0; i < 6; ++i) {
      a_[i] = 0.5 * Vector3d(cos(azimuth_a[i]), sin(azimuth_a[i]), 0);
      b_[i] = 0.25 * Vector3d(cos(azimuth_b[i]), sin(azimuth_b[i]), 0);
    }
  }
  Topology topology() const {
    Topology t;
    for (const char* s : {"x", "y", "z"}) t.coordinates.push_back({s, s, "m", 0, {-0.1, 0.1}});
    t.coordinates[2].home = 0.6;
    t.coordinates[2].box = {0.5, 0.7};
    for (const char* s : {"alpha", "beta", "gamma"}) t.coordinates.push_back({s, s, "rad", 0, {-0.25, 0.25}});
    t.platform = t.add(Body{"platform", 0, false, {}});
    for (int i = 0; i < 6; ++i) {
      const std::string n = std::to_string(i + 1);
      t.add(Body{"cylinder " + n, i + 1, !universal_, {}});
      t.add(Body{"piston " + n, i + 1, !universal_, {}});
      t.add(Joint{"A" + n, universal_ ? JointKind::universal : JointKind::spherical, 0, cylinder(i), {}});
      t.add(Joint{"P" + n, JointKind::prismatic, cylinder(i), piston(i), {}});
      t.add(Joint{"B" + n, JointKind::spherical, piston(i), platform, {}});
      t.add(Actuator{"l" + n, "limb " + n, "m", 3 * i + 1, {0.4, 1.2}});
    }
    t.idle = universal_ ? 0 : 6;
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]);
    const Matrix3<T> r = rotation_zyx(q[3], q[4], q[5]);
    at.body(platform, p, r);
    for (int i = 0; i < 6; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Vector3<T> a = a_[k].cast<T>(), b = p + r * b_[k];
      const Vector3<T> limb = b - a;
      const Vector3<T> n = unit(limb);
      if (universal_) {
        const Vector3d tangent(-sin(azimuth_a[k]), cos(azimuth_a[k]), 0);
        const Vector3<T> second = unit(Vector3<T>(tangent.cast<T>().cross(n)));
        const Matrix3<T> frame = frame_xz(second, n);
        at.body(cylinder(i), a, frame);
        at.body(piston(i), b, frame);
        at.joint(3 * i, a, tangent.cast<T>(), second);
      } else {
        at.slender(cylinder(i), a, n);
        at.slender(piston(i), b, n);
        at.joint(3 * i, a);
      }
      at.joint(3 * i + 1, b, n);
      at.joint(3 * i + 2, b);
      at.actuator(i, length(limb));
    }
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g;
    for (int i = 0; i < 6; ++i) {
      const Vector3<T> n = at.axis(3 * i + 1), r = at.centre(3 * i + 2) - at.origin(platform);
      const Vector3<T> moment = r.cross(n);
      for (int k = 0; k < 3; ++k) g(i, k) = n(k), g(i, k + 3) = moment(k);
    }
    return g;
  }

 private:
  bool universal_;
  std::array<Vector3d, 6> a_, b_;
};

}  // namespace

const pm_mechanism& hexapod() { return contract::mechanism<Hexapod>; }

}  // namespace pmreport::test
