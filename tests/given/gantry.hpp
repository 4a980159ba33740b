// A carriage on two rails that are one too many: every reaction can be worked out by hand.
//
//     base ==P1 along X, driven== platform        base ==P2 along X== trolley (limb 1) ==R about Z== platform
//
// All three joints have their centre at (x, 0, 0). Of the wrench that goes round the loop all but the force along X, which both rails let
// through, and the couple about Z, which the hinge does, is a self-stress: four of them. The drive moves both masses.
#pragma once

#include <pmreport/mechanism.hpp>

namespace gantry {

using namespace pmreport;

inline constexpr double platform_mass = 2, trolley_mass = 1;  // [kg]

class Gantry : public Mechanism<1> {
 public:
  static constexpr const char *name = "gantry", *title = "gantry", *source = "made for the tests";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Gantry(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"x", "place on the rails", "m", 0, {-0.2, 0.2}}};
    const Eigen::Matrix3d round = 0.01 * Eigen::Matrix3d::Identity();
    t.platform = t.add(Body{"platform", 0, false, {platform_mass, Eigen::Vector3d::Zero(), round}});
    t.add(Body{"trolley", 1, false, {trolley_mass, Eigen::Vector3d::Zero(), round}});
    t.add(Joint{"P1", JointKind::prismatic, 0, 1, {}});
    t.add(Joint{"P2", JointKind::prismatic, 0, 2, {}});
    t.add(Joint{"R", JointKind::revolute, 2, 1, {}});
    t.add(Actuator{"q", "drive", "m", 0, {-1, 1}});
    for (const char* n : {"force_y", "force_z"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"couple_x", "couple_y", "couple_z"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> here(q[0], T(0.0), T(0.0)), x = Eigen::Vector3d::UnitX().cast<T>();
    for (const int body : {1, 2}) at.body(body, here, Matrix3<T>(Matrix3<T>::Identity()));
    at.joint(0, here, x);
    at.joint(1, here, x);
    at.joint(2, here, Eigen::Vector3d::UnitZ().cast<T>());
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Matrix6<T>::Identity();
  }
};

const pm_mechanism& table();

}  // namespace gantry
