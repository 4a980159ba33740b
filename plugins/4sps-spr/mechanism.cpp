// Four SPS limbs and one SPR limb, five degrees of freedom.
//
// X. Wang, D. Zhao, J. Huang, C. Li, C. Zhang, B. Zhang: Kinematics and statics analyses of a parallel manipulator with five active limbs,
// 2017. Equation numbers are the paper's; README.md beside this file says which of its numbers reproduce and where it errs.
//
// Limb i runs from A_i on the base to B_i = p + R b_i on the platform. Limbs 1 to 4 end in balls on both sides and spin freely. Limb 5 ends
// in a revolute joint at B_5 whose axis n6 = R n6p is fixed in the platform; the limb stays perpendicular to it:
//
//     n6 . (A_5 - B_5) = 0   <=>   n6 . (p - A_5) = -n6p . b_5          (C)
//
// (C) takes one freedom: the chosen dependent coordinate of the pose follows from the other five.
#include <fmt/core.h>

#include <pmreport/mechanism.hpp>

using namespace pmreport;
using Eigen::Vector3d;

namespace {

constexpr double pi = std::numbers::pi, deg = pi / 180;
constexpr const char* pose_names[] = {"x", "y", "z", "alpha", "beta", "gamma"};
constexpr const char* pose_titles[] = {"X position",       "Y position",        "Z position",
                                       "rotation about Z", "rotation about Y1", "rotation about X2"};
constexpr double perpendicular_axis[] = {0, 0, 0};
constexpr double platform_inertia[] = {0.03, 0.03, 0.055, 0, 0, 0};

// Bodies and joints of limb i = 0..4.
constexpr int platform = 1;
constexpr int cylinder(int i) { return 2 + 2 * i; }
constexpr int piston(int i) { return 3 + 2 * i; }
constexpr int joint_a(int i) { return 3 * i; }
constexpr int joint_p(int i) { return 3 * i + 1; }
constexpr int joint_b(int i) { return 3 * i + 2; }

class FourSpsSpr : public Mechanism<5> {
 public:
  static constexpr const char* name = "4sps-spr";
  static constexpr const char* title = "4SPS-SPR: four SPS limbs and one SPR limb, 5 degrees of freedom";
  static constexpr const char* source =
      "X. Wang et al., Kinematics and statics analyses of a parallel manipulator with five active limbs, 2017";
  static constexpr Parameter parameters[] = {
      Parameter::length("base_radius", 0.400, "radius r_a of the circle of A2 to A5"),
      Parameter::length("platform_radius", 0.100, "radius r_b of the circle of B1 to B5"),
      Parameter::length("base_offset", 0.500, "distance W of A1 from O along X", {-100, 100}),
      Parameter::angle("platform_angle", 0, "azimuth phi of B1 on the platform"),
      Parameter::length("home_height", 0.550, "height Z0 of p above O at home", {0.001, 100}),
      Parameter::numbers("revolute_axis", perpendicular_axis, {-1, 1}, 3, 3, "", "",
                         "axis n6 of the revolute joint in platform axes; 0 0 0: horizontal and perpendicular to limb 5 at home"),
      Parameter::choice("dependent", pose_names, 1, "pose coordinate that follows from the revolute axis"),
      Parameter::length("stroke_min", 0.450, "shortest limb", {0.001, 100}),
      Parameter::length("stroke_max", 0.850, "longest limb", {0.001, 100}),
      Parameter::angle("base_cone", 45 * deg, "largest deflection of a base ball joint from home", {0, pi}),
      Parameter::angle("platform_cone", 45 * deg, "largest deflection of a platform ball joint from home", {0, pi}),
      Parameter::angle("revolute_angle", 60 * deg, "largest rotation of the revolute joint from home", {0, pi}),
      Parameter::mass("platform_mass", 8, "mass m_o of the platform, centre of mass at p"),
      Parameter::numbers("platform_inertia", platform_inertia, {-1e6, 1e6}, 6, 6, "kg*m^2", "kg*m^2",
                         "inertia I_o of the platform about p: xx yy zz xy xz yz"),
      Parameter::mass("cylinder_mass", 4, "mass m_q of a cylinder"),
      Parameter::length("cylinder_centre", 0.2, "centre of mass of a cylinder from A_i, l_q"),
      Parameter::inertia("cylinder_inertia", 0.06, "transverse inertia of a cylinder about its centre of mass"),
      Parameter::inertia("cylinder_axial_inertia", 0.003, "axial inertia of a cylinder"),
      Parameter::mass("piston_mass", 2, "mass m_p of a piston"),
      Parameter::length("piston_centre", 0.2, "centre of mass of a piston from B_i, l_p"),
      Parameter::inertia("piston_inertia", 0.03, "transverse inertia of a piston about its centre of mass"),
      Parameter::inertia("piston_axial_inertia", 0.0008, "axial inertia of a piston"),
  };

  explicit FourSpsSpr(const Parameters& p);
  Topology topology() const { return topology_; }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    std::array<T, 6> pose;
    for (int k = 0, i = 0; k < 6; ++k)
      if (k != dependent_) pose[std::size_t(k)] = q[std::size_t(i++)];
    auto& [x, y, z, alpha, beta, gamma] = pose;
    if (dependent_ >= 3) pose[std::size_t(dependent_)] = dependent_angle(pose, at);
    const Matrix3<T> r = rotation_zyx(alpha, beta, gamma);
    const Vector3<T> n6 = r * n6p_;
    if (dependent_ < 3) pose[std::size_t(dependent_)] = dependent_position(pose, n6, at);
    const Vector3<T> p(x, y, z);

    at.body(platform, p, r);
    at.derived(0, pose[std::size_t(dependent_)]);
    for (int i = 0; i < 5; ++i) {
      const Vector3d& a = a_[std::size_t(i)];
      const Vector3<T> b = p + r * b_[std::size_t(i)];
      const Vector3<T> limb = b - a;  // Eq. (4)
      const T l = length(limb);
      const Vector3<T> n = limb * T(1.0 / l);  // Eq. (5)
      at.joint(joint_a(i), a.cast<T>());
      at.joint(joint_p(i), b, n);
      at.actuator(i, l);
      if (i < 4) {
        at.slender(cylinder(i), a.cast<T>(), n);
        at.slender(piston(i), b, n);
        at.joint(joint_b(i), b);
      } else {  // the revolute joint lets limb 5 spin with the platform only
        const Matrix3<T> turned = frame_xz(n6, n);
        at.body(cylinder(i), a.cast<T>(), turned);
        at.body(piston(i), b, turned);
        at.joint(joint_b(i), b, n6);
      }
    }
  }

  // Eq. (10): an actuator's force acts along n_i through B_i; the constraint force along n6 through A_5, where the line meets no axis that
  // could give way. Moments about p.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Vector3<T> p = at.origin(platform);
    Matrix6<T> g;
    const auto row = [&](int i, const Vector3<T>& force, const Vector3<T>& through) {
      const Vector3<T> moment = (through - p).cross(force);
      for (int k = 0; k < 3; ++k) g(i, k) = force(k), g(i, k + 3) = moment(k);
    };
    for (int i = 0; i < 5; ++i) row(i, at.axis(joint_p(i)), at.centre(joint_b(i)));
    row(5, at.axis(joint_b(4)), at.centre(joint_a(4)));
    return g;
  }

 private:
  // (C) is linear in p: p_k = (c - sum of the other n6_j p_j) / n6_k, c = n6 . A_5 - n6p . b_5. Useless as n6 turns away from axis k.
  template <class T>
  T dependent_position(const std::array<T, 6>& pose, const Vector3<T>& n6, Placement<T>& at) const {
    const int k = dependent_;
    at.require(abs(n6(k)) - 0.05, "the revolute axis is almost perpendicular to the dependent coordinate, which it no longer determines");
    T rest = n6.dot(a_[4]) - offset_;
    for (int j = 0; j < 3; ++j)
      if (j != k) rest -= n6(j) * pose[std::size_t(j)];
    return rest / n6(k);
  }

  // In one angle t (C) reads P cos t + Q sin t = S. With e the axis of that rotation, u the vector n6p turned by the rotations after it,
  // and s = p - A_5 turned back by those before it: P = u.s - (u.e)(s.e), Q = (e x u).s, S = -(u.e)(s.e) - n6p.b_5. Of the two roots t =
  // atan2(Q, P) +- acos(S / |(P, Q)|) the sign is kept that gives t = 0 at home; they meet only where the pose goes out of reach.
  template <class T>
  struct AngleEquation {
    T p, q, s;
  };
  template <class T>
  AngleEquation<T> angle_equation(const std::array<T, 6>& pose) const {
    const auto& [x, y, z, alpha, beta, gamma] = pose;
    Vector3<T> u = n6p_.cast<T>();
    Vector3<T> s = Vector3<T>(x, y, z) - a_[4];
    if (dependent_ < 5) u = rotation_x(gamma) * u;
    if (dependent_ < 4) u = rotation_y(beta) * u;
    if (dependent_ > 3) s = rotation_z(alpha).transpose() * s;
    if (dependent_ > 4) s = rotation_y(beta).transpose() * s;
    const int e = std::min(5 - dependent_, 2);  // alpha about Z, beta about Y, gamma about X
    const T along = u(e) * s(e);
    return {u.dot(s) - along, Vector3d::Unit(e).template cast<T>().cross(u).dot(s), -along - offset_};
  }
  template <class T>
  T dependent_angle(const std::array<T, 6>& pose, Placement<T>& at) const {
    const AngleEquation<T> e = angle_equation(pose);
    const T ratio = e.s / hypot(e.p, e.q);
    at.require(1.0 - abs(ratio), "no value of the dependent angle makes limb 5 perpendicular to the revolute axis");
    return atan2(e.q, e.p) + root_ * acos(ratio);
  }

  Topology describe(const Parameters& p, double home_height) const;

  std::array<Vector3d, 5> a_, b_;  // A_i in base axes, b_i in platform axes
  Vector3d n6p_;                   // revolute axis, platform axes
  double offset_ = 0;              // n6p . b_5
  int dependent_ = 1;              // index into the pose
  double root_ = 1;                // sign of the root of a dependent angle
  Topology topology_;
};

FourSpsSpr::FourSpsSpr(const Parameters& p) {
  constexpr double azimuth_a[] = {0, 45 * deg, 135 * deg, 225 * deg, 315 * deg};
  for (std::size_t i = 0; i < 5; ++i) {
    const double azimuth_b = p["platform_angle"] + 72 * deg * double(i);
    a_[i] = p["base_radius"] * Vector3d(cos(azimuth_a[i]), sin(azimuth_a[i]), 0);
    b_[i] = p["platform_radius"] * Vector3d(cos(azimuth_b), sin(azimuth_b), 0);
  }
  a_[0] = {p["base_offset"], 0, 0};
  if (p["stroke_min"] >= p["stroke_max"]) throw std::invalid_argument("stroke_min must be less than stroke_max");

  const double home_height = p["home_height"];
  const Vector3d limb5 = a_[4] - Vector3d(0, 0, home_height) - b_[4];
  n6p_ = Vector3d(p.numbers("revolute_axis").data());
  if (n6p_.isZero()) n6p_ = Vector3d(-limb5.y(), limb5.x(), 0);
  n6p_.normalize();
  if (!(abs(n6p_.dot(limb5)) < 1e-6 * limb5.norm()))
    throw std::invalid_argument(
        sentence("home cannot be assembled: revolute_axis must be perpendicular to limb 5 there, which points along (", limb5.x(), ", ",
                 limb5.y(), ", ", limb5.z(), "); the limb has ", n6p_.dot(limb5) * 1e3, " mm along the axis"));
  offset_ = n6p_.dot(b_[4]);

  const std::string_view word = p.choice("dependent");
  dependent_ = static_cast<int>(std::find(std::begin(pose_names), std::end(pose_names), word) - std::begin(pose_names));
  const double turning = angle_equation(std::array<double, 6>{0, 0, home_height, 0, 0, 0}).q / limb5.norm();
  root_ = turning > 0 ? -1 : 1;
  if (abs(dependent_ < 3 ? n6p_(dependent_) : turning) < 0.05)
    throw std::invalid_argument(sentence(word, " cannot be the dependent coordinate: the revolute axis does not determine it at home"));
  topology_ = describe(p, home_height);
}

Topology FourSpsSpr::describe(const Parameters& p, double home_height) const {
  Topology t;
  for (int k = 0; k < 6; ++k) {
    const double home = k == 2 ? home_height : 0, half = k < 3 ? 0.18 * home_height : 5 * deg;
    const std::string unit = k < 3 ? "m" : "rad";
    if (k == dependent_)
      t.derived.push_back({pose_names[k], pose_titles[k], unit, true});
    else
      t.coordinates.push_back({pose_names[k], pose_titles[k], unit, home, {home - half, home + half}});
  }
  const auto i6 = p.numbers("platform_inertia");
  Inertia plate{p["platform_mass"], Vector3d::Zero(), {}};
  plate.about_centre << i6[0], i6[3], i6[4], i6[3], i6[1], i6[5], i6[4], i6[5], i6[2];
  t.platform = t.add(Body{"platform", 0, false, plate});

  const Inertia q = Inertia::axisymmetric(p["cylinder_mass"], p["cylinder_centre"], p["cylinder_inertia"], p["cylinder_axial_inertia"]);
  const Inertia r = Inertia::axisymmetric(p["piston_mass"], -p["piston_centre"], p["piston_inertia"], p["piston_axial_inertia"]);
  const Range stroke{p["stroke_min"], p["stroke_max"]};
  const double tube = 0.95 * stroke.min;  // drawn: neither part may reach through the far joint of the shortest limb
  for (int i = 0; i < 5; ++i) {
    const std::string n = std::to_string(i + 1);
    const bool slender = i < 4;
    t.add(Body{"cylinder " + n, i + 1, slender, q});
    t.add(Body{"piston " + n, i + 1, slender, r});
    t.add(Joint{"A" + n, JointKind::spherical, 0, cylinder(i), {{0, p["base_cone"]}}});
    t.add(Joint{"P" + n, JointKind::prismatic, cylinder(i), piston(i), {}});
    if (slender)
      t.add(Joint{"B" + n, JointKind::spherical, piston(i), platform, {{0, p["platform_cone"]}}});
    else
      t.add(Joint{"B" + n, JointKind::revolute, piston(i), platform, {{-p["revolute_angle"], p["revolute_angle"]}}});
    t.add(Actuator{"l" + n, "length of limb " + n, "m", joint_p(i), stroke});
    t.shapes.push_back({cylinder(i), ShapeKind::cylinder, {0, 0, 0}, {0, 0, tube}, 0.030 * home_height});
    t.shapes.push_back({piston(i), ShapeKind::cylinder, {0, 0, -tube}, {0, 0, 0}, 0.017 * home_height});
  }
  t.constraints.push_back({"constraint1", "force F_tau along the revolute axis through A5", "N"});
  t.idle = 4;
  return t;
}

}  // namespace

PMREPORT_PLUGIN(FourSpsSpr)
