// Two small mechanisms whose motions under forces are known in closed form.
#pragma once

#include <pmreport/mechanism.hpp>

namespace pmreport::test {

// A physical pendulum: mass 3 kg, its centre 0.4 m below the hinge, moment of inertia 0.2 kg m^2 about that centre; `theta` about Y, 0
// where it hangs, gravity along -Z. Driven at the hinge; or by a yoke without mass that slides along X and holds a pin 0.1 m from the
// hinge, s = r sin(theta): singular where the pin stands highest and lowest.
class Pendulum : public Mechanism<1> {
 public:
  static constexpr const char* drives[] = {"hinge", "yoke"};
  static constexpr const char *name = "pendulum", *title = "physical pendulum", *source = "a test";
  static constexpr Parameter parameters[] = {
      Parameter::choice("drive", drives, 0, "where it is driven"),
      Parameter::number("lowest", -10, {-10, 10}, "rad", "deg", "lower end of the stroke, at the hinge"),
      Parameter::number("turn", 10, {0, 10}, "rad", "deg", "limit of the hinge, either way"),
      Parameter::number("room", 10, {0, 10}, "rad", "deg", "angle that it has room for, either way")};
  static constexpr double mass = 3, arm = 0.4, about_centre = 0.2, about_hinge = about_centre + mass * arm * arm, radius = 0.1;

  explicit Pendulum(const Parameters& p) : yoke_(p.choice("drive") == "yoke"), lowest_(p["lowest"]), turn_(p["turn"]), room_(p["room"]) {}

  Topology topology() const {
    Topology t;
    t.coordinates = {{"theta", "angle", "rad", 0, {-1, 1}}};
    t.platform = t.add(Body{"bob", 0, false, {mass, {0, 0, -arm}, Eigen::Matrix3d::Identity() * about_centre}});
    const int slide = t.add(Body{"yoke", 0, false, {}});
    const int hinge = t.add(Joint{"O", JointKind::revolute, 0, t.platform, {{-turn_, turn_}}});
    const int way = t.add(Joint{"P", JointKind::prismatic, 0, slide, {}});
    if (yoke_)
      t.add(Actuator{"s", "yoke", "m", way, {-1, 1}});
    else
      t.add(Actuator{"psi", "hinge", "rad", hinge, {lowest_, 10}});
    for (const char* n : {"c1", "c2", "c3", "c4", "c5"}) t.constraints.push_back({n, n, "N"});
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    at.require(room_ - abs(q[0]), "a wall is in the way");
    const T s = radius * sin(q[0]);
    const Vector3<T> o = Eigen::Vector3d::Zero().cast<T>(), yoke(s, T(0.0), T(0.0));
    at.body(1, o, rotation_y(q[0]));
    at.body(2, yoke, Eigen::Matrix3d::Identity().cast<T>());
    at.joint(0, o, Eigen::Vector3d::UnitY().cast<T>());
    at.joint(1, yoke, Eigen::Vector3d::UnitX().cast<T>());
    at.actuator(0, yoke_ ? s : q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Constant(T(0.0));
    g(0, 4) = yoke_ ? radius * at.rotation(1)(0, 0) : T(1.0);
    for (const auto& [row, column] : {std::pair{1, 0}, {2, 1}, {3, 2}, {4, 3}, {5, 5}}) g(row, column) = T(1.0);
    return g;
  }

 private:
  bool yoke_;
  double lowest_, turn_, room_;
};

// A trolley of 5 kg that slides along X, and a load of 2 kg with 0.1 kg m^2 that hangs from it, its centre `arm` below the hinge; `theta`
// about Y. With no arm the two move by themselves.
class Trolley : public Mechanism<2> {
 public:
  static constexpr const char *name = "trolley", *title = "trolley with a swinging load", *source = "a test";
  static constexpr Parameter parameters[] = {Parameter::number("arm", 0.5, {0, 1}, "m", "mm", "length of the pendulum")};
  static constexpr double trolley_mass = 5, load_mass = 2, about_centre = 0.1;

  explicit Trolley(const Parameters& p) : arm_(p["arm"]) {}

  Topology topology() const {
    Topology t;
    t.coordinates = {{"x", "trolley", "m", 0, {-1, 1}}, {"theta", "load", "rad", 0, {-1, 1}}};
    const int trolley = t.add(Body{"trolley", 1, false, {trolley_mass, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity()}});
    t.platform = t.add(Body{"load", 0, false, {load_mass, {0, 0, -arm_}, Eigen::Matrix3d::Identity() * about_centre}});
    const int slide = t.add(Joint{"P", JointKind::prismatic, 0, trolley, {}});
    const int hinge = t.add(Joint{"R", JointKind::revolute, trolley, t.platform, {}});
    t.add(Actuator{"drive", "trolley", "m", slide, {-100, 100}});
    t.add(Actuator{"hinge", "hinge", "rad", hinge, {-100, 100}});
    for (const char* n : {"c1", "c2", "c3", "c4"}) t.constraints.push_back({n, n, "N"});
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> o(q[0], T(0.0), T(0.0));
    at.body(1, o, Eigen::Matrix3d::Identity().cast<T>());
    at.body(2, o, rotation_y(q[1]));
    at.joint(0, o, Eigen::Vector3d::UnitX().cast<T>());
    at.joint(1, o, Eigen::Vector3d::UnitY().cast<T>());
    for (int i = 0; i < 2; ++i) at.actuator(i, q[static_cast<std::size_t>(i)]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    Matrix6<T> g = Matrix6<T>::Constant(T(0.0));
    for (const auto& [row, column] : {std::pair{0, 0}, {1, 4}, {2, 1}, {3, 2}, {4, 3}, {5, 5}}) g(row, column) = T(1.0);
    return g;
  }

 private:
  double arm_;
};

const pm_mechanism& pendulum();
const pm_mechanism& trolley();

}  // namespace pmreport::test
