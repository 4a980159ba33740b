// A small mechanism to attack proofs with: a carriage slides along X, a table on it turns about Z, and everything else is as its
// parameters ask, so that what is true of a motion can be told by hand.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <pmreport/mechanism.hpp>

namespace pmreport::test {

class Probe : public Mechanism<2> {
 public:
  static constexpr const char *determinants[] = {"one", "x", "inverse", "sign"}, *turns[] = {"phi", "cut", "jump", "kink", "least", "most"};
  static constexpr const char *name = "probe", *title = "slide and turntable", *source = "made for the tests";
  static constexpr Parameter parameters[] = {
      Parameter::choice("determinant", determinants, 0, "of G: 1, x, 1/x, or the sign of x"),
      Parameter::choice("turn", turns, 0, "second actuator: phi, its angle from -pi to pi, phi + (x < 0), |phi|, min(phi, x), max(phi, x)"),
      Parameter::length("reach", 100, "largest x that can be assembled"),
      Parameter::number("half_limit", 3, {0.01, 4}, "rad", "deg", "of the table's joint, either way"),
  };

  explicit Probe(const Parameters& p) : determinant_(p.choice("determinant")), turn_(p.choice("turn")), reach_(p["reach"]) {
    t_.coordinates = {{"x", "slide", "m", 0.1, {0.05, 0.2}}, {"phi", "turn", "rad", 0, {-0.2, 0.2}}};
    t_.derived = {{"height", "height of a feeler", "m", false}};
    const int carriage = t_.add(Body{"carriage", 1, false, Inertia::axisymmetric(3, 0, 0.05, 0.05)});
    t_.platform = t_.add(Body{"table", 0, false, Inertia::axisymmetric(2, 0, 0.01, 0.02)});
    const int slide = t_.add(Joint{"P", JointKind::prismatic, 0, carriage, {}});
    const int turn = t_.add(Joint{"R", JointKind::revolute, carriage, t_.platform, {{-p["half_limit"], p["half_limit"]}}});
    t_.add(Actuator{"q", "slide", "m", slide, {-0.5, 0.5}});
    t_.add(Actuator{"psi", "turn", "rad", turn, {-2, 2}});
    for (const char* n : {"c1", "c2", "c3", "c4"}) t_.constraints.push_back({n, n, "N"});
  }
  Topology topology() const { return t_; }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    at.require(reach_ - q[0], "the slide is too short");
    const T x = q[0], phi = q[1];
    const Vector3<T> origin(x, T(0.0), T(0.0));
    at.body(1, origin, Matrix3<T>::Identity());
    at.body(2, origin, rotation_z(phi));
    at.joint(0, origin, Vector3<T>(T(1.0), T(0.0), T(0.0)));
    at.joint(1, origin, Vector3<T>(T(0.0), T(0.0), T(1.0)));
    at.actuator(0, x);
    at.actuator(1, turned(x, phi));
    at.derived(0, x * sin(phi));
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    for (const auto& [row, column] : {std::pair{0, 0}, {1, 5}, {2, 1}, {3, 2}, {4, 3}, {5, 4}}) g(row, column) = T(1.0);
    const T x = at.actuator(0);
    if (determinant_ == "x") g(0, 0) = x;
    if (determinant_ == "inverse") g(0, 0) = 1.0 / x;
    if (determinant_ == "sign") g(0, 0) = choose(x < 0.0, T(-1.0), T(1.0));
    g(0, 1) = T(0.25) * g(0, 0) * x;
    return g;
  }

 private:
  template <class T>
  T turned(const T& x, const T& phi) const {
    if (turn_ == "cut") return atan2(sin(phi), cos(phi));
    if (turn_ == "jump") return choose(x < 0.0, phi + 1.0, phi);
    if (turn_ == "kink") return abs(phi);
    if (turn_ == "least") return smaller(phi, x);
    if (turn_ == "most") return larger(phi, x);
    return phi;
  }

  std::string_view determinant_, turn_;
  double reach_;
  Topology t_;
};

}  // namespace pmreport::test
