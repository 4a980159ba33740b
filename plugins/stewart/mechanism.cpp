// Stewart's platform of 1965: three legs between base and platform, each held sideways by a second drive near its foot.
//
// Notation of Glazunov et al. 2008, who compare it with their own mechanisms; README.md beside this file says what of the paper reproduces
// and where it errs. Leg i runs from A_i on the base to B_i = P + R b_i on the platform, R = Rz(alpha) Rx(beta) Ry(gamma). v_i = A_iB_i,
// rho_i = |v_i|, u_i = v_i / rho_i. Cross chain i runs from C_i = A_j, the foot of the next leg, to D_i = A_i + l2 u_i on leg i;
// w_i = C_iD_i, rho_{3+i} = |w_i|, f_i = w_i / rho_{3+i}.
#include <pmreport/elastic.hpp>
#include <pmreport/free_platform.hpp>
#include <pmreport/leg.hpp>
#include <pmreport/mechanism.hpp>
#include <pmreport/parts.hpp>

using namespace pmreport;
using Eigen::MatrixXd;
using Eigen::Vector3d;
namespace {
constexpr double pi = std::numbers::pi, deg = pi / 180;
constexpr const char* origins[] = {"home", "normal"};

constexpr int platform = 1;
constexpr auto chains = legs<6>(platform + 1);  // legs 0..2, cross chains 3..5, each from a ball to a Cardan joint

class Stewart : public Mechanism<6> {
 public:
  static constexpr const char* name = "stewart";
  static constexpr const char* title = "Stewart's platform of 1965: three legs, each with two drives, 6 degrees of freedom";
  static constexpr const char* source =
      "Glazunov, Briot, Arakelyan et al. 2008, Development of manipulators with a parallel-cross structure; Stewart 1965";
  static constexpr Parameter parameters[] = {
      Parameter::length("base_radius", 0.3, "radius R_b of the circle of A1 to A3", {0.001, 100}),
      Parameter::length("platform_radius", 0.2, "radius R_pl of the circle of B1 to B3, and of the platform", {0.001, 100}),
      Parameter::length("attachment", 0.2, "distance l2 from A_i to D_i along leg i"),
      Parameter::length("home_height", 0.95, "height of P above O at home", {0.001, 100}),
      Parameter::length("leg_min", 0.76, "shortest leg"),
      Parameter::length("leg_max", 1.41, "longest leg"),
      Parameter::length("cross_min", 0.2, "shortest cross chain"),
      Parameter::length("cross_max", 0.9, "longest cross chain"),
      Parameter::angle("base_cone", 60 * deg, "largest deflection of a base joint A", {0, pi}),
      Parameter::choice("cones_from", origins, 0, "what base_cone counts from: home, or the base's normal"),
      Parameter::angle("platform_cone", 60 * deg, "largest turn of a platform joint B from home, about either axis", {0, pi}),
      Parameter::angle("cross_cone", 60 * deg, "largest deflection of a joint C, and turn of a joint D, from home", {0, pi}),
      Parameter::mass("platform_mass", 10, "mass of the platform, a disc about P"),
      Parameter::length("platform_thickness", 0.03, "thickness of the disc"),
      Parameter::mass("leg_cylinder_mass", 4, "mass of a leg's cylinder"),
      Parameter::length("leg_cylinder_length", 0.76,
                        "a leg's cylinder ends so far beyond A_i; it begins there, or at the lowest attachment"),
      Parameter::length("leg_cylinder_radius", 0.03, "radius of a leg's cylinder"),
      Parameter::mass("leg_rod_mass", 2, "mass of a leg's rod"),
      Parameter::length("leg_rod_length", 0.7, "length of a leg's rod, back from B_i"),
      Parameter::length("leg_rod_radius", 0.02, "radius of a leg's rod"),
      Parameter::mass("cross_cylinder_mass", 2, "mass of a cross chain's cylinder"),
      Parameter::length("cross_cylinder_length", 0.3, "length of a cross chain's cylinder, from C_i"),
      Parameter::length("cross_cylinder_radius", 0.02, "radius of a cross chain's cylinder"),
      Parameter::mass("cross_rod_mass", 1.5, "mass of a cross chain's rod"),
      Parameter::length("cross_rod_length", 0.3, "length of a cross chain's rod, back from D_i"),
      Parameter::length("cross_rod_radius", 0.015, "radius of a cross chain's rod"),
      Parameter::choice("material", material_names, 0, "material of legs and cross chains"),
      Parameter::length("leg_diameter", 0.04, "outer diameter of a leg as a beam", {0.0001, 10}),
      Parameter::length("leg_bore", 0.02, "inner diameter of a leg as a beam", {0, 10}),
      Parameter::length("cross_diameter", 0.03, "outer diameter of a cross chain as a beam", {0.0001, 10}),
      Parameter::length("cross_bore", 0.015, "inner diameter of a cross chain as a beam", {0, 10}),
      Parameter::number("drive_stiffness", 50e6, {1, 1e15}, "N/m", "N/um", "stiffness of every drive, in series with its leg or chain"),
  };

  explicit Stewart(const Parameters& p);
  Topology topology() const { return topology_; }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]);
    const Matrix3<T> r = place_free(at, platform, q);
    for (const std::size_t i : {0u, 1u, 2u}) {
      const Matrix3<T> leg = chain<T>(at, i, {a_[i].cast<T>(), p + r * b_[i]}, r * e1_[i]);
      const Vector3<T> u = leg.col(2);
      const Vector3<T> f = chain<T>(at, 3 + i, {a_[(i + 1) % 3].cast<T>(), u * l2_ + a_[i]}, leg * e1_[3 + i]).col(2);
      at.derived(int(i), acos(T(u.dot(f))));
    }
  }

  // Both drives of a leg act on the platform in B_i. D_i = A_i + l2 u_i is carried along by it: u_i' = (I - u_i u_i^T) B_i' / rho_i.
  //     rho_i' = u_i . B_i',   rho_{3+i}' = f_i . D_i' = F_i . B_i',   F_i = (l2 / rho_i) (I - u_i u_i^T) f_i
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g;
    for (std::size_t i = 0; i < 3; ++i) {
      const Leg &leg = chains[i], &cross = chains[3 + i];
      const Vector3<T> arm = at.centre(leg.high) - at.origin(platform), u = at.axis(leg.slide), f = at.axis(cross.slide);
      force_row<T>(g, leg.drive, u, arm);
      force_row<T>(g, cross.drive, (f - u * u.dot(f)) * T(l2_ / at.actuator(leg.drive)), arm);
    }
    return g;
  }

  // The paper's matrices. Constraint equations, X = (x, y, z, alpha, beta, gamma):
  //     f_i = rho_i^2 - v_i . v_i = 0,   f_{3+i} = rho_{3+i}^2 - w_i . w_i = 0,   w_i = A_jA_i + (l2 / rho_i) v_i
  //     A X' + B rho' = 0,  A = df/dX,  B = df/drho;   t = D X'
  std::vector<MatrixXd> matrices(const Coordinates<double>& q, const Placement<double>& at) const {
    Matrix6<double> a, b = Matrix6<double>::Zero();
    const Matrix6<double> d = twist_map(q, at.rotation(platform));
    for (std::size_t k = 0; k < 3; ++k) {
      const Leg &leg = chains[k], &cross = chains[3 + k];
      const int i = leg.drive, c = cross.drive;
      const Vector3d v = at.centre(leg.high) - at.centre(leg.low), w = at.centre(cross.high) - at.centre(cross.low);
      const double rho = at.actuator(i);
      const auto partials = point_partials(d, at.centre(leg.high) - at.origin(platform));  // dB_i/dX
      a.row(i) = -2 * v.transpose() * partials;
      a.row(c) = -2 * l2_ / rho * w.transpose() * partials;
      b(i, i) = 2 * rho;
      b(c, c) = 2 * at.actuator(c);
      b(c, i) = 2 * l2_ / (rho * rho) * w.dot(v);
    }
    return {a, b, d};
  }

 private:
  template <class T>
  static Matrix3<T> chain(Placement<T>& at, std::size_t i, const Line<T>& line, const Vector3<T>& e1) {
    return place_spu(at, chains[i], line, e1, "a chain points along the first axis of its Cardan joint, and its spin is undetermined");
  }
  Topology describe(const Parameters& p) const;

  std::array<Vector3d, 3> a_, b_;  // A_i in base axes, b_i in platform axes
  std::array<Vector3d, 6> e1_;     // first Cardan axes: of B_i in platform axes, of D_i in the body axes of leg i
  double l2_ = 0;
  Range leg_stroke_{}, cross_stroke_{};
  double cross_home_ = 0;  // length of the cross chains at home, all three alike
  Topology topology_;
};

Stewart::Stewart(const Parameters& p) : l2_(p["attachment"]) {
  leg_stroke_ = range_of(p, "leg_min", "leg_max"), cross_stroke_ = range_of(p, "cross_min", "cross_max");
  if (l2_ > p["leg_cylinder_length"]) refuse("attachment: D sits on the leg's cylinder, which ends leg_cylinder_length beyond A");
  if (!(l2_ > 0)) refuse("attachment must be more than zero: a cross chain cannot turn its leg by the foot");
  std::array<Matrix3<double>, 3> leg;  // at home
  for (const std::size_t i : {0u, 1u, 2u}) {
    const double delta = (-150.0 + 120.0 * double(i)) * deg;
    a_[i] = p["base_radius"] * Vector3d(cos(delta), sin(delta), 0);
    b_[i] = p["platform_radius"] * Vector3d(cos(delta), sin(delta), 0);
    e1_[i] = {-sin(delta), cos(delta), 0};
    const Vector3d u = (b_[i] + Vector3d(0, 0, p["home_height"]) - a_[i]).normalized();
    leg[i] = frame_xz(unit(Vector3d(e1_[i].cross(u))), u);
  }
  for (const std::size_t i : {0u, 1u, 2u}) {
    const Vector3d u = leg[i].col(2), w = a_[i] + l2_ * u - a_[(i + 1) % 3], across = u.cross(w);
    cross_home_ = w.norm();
    if (!(across.norm() > 1e-3 * w.norm())) refuse("home cannot be assembled: a cross chain has no length there, or lies along its leg");
    e1_[3 + i] = leg[i].transpose() * across.normalized();  // the Cardan joint D stands square to its leg and chain at home
  }
  topology_ = describe(p);
}

Topology Stewart::describe(const Parameters& p) const {
  Topology t;
  const double height = p["home_height"];
  t.coordinates = free_pose({0, 0, height, 0, 0, 0}, 0.15 * height, 10 * deg);
  t.platform =
      t.add(Body{"platform", 0, false, Inertia::solid_cylinder(p["platform_mass"], p["platform_thickness"], p["platform_radius"], 0)});
  const Telescope leg{"leg cylinder ",
                      "leg rod ",
                      "rho",
                      "length of leg ",
                      solid_cylinder(p, "leg_cylinder", 0, p["leg_cylinder_length"]),
                      solid_cylinder(p, "leg_rod", -p["leg_rod_length"], 0),
                      leg_stroke_};
  const Telescope cross{"cross cylinder ",
                        "cross rod ",
                        "rho",
                        "length of cross chain ",
                        solid_cylinder(p, "cross_cylinder", 0, p["cross_cylinder_length"]),
                        solid_cylinder(p, "cross_rod", -p["cross_rod_length"], 0),
                        cross_stroke_};
  const Range base = up_to(p["base_cone"]), tilt = either_way(p["platform_cone"]);
  const Vector3d upright(0, 0, p.choice("cones_from") == "normal" ? 1 : 0);
  const Range ball = up_to(p["cross_cone"]), turn = either_way(p["cross_cone"]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Leg& k = chains[i];
    const std::string n = std::to_string(k.limb);
    add_leg(t, k, n, leg, {"A" + n, JointKind::spherical, 0, k.cylinder, {base}, -1, upright},
            {"B" + n, JointKind::universal, platform, k.piston, {tilt, tilt}});
    t.draw_along_axis(k.cylinder, 0, l2_, p["leg_cylinder_radius"]);  // in two pieces that end at D, whose joint then shows
    t.draw_along_axis(k.cylinder, l2_, p["leg_cylinder_length"], p["leg_cylinder_radius"]);
    t.draw_along_axis(k.piston, -p["leg_rod_length"], 0, p["leg_rod_radius"]);
    t.add(beam("leg" + n, k.low, k.high, material_of(p, "material"), tube_of(p, "leg")));
    t.add(spring_drive("drive" + n, k.drive, p["drive_stiffness"]));
    t.shapes.push_back({0, ShapeKind::cylinder, a_[i], a_[(i + 1) % 3], p["leg_cylinder_radius"]});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Leg& k = chains[3 + i];
    const std::string n = std::to_string(i + 1);
    add_leg(t, k, std::to_string(k.limb), cross, {"C" + n, JointKind::spherical, 0, k.cylinder, {ball}},
            {"D" + n, JointKind::universal, chains[i].cylinder, k.piston, {turn, turn}});
    t.derived.push_back({"hinge_d" + n, "angle between leg " + n + " and the cross chain at D" + n, "rad"});
    t.add(beam("cross" + std::to_string(k.limb), k.low, k.high, material_of(p, "material"), tube_of(p, "cross")));
    t.add(spring_drive("drive" + std::to_string(k.limb), k.drive, p["drive_stiffness"]));
    // Drawn as two stages that overlap over most of the stroke; one that is three times as long out as in needs more of them.
    t.draw_along_axis(k.cylinder, 0, 0.5 * cross_home_, p["cross_cylinder_radius"]);
    t.draw_along_axis(k.piston, -0.7 * cross_home_, 0, p["cross_rod_radius"]);
  }
  t.matrices = constraint_matrices();
  return t;
}
}  // namespace
PMREPORT_PLUGIN(Stewart)
