// Clavel's Delta robot: three arms turned by motors on the base carry a platform on paired rods, three translations.
//
// In the base's axes limb i stands at azimuth phi_i: u_i points outwards, v_i along the motor's axis, k = Z up. The platform hangs below
// and keeps the base's orientation, because each pair of rods is a parallelogram with sides along v_i. Halfway between its rods lie
//     A_i = R u_i                                on the motor's axis,
//     B_i = A_i + L e_i,                         the elbow, e_i = cos(theta_i) u_i - sin(theta_i) k: theta lowers the arm from level,
//     C_i = p + r u_i                            on the platform,
// and the rods close the limb when they have their length:
//     |C_i - B_i| = l                                                                                                              (1)
#include <pmreport/elastic.hpp>
#include <pmreport/mechanism.hpp>
#include <pmreport/parts.hpp>

using namespace pmreport;
using Eigen::Vector3d;
namespace {
constexpr double pi = std::numbers::pi, deg = pi / 180;
constexpr const char* elbows[] = {"out", "in"};
constexpr const char* axes[] = {"x", "y", "z"};
constexpr const char* axis_titles[] = {"X position", "Y position", "Z position"};

constexpr int platform = 1;
struct Limb {  // bodies and joints of limb i = 0..2; rod k = 0, 1
  int i, arm = 2 + 3 * i, a = 5 * i;
  int rod(int k) const { return arm + 1 + k; }
  int b(int k) const { return a + 1 + k; }
  int c(int k) const { return a + 3 + k; }
};

class Delta : public Mechanism<3> {
 public:
  static constexpr const char* name = "delta";
  static constexpr const char* title = "Delta: three driven arms, each with a pair of rods, 3 translations";
  static constexpr const char* source =
      "Clavel 1988, DELTA, a fast robot with parallel geometry; sizes of a FlexPicker as in Williams 2016";
  static constexpr Parameter parameters[] = {
      Parameter::length("base_radius", 0.2, "distance R of the motors' axes from O"),
      Parameter::length("platform_radius", 0.08, "distance r of the rods from p, on the platform"),
      Parameter::length("arm_length", 0.524, "length L of an arm, from the motor's axis to the elbow", {0.001, 100}),
      Parameter::length("rod_length", 1.244, "length l of a rod, from ball to ball", {0.001, 100}),
      Parameter::length("rod_spacing", 0.1, "distance s of the two rods of a limb", {0.001, 100}),
      Parameter::working_mode("elbow1", elbows, 0, "elbow of limb 1: arm above or below the line from A1 to C1"),
      Parameter::working_mode("elbow2", elbows, 0, "elbow of limb 2"),
      Parameter::working_mode("elbow3", elbows, 0, "elbow of limb 3"),
      Parameter::angle("arm_highest", -50 * deg, "smallest angle of an arm", {-pi / 2, 3 * pi / 2}),
      Parameter::angle("arm_lowest", 100 * deg, "largest angle of an arm", {-pi / 2, 3 * pi / 2}),
      Parameter::angle("ball_cone", 60 * deg, "largest deflection of a ball joint from home", {0, pi}),
      Parameter::mass("platform_mass", 0.6, "mass of the platform with its gripper, centre of mass at p"),
      Parameter::mass("arm_mass", 1.2, "mass of an arm, a uniform tube"),
      Parameter::mass("rod_mass", 0.14, "mass of one rod, a uniform tube"),
      Parameter::inertia("motor_inertia", 0.035, "inertia of a motor and its gear, felt at the arm"),
      Parameter::choice("arm_material", material_names, 3, "material of the arms"),
      Parameter::length("arm_diameter", 0.06, "outer diameter of an arm as a beam", {0.0001, 10}),
      Parameter::length("arm_bore", 0.05, "inner diameter of an arm as a beam", {0, 10}),
      Parameter::choice("bar_material", material_names, 6, "material of the rods"),
      Parameter::length("bar_diameter", 0.014, "outer diameter of a rod as a beam", {0.0001, 10}),
      Parameter::length("bar_bore", 0.010, "inner diameter of a rod as a beam", {0, 10}),
      Parameter::number("drive_stiffness", 20000, {1e-3, 1e12}, "N*m/rad", "N*m/rad", "stiffness of a motor with its gear"),
  };

  explicit Delta(const Parameters& p);
  Topology topology() const { return topology_; }

  // With d = C_i - A_i = p + (r - R) u_i, and a = d . u_i, c = -d . k its shares in the plane of the arm, (1) squared is
  //     a cos(theta) + c sin(theta) = m,     m = (|d|^2 + L^2 - l^2) / 2L.
  // So the arm's direction (cos, sin) has the component m / h along (a, c), h^2 = a^2 + c^2, and w / h across, w^2 = h^2 - m^2: to the one
  // side or the other, elbow out or in. The two meet where w = 0, arm and rods in one plane, and beyond the limb does not reach.
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]);
    at.body(platform, p, Eigen::Matrix3d::Identity().cast<T>());
    for (const Limb limb : limbs_) {
      const Vector3d &u = u_[limb.i], &v = v_[limb.i], motor = base_radius_ * u;
      const Vector3<T> d = p + (platform_radius_ - base_radius_) * u;
      const T a = d.dot(u), c = -d(2), h2 = a * a + c * c, m = (d.dot(d) + square(arm_) - square(rod_)) * (0.5 / arm_);
      const T w2 = h2 - m * m;
      at.require(w2, "a platform joint is too far from its motor, or too near, for arm and rods");
      const T w = elbow_[limb.i] * sqrt(w2), cosine = (m * a + w * c) / h2, sine = (m * c - w * a) / h2;

      const Vector3<T> axis = v.cast<T>(), along = cosine * u - sine * Vector3d::UnitZ();  // v_i, e_i
      const Vector3<T> elbow = motor + arm_ * along, wrist = p + platform_radius_ * u;     // B_i, C_i
      const Vector3<T> n = (wrist - elbow) * (1.0 / rod_);
      at.body(limb.arm, motor.cast<T>(), frame_xz(axis, along));
      at.joint(limb.a, motor.cast<T>(), axis);
      at.actuator(limb.i, pi / 2 - atan2(cosine, sine));  // jumps by a turn only where the arm points straight up
      for (int k = 0; k < 2; ++k) {
        const Vector3d aside = (k - 0.5) * spacing_ * v;
        at.slender(limb.rod(k), elbow + aside, n);
        at.joint(limb.b(k), elbow + aside);
        at.joint(limb.c(k), wrist + aside);
      }
    }
  }

  // Along the rods, n_i, elbow and platform have the same speed: n_i . v = n_i . t_i L theta_i', t_i = v_i x e_i being the way the elbow
  // goes. So a motor's torque reaches the platform as a force along n_i through C_i. The difference of the forces in the two rods is a
  // couple across both, along v_i x n_i; three of them hold the platform's orientation, unless they become coplanar.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g;
    for (const Limb limb : limbs_) {
      const Vector3<T> n = at.spine(limb.rod(0)), axis = at.axis(limb.a), t = axis.cross(at.rotation(limb.arm).col(2));
      const Vector3<T> wrist = 0.5 * (at.centre(limb.c(0)) + at.centre(limb.c(1))) - at.origin(platform);
      const T lever = arm_ * n.dot(t);
      force_row<T>(g, limb.i, n / lever, wrist);
      couple_row<T>(g, 3 + limb.i, unit<T>(axis.cross(n)));
    }
    return g;
  }

  // (1) squared and differentiated: (C_i - B_i) . p' - L (C_i - B_i) . t_i theta_i' = 0, that is A p' + B theta' = 0.
  std::vector<Eigen::MatrixXd> matrices(const Coordinates<double>&, const Placement<double>& at) const {
    Eigen::MatrixXd a(3, 3), b = Eigen::MatrixXd::Zero(3, 3);
    for (const Limb limb : limbs_) {
      const Vector3d rod = rod_ * at.spine(limb.rod(0)), t = v_[limb.i].cross(at.rotation(limb.arm).col(2));
      a.row(limb.i) = rod;
      b(limb.i, limb.i) = -arm_ * rod.dot(t);
    }
    return {a, b};
  }

 private:
  Topology describe(const Parameters& p) const;

  static constexpr Limb limbs_[] = {{0}, {1}, {2}};

  double base_radius_, platform_radius_, arm_, rod_, spacing_;
  double elbow_[3];       // 1 out, -1 in
  double home_;           // height of p with level arms, elbows out
  Vector3d u_[3], v_[3];  // outwards, and along the motor's axis
  Topology topology_;
};

Delta::Delta(const Parameters& p)
    : base_radius_(p["base_radius"]),
      platform_radius_(p["platform_radius"]),
      arm_(p["arm_length"]),
      rod_(p["rod_length"]),
      spacing_(p["rod_spacing"]),
      elbow_{p.choice("elbow1") == "out" ? 1.0 : -1.0, p.choice("elbow2") == "out" ? 1.0 : -1.0, p.choice("elbow3") == "out" ? 1.0 : -1.0} {
  constexpr double azimuth[] = {-90 * deg, 30 * deg, 150 * deg};
  for (int i = 0; i < 3; ++i) {
    u_[i] = {cos(azimuth[i]), sin(azimuth[i]), 0};
    v_[i] = {-sin(azimuth[i]), cos(azimuth[i]), 0};
  }
  const double across = base_radius_ + arm_ - platform_radius_;
  if (!(abs(across) < 0.98 * rod_))
    refuse("home has level arms, from whose elbows the rods must hang: rod_length must be above ", abs(across) / 0.98, " m");
  if (p["arm_highest"] >= p["arm_lowest"]) refuse("arm_highest must be less than arm_lowest: theta lowers the arm");
  home_ = -sqrt(square(rod_) - square(across));
  topology_ = describe(p);
}

Topology Delta::describe(const Parameters& p) const {
  Topology t;
  for (int k = 0; k < 3; ++k)
    t.add(Coordinate::around(k == 2 ? home_ : 0, (k == 2 ? 0.12 : 0.24) * rod_, axes[k], axis_titles[k], "m"), false);
  t.platform = t.add(Body{"platform", 0, false, Inertia::solid_cylinder(p["platform_mass"], 0.1 * arm_, platform_radius_, 0)});
  Inertia arm = Inertia::solid_cylinder(p["arm_mass"], arm_, 0.05 * arm_, 0.5 * arm_);
  arm.about_centre(0, 0) += p["motor_inertia"];
  const Inertia rod = Inertia::solid_cylinder(p["rod_mass"], rod_, 0.006 * rod_, 0.5 * rod_);
  const std::vector<Range> cone{up_to(p["ball_cone"])};
  const double tube = 0.04 * arm_, wide = 0.5 * spacing_;  // base and platform are drawn as plates, from their joints
  for (const Limb limb : limbs_) {
    const std::string n = std::to_string(limb.i + 1), rods[] = {n + "1", n + "2"};
    t.add(Body{"arm " + n, limb.i + 1, false, arm});
    t.add(Joint{"A" + n, JointKind::revolute, 0, limb.arm, {}});  // bounded by the stroke
    for (int k = 0; k < 2; ++k) {
      t.add(Body{"rod " + rods[k], limb.i + 1, true, rod});
      t.add(Joint{"B" + rods[k], JointKind::spherical, limb.arm, limb.rod(k), cone});
      t.draw_along_axis(limb.rod(k), 0, rod_, 0.35 * tube);
    }
    for (int k = 0; k < 2; ++k) t.add(Joint{"C" + rods[k], JointKind::spherical, limb.rod(k), platform, cone});
    t.add(Actuator{"theta" + n, "angle of arm " + n + " below level", "rad", limb.a, {p["arm_highest"], p["arm_lowest"]}});
    t.constraints.push_back({"couple" + n, "couple of the rods of limb " + n + " on the platform", "N*m"});
    t.add(arm_beam("arm" + n, limb.a, limb.b(0), limb.b(1), material_of(p, "arm_material"), tube_of(p, "arm")));
    for (const int k : {0, 1}) t.add(beam("rod" + rods[k], limb.b(k), limb.c(k), material_of(p, "bar_material"), tube_of(p, "bar")));
    t.add(spring_drive("drive" + n, limb.i, p["drive_stiffness"]));
    t.draw_along_axis(limb.arm, 0, arm_, tube);
    t.shapes.push_back({limb.arm, ShapeKind::cylinder, {-wide, 0, 0}, {wide, 0, 0}, 1.5 * tube});
    t.shapes.push_back({limb.arm, ShapeKind::cylinder, {-wide, 0, arm_}, {wide, 0, arm_}, 0.5 * tube});
  }
  t.matrices = {{"A", "closure by the position, C_i - B_i in its rows [m]", 3, 3, Rates::coordinates, Rates::none, 0},
                {"B", "closure by the arms' angles [m^2]", 3, 3, Rates::actuators, Rates::none, 0}};
  t.idle = 6;  // every rod may spin about itself
  return t;
}
}  // namespace
PMREPORT_PLUGIN(Delta)
