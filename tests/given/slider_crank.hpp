// A spatial slider-crank with one degree of freedom, and with faults that can be switched on: a suite of tests must be able to fail.
//
// A crank of radius r turns about k through O; a rod of length L runs in balls from its pin B to the slider C, which travels along e
// through C0. The rod spins freely. The slider drives, the crank carries the load. With B = r (cos theta, sin theta, 0):
//   |C0 + s e - B| = L   =>   s = e . f + sqrt(L^2 - |f|^2 + (e . f)^2),   f = B - C0,
// and, with n along the rod from B to C, the rod's length is kept when n . e s' = n . (k x B) theta': dead centre where rod, crank and
// axis lie in a plane.
#pragma once

#include <pmreport/mechanism.hpp>

namespace pmreport::test {

class SliderCrank : public Mechanism<1> {
 public:
  static constexpr const char* faults[] = {"none",      "gap",          "axis",          "jacobian",     "idle",     "actuator", "unit",
                                           "lanes",     "rates",        "partials",      "partials_nan", "recorded", "reach",    "nan",
                                           "jet_lanes", "acceleration", "body_partials", "mass",         "inertia"};
  static constexpr const char *name = "slider-crank", *title = "spatial slider-crank", *source = "a test";
  static constexpr Parameter parameters[] = {Parameter::choice("fault", faults, 0, "what is wrong with it"),
                                             Parameter::length("crank", 0.2, "radius r of the crank"),
                                             Parameter::length("rod", 0.5, "length L of the rod")};
  enum { crank = 1, rod = 2, slider = 3 };

  explicit SliderCrank(const Parameters& p) : fault_(p.choice("fault")), radius_(p["crank"]), length_(p["rod"]) {}

  Topology topology() const {
    Topology t;
    t.coordinates = {{"theta", "crank angle", "rad", 0.8, {0.3, 1.4}}};
    const double about_k = fault("inertia") ? -0.9 : 0.004;
    t.platform = t.add(Body{"crank", 0, false, {0.8, {0.1, 0, 0.02}, Eigen::Vector3d(0.001, 0.004, about_k).asDiagonal()}});
    t.add(Body{"rod", 0, true, Inertia::axisymmetric(0.5, 0.25, 0.01, 1e-4)});
    t.add(Body{"slider", 0, false, {fault("mass") ? -1e-3 : 1.2, {0, 0.03, 0}, Eigen::Matrix3d::Zero()}});
    t.add(Joint{"O", JointKind::revolute, 0, crank, {}});
    t.add(Joint{"B", JointKind::spherical, crank, rod, {}});
    t.add(Joint{"C", JointKind::spherical, rod, slider, {}, rod});
    t.add(Joint{"P", JointKind::prismatic, 0, slider, {}});
    t.add(Actuator{"s", "slider", "m", 3, {0, 1}});
    t.derived = {{"height", "height of the pin", "m", false}};
    t.constraints = {{"force_x", "", "N"}, {"force_y", "", "N"}, {"force_z", "", "N"}, {"couple_x", "", "N*m"}, {"couple_y", "", "N*m"}};
    t.idle = fault("idle") ? 0 : 1;
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const T c = cos(q[0]), s = sin(q[0]);
    const Vector3<T> o = Eigen::Vector3d::Zero().cast<T>(), k = Eigen::Vector3d::UnitZ().cast<T>();
    const Vector3<T> along(c, s, T(0.0));
    const Vector3<T> b = along * T(radius_);
    const Vector3<T> f = b - c0();
    const T ahead = f.dot(e().cast<T>());
    const T radicand = length_ * length_ - f.dot(f) + square(ahead);
    at.require(radicand, "the rod is too short");
    const T travel = ahead + sqrt(radicand);
    const Vector3<T> end = e() * travel + c0();
    const Vector3<T> n = (end - b) * T(1.0 / length_);

    Vector3<T> rod_at = b;
    if (fault("gap")) rod_at(1) += 1e-3 * q[0];
    Vector3<T> axis = k;
    if (fault("axis")) axis = Eigen::Vector3d(1e-3, 0, 1).normalized().cast<T>();
    if (fault("unit")) axis = axis * T(1.001);
    T height = s * radius_;
    if constexpr (std::is_same_v<T, Jet<double>> || std::is_same_v<T, Jet<Lanes>>) {
      if (fault("rates")) height.rate = height.rate * 1.001;
      if (fault("acceleration")) height.acceleration = height.acceleration * 1.001;
    }
    if constexpr (std::is_same_v<T, Lanes>)
      if (fault("lanes")) height = height + 1e-6;
    if constexpr (std::is_same_v<T, Jet<Lanes>>)
      if (fault("jet_lanes")) height.rate = height.rate + 1e-6;
    if constexpr (std::is_same_v<T, Partials<double, 1>> || std::is_same_v<T, Partials<Lanes, 1>>) {
      if (fault("partials")) height.partial[0] = height.partial[0] * 1.001;
      if (fault("body_partials")) rod_at(2).partial[0] = 1e-3;
      if (fault("partials_nan")) rod_at(0).partial[0] = 0.0 / (height.partial[0] * 0.0);
    }
    if constexpr (std::is_same_v<T, Recorded>)
      if (fault("recorded")) height = height + 1e-9;
    if (fault("reach")) at.require(0.05 - abs(q[0] - 0.8), "the crank has no room");
    if (fault("nan")) height = height * sqrt(0.9 - q[0]) / sqrt(0.9 - q[0]);

    at.body(crank, o, frame_xz(along, k));
    at.slender(rod, rod_at, n);
    at.body(slider, end, Eigen::Matrix3d::Identity().cast<T>());
    at.joint(0, o, axis);
    at.joint(1, b);
    at.joint(2, end);
    at.joint(3, end, e().cast<T>());
    at.actuator(0, travel * scale());
    at.derived(0, height);
  }

  // s' = n . v_B / (n . e): the rod pushes the crank along itself.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Vector3<T> b = at.centre(1), n = at.spine(rod);
    const T factor = (fault("jacobian") ? 1.001 : scale()) / n.dot(e().cast<T>());
    const Vector3<T> force = n * factor, moment = b.cross(force);
    Matrix6<T> g = Matrix6<T>::Constant(T(0.0));
    for (int i = 0; i < 3; ++i) g(0, i) = force(i), g(0, i + 3) = moment(i), g(i + 1, i) = T(1.0);
    g(4, 3) = g(5, 4) = T(1.0);
    return g;
  }

  static Eigen::Vector3d e() { return Eigen::Vector3d(1, 0.2, 0.4).normalized(); }  // the slider's axis
  static Eigen::Vector3d c0() { return {0.1, 0.05, 0.15}; }

 private:
  bool fault(std::string_view which) const { return fault_ == which; }
  double scale() const { return fault("actuator") ? 1.001 : 1.0; }

  std::string_view fault_;
  double radius_, length_;
};

// Compiled once for all tests: of the table of a mechanism much is made.
const pm_mechanism& slider_crank();

}  // namespace pmreport::test
