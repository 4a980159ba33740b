// Four SPS limbs and one SPR limb, five degrees of freedom.
//
// Equation numbers are those of Wang et al. 2017; README.md beside this file says which of its numbers reproduce and where it errs.
//
// Limb i runs from A_i on the base to B_i = p + R b_i on the platform. Limbs 1 to 4 end in balls on both sides and spin freely. Limb 5 ends
// in a revolute joint at B_5 whose axis n6 = R n6p is fixed in the platform; the limb stays perpendicular to it, which takes one freedom:
//     n6 . (A_5 - B_5) = 0   <=>   n6 . (p - A_5) + n6p . b_5 = 0          (C)
// The chosen dependent coordinate of the pose follows from the other five.
#include <pmreport/elastic.hpp>
#include <pmreport/leg.hpp>
#include <pmreport/mechanism.hpp>
#include <pmreport/parts.hpp>

using namespace pmreport;
using Eigen::Vector3d;
namespace {
constexpr double pi = std::numbers::pi, deg = pi / 180;
constexpr const char* origins[] = {"home", "normal"};
constexpr const char* pose_names[] = {"x", "y", "z", "alpha", "beta", "gamma"};
constexpr const char* pose_titles[] = {"X position", "Y position", "Z position", "turn about Z", "turn about Y1", "turn about X2"};
constexpr double perpendicular_axis[] = {0, 0, 0}, platform_inertia[] = {0.03, 0.03, 0.055, 0, 0, 0};

constexpr int platform = 1;
constexpr auto limbs = legs<5>(platform + 1);
constexpr const Leg& spr = limbs[4];

class FourSpsSpr : public Mechanism<5> {
 public:
  static constexpr const char* name = "4sps-spr";
  static constexpr const char* title = "4SPS-SPR: four SPS limbs and one SPR limb, 5 degrees of freedom";
  static constexpr const char* source =
      "Wang et al. 2017, Kinematics and statics analyses of a parallel manipulator with five active limbs";
  static constexpr Parameter parameters[] = {
      Parameter::length("base_radius", 0.400, "radius r_a of the circle of A2 to A5"),
      Parameter::length("platform_radius", 0.100, "radius r_b of the circle of B1 to B5"),
      Parameter::length("base_offset", 0.500, "distance W of A1 from O along X", {-100, 100}),
      Parameter::angle("platform_angle", 0, "azimuth phi of B1 on the platform"),
      Parameter::length("home_height", 0.550, "height Z0 of p above O at home", {0.001, 100}),
      Parameter::numbers("revolute_axis", perpendicular_axis, {-1, 1}, 3, 3, "", "", "axis n6, platform axes; 0 0 0: horizontal at home"),
      Parameter::choice("dependent", pose_names, 1, "pose coordinate that follows from the revolute axis"),
      Parameter::length("stroke_min", 0.450, "shortest limb", {0.001, 100}),
      Parameter::length("stroke_max", 0.850, "longest limb", {0.001, 100}),
      Parameter::angle("base_cone", 45 * deg, "largest deflection of a base ball joint", {0, pi}),
      Parameter::angle("platform_cone", 45 * deg, "largest deflection of a platform ball joint", {0, pi}),
      Parameter::choice("cones_from", origins, 0, "what both cones count from: home, or the normals of base and platform"),
      Parameter::angle("revolute_angle", 60 * deg, "largest rotation of the revolute joint from home", {0, pi}),
      Parameter::mass("platform_mass", 8, "mass m_o of the platform, centre of mass at p"),
      Parameter::numbers("platform_inertia", platform_inertia, {-1e6, 1e6}, 6, 6, "kg*m^2", "kg*m^2", "about p: xx yy zz xy xz yz"),
      Parameter::mass("cylinder_mass", 4, "mass m_q of a cylinder"),
      Parameter::length("cylinder_centre", 0.2, "centre of mass of a cylinder from A_i, l_q"),
      Parameter::inertia("cylinder_inertia", 0.06, "transverse inertia of a cylinder about its centre of mass"),
      Parameter::inertia("cylinder_axial_inertia", 0.003, "axial inertia of a cylinder"),
      Parameter::mass("piston_mass", 2, "mass m_p of a piston"),
      Parameter::length("piston_centre", 0.2, "centre of mass of a piston from B_i, l_p"),
      Parameter::inertia("piston_inertia", 0.03, "transverse inertia of a piston about its centre of mass"),
      Parameter::inertia("piston_axial_inertia", 0.0008, "axial inertia of a piston"),
      Parameter::choice("material", material_names, 0, "material of the limbs"),
      Parameter::length("limb_diameter", 0.03, "outer diameter of a limb as a beam", {0.0001, 10}),
      Parameter::length("limb_bore", 0.015, "inner diameter of a limb as a beam", {0, 10}),
      Parameter::number("drive_stiffness", 40e6, {1, 1e15}, "N/m", "N/um", "stiffness of a limb's drive, in series with the limb"),
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
    // By place_sps and place_leg this would be five lines, and partial derivatives cost half as much again: two bodies of code to inline.
    for (const Leg& limb : limbs) {
      const auto a = a_[std::size_t(limb.drive)].cast<T>().eval();
      const Vector3<T> b = p + r * b_[std::size_t(limb.drive)], along = b - a;  // Eq. (4)
      const T l = length(along);
      const Vector3<T> n = along * T(1.0 / l);  // Eq. (5)
      at.joint(limb.low, a);
      at.joint(limb.slide, b, n);
      at.actuator(limb.drive, l);
      if (limb.drive != spr.drive) {
        at.slender(limb.cylinder, a, n);
        at.slender(limb.piston, b, n);
        at.joint(limb.high, b);
      } else {  // the revolute joint lets limb 5 spin with the platform only
        const Matrix3<T> turned = frame_xz(n6, n);
        at.body(limb.cylinder, a, turned);
        at.body(limb.piston, b, turned);
        at.joint(limb.high, b, n6);
      }
    }
  }

  // Eq. (10): an actuator's force acts along n_i through B_i; the constraint force along n6 through A_5, where the joint S cannot give way.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Vector3<T> p = at.origin(platform);
    Matrix6<T> g;
    for (const Leg& limb : limbs) force_row<T>(g, limb.drive, at.axis(limb.slide), at.centre(limb.high) - p);
    force_row<T>(g, 5, at.axis(spr.high), at.centre(spr.low) - p);
    return g;
  }

 private:
  // (C) is linear in p: p_k = (c - sum of the other n6_j p_j) / n6_k, c = n6 . A_5 - n6p . b_5. Useless as n6 turns away from axis k.
  template <class T>
  T dependent_position(const std::array<T, 6>& pose, const Vector3<T>& n6, Placement<T>& at) const {
    const int k = dependent_, i = (k + 1) % 3, j = (k + 2) % 3;
    at.require(abs(n6(k)) - 0.05, "the revolute axis is almost perpendicular to the dependent coordinate, which it no longer determines");
    return (n6.dot(a_[4]) - offset_ - n6(i) * pose[std::size_t(i)] - n6(j) * pose[std::size_t(j)]) / n6(k);
  }

  // In one angle t of the pose (C) reads P cos t + Q sin t + D = 0: its left side at t = 0, pi/2, pi tells P, Q, D.
  template <class T>
  Vector3<T> harmonics(std::array<T, 6> pose) const {
    const auto left = [&](double t) {
      pose[std::size_t(dependent_)] = T(t);
      const Vector3<T> n6 = rotation_zyx(pose[3], pose[4], pose[5]) * n6p_, from_a5 = Vector3<T>(pose[0], pose[1], pose[2]) - a_[4];
      return T(n6.dot(from_a5) + offset_);
    };
    const T at_0 = left(0), at_pi = left(pi), d = 0.5 * (at_0 + at_pi);
    return {0.5 * (at_0 - at_pi), left(pi / 2) - d, d};
  }
  // Of its roots t = atan2(Q, P) +- acos(-D / |(P, Q)|) the sign that gives t = 0 at home; they meet only where the pose goes out of reach.
  template <class T>
  T dependent_angle(const std::array<T, 6>& pose, Placement<T>& at) const {
    const Vector3<T> pqd = harmonics(pose);
    const T ratio = -pqd(2) / hypot(pqd(0), pqd(1));
    at.require(1.0 - abs(ratio), "no value of the dependent angle makes limb 5 perpendicular to the revolute axis");
    return atan2(pqd(1), pqd(0)) + root_ * acos(ratio);
  }

  Topology describe(const Parameters& p) const;

  std::array<Vector3d, 5> a_, b_;  // A_i in base axes, b_i in platform axes
  Range stroke_{};
  Vector3d n6p_;       // revolute axis, platform axes
  double offset_ = 0;  // n6p . b_5
  int dependent_ = 1;  // index into the pose
  double root_ = 1;    // sign of the root of a dependent angle
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
  stroke_ = range_of(p, "stroke_min", "stroke_max");

  const Vector3d limb5 = a_[4] - Vector3d(0, 0, p["home_height"]) - b_[4];
  n6p_ = Vector3d(p.numbers("revolute_axis").data());
  if (n6p_.isZero()) n6p_ = Vector3d(-limb5.y(), limb5.x(), 0);
  n6p_.normalize();
  if (!(abs(n6p_.dot(limb5)) < 1e-6 * limb5.norm()))
    refuse("home cannot be assembled: revolute_axis must be perpendicular to limb 5 there, (", limb5.x(), ", ", limb5.y(), ", ", limb5.z(),
           ")");
  offset_ = n6p_.dot(b_[4]);

  dependent_ = static_cast<int>(std::ranges::find(pose_names, p.choice("dependent")) - pose_names);
  double slope = n6p_(dependent_ % 3);  // of (C) by the dependent coordinate at home, relative
  if (dependent_ >= 3) slope = harmonics(std::array<double, 6>{0, 0, p["home_height"]})(1) / limb5.norm();
  if (abs(slope) < 0.05) refuse(pose_names[dependent_], " cannot be the dependent coordinate: it is not determined at home");
  root_ = slope > 0 ? -1 : 1;
  topology_ = describe(p);
}

Topology FourSpsSpr::describe(const Parameters& p) const {
  Topology t;
  const double height = p["home_height"], tube = 0.95 * stroke_.min;  // no part is drawn longer than the shortest limb
  for (int k = 0; k < 3; ++k)
    t.add(Coordinate::around(k == 2 ? height : 0, 0.18 * height, pose_names[k], pose_titles[k], "m"), k == dependent_);
  for (int k = 3; k < 6; ++k) t.add(Coordinate::around(0, 5 * deg, pose_names[k], pose_titles[k], "rad"), k == dependent_);
  t.platform = t.add(Body{"platform", 0, false, Inertia::central(p["platform_mass"], p.numbers("platform_inertia"))});
  Telescope telescope{"cylinder ",
                      "piston ",
                      "l",
                      "length of limb ",
                      axisymmetric(p, "cylinder", p["cylinder_centre"]),
                      axisymmetric(p, "piston", -p["piston_centre"]),
                      stroke_};
  const Vector3d normal(0, 0, p.choice("cones_from") == "normal" ? 1 : 0);
  for (const Leg& limb : limbs) {
    const std::string n = std::to_string(limb.limb);
    telescope.slender = limb.drive != spr.drive;
    const Joint ball{"B" + n, JointKind::spherical, limb.piston, platform, {up_to(p["platform_cone"])}, -1, normal},
        hinge{"B" + n, JointKind::revolute, platform, limb.piston, {either_way(p["revolute_angle"])}};
    add_leg(t, limb, n, telescope, {"A" + n, JointKind::spherical, 0, limb.cylinder, {up_to(p["base_cone"])}, -1, normal},
            telescope.slender ? ball : hinge);
    t.add(beam("limb" + n, limb.low, limb.high, material_of(p, "material"), tube_of(p, "limb")));
    t.add(spring_drive("drive" + n, limb.drive, p["drive_stiffness"]));
    draw_leg(t, limb, tube, 0.030 * height, 0.017 * height);
  }
  t.constraints.push_back({"constraint1", "force F_tau along the revolute axis through A5", "N"});
  t.idle = 4;
  return t;
}
}  // namespace
PMREPORT_PLUGIN(FourSpsSpr)
