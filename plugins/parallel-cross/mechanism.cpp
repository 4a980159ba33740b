// The parallel-cross mechanisms of Glazunov et al. 2008: three legs between base and platform, three cross chains from leg to leg.
//
// Notation of the paper; README.md beside this file says what of it reproduces and where it errs. Leg i runs from A_i on the base to
// B_i = P + R b_i on the platform, R = Rz(alpha) Rx(beta) Ry(gamma). v_i = A_iB_i, rho_i = |v_i|, u_i = v_i / rho_i. Cross chain i runs
// from C_i = A_i + l1 u_i on leg i to D_j = A_j + l2 u_j on leg j, the next one; w_i = C_iD_j, rho_{3+i} = |w_i|, f_i = w_i / rho_{3+i}.
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
constexpr const char* variants[] = {"inner", "outer"};

constexpr int platform = 1;
constexpr auto chains = legs<6>(platform + 1);  // legs 0..2, cross chains 3..5, each from a ball to a Cardan joint

class ParallelCross : public Mechanism<6> {
 public:
  static constexpr const char* name = "parallel-cross";
  static constexpr const char* title = "Parallel-cross mechanism: three legs and three cross chains between them, 6 degrees of freedom";
  static constexpr const char* source =
      "Glazunov, Briot, Arakelyan et al. 2008, Development of manipulators with a parallel-cross structure";
  static constexpr Parameter parameters[] = {
      Parameter::choice("variant", variants, 0, "cross drives above the base (l1 = 150, l2 = 650 mm) or below (-300, -750 mm)"),
      Parameter::numbers("attachments", {}, {-100, 100}, 0, 2, "m", "mm", "l1 and l2, from A_i to C_i and D_i; none: those of the variant"),
      Parameter::length("base_radius", 0.3, "radius R_b of the circle of A1 to A3", {0.001, 100}),
      Parameter::length("platform_radius", 0.2, "radius R_pl of the circle of B1 to B3, and of the platform", {0.001, 100}),
      Parameter::length("home_height", 0.95, "height of P above O at home", {0.001, 100}),
      Parameter::length("leg_min", 0.76, "shortest leg"),
      Parameter::length("leg_max", 1.41, "longest leg"),
      Parameter::length("cross_min", 0.3, "shortest cross chain"),
      Parameter::length("cross_max", 0.95, "longest cross chain"),
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
      Parameter::length("cross_rod_length", 0.3, "length of a cross chain's rod, back from D_j"),
      Parameter::length("cross_rod_radius", 0.015, "radius of a cross chain's rod"),
      Parameter::choice("material", material_names, 0, "material of legs and cross chains"),
      Parameter::length("leg_diameter", 0.04, "outer diameter of a leg as a beam", {0.0001, 10}),
      Parameter::length("leg_bore", 0.02, "inner diameter of a leg as a beam", {0, 10}),
      Parameter::length("cross_diameter", 0.03, "outer diameter of a cross chain as a beam", {0.0001, 10}),
      Parameter::length("cross_bore", 0.015, "inner diameter of a cross chain as a beam", {0, 10}),
      Parameter::number("drive_stiffness", 50e6, {1, 1e15}, "N/m", "N/um", "stiffness of every drive, in series with its leg or chain"),
  };

  explicit ParallelCross(const Parameters& p);
  Topology topology() const { return topology_; }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]);
    const Matrix3<T> r = place_free(at, platform, q);
    std::array<Matrix3<T>, 3> leg;  // the legs' body frames; u_i is their third column
    for (const std::size_t i : {0u, 1u, 2u}) leg[i] = chain<T>(at, i, {a_[i].cast<T>(), p + r * b_[i]}, r * e1_[i]);
    for (const std::size_t i : {0u, 1u, 2u}) {
      const std::size_t j = (i + 1) % 3;
      const Vector3<T> ui = leg[i].col(2), uj = leg[j].col(2);
      const Vector3<T> f = chain<T>(at, 3 + i, {ui * l1_ + a_[i], uj * l2_ + a_[j]}, leg[j] * e1_[3 + i]).col(2);
      at.derived(int(2 * i), acos(T(ui.dot(f))));
      at.derived(int(2 * i + 1), acos(T(uj.dot(f))));
    }
  }

  // A drive's force moves the platform through the legs. C_i = A_i + l1 u_i is carried along by B_i: u_i' = (I - u_i u_i^T) B_i' / rho_i.
  //     rho_i' = u_i . B_i',   rho_{3+i}' = f_i . (D_j' - C_i') = F_j . B_j' - F_i . B_i',
  //     F_j = (l2 / rho_j) (I - u_j u_j^T) f_i,   F_i = (l1 / rho_i) (I - u_i u_i^T) f_i
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g;
    const auto arm = [&](const Leg& leg) { return Vector3<T>(at.centre(leg.high) - at.origin(platform)); };
    for (std::size_t k = 0; k < 3; ++k) {
      const Leg &i = chains[k], &j = chains[(k + 1) % 3], &cross = chains[3 + k];
      force_row<T>(g, i.drive, at.axis(i.slide), arm(i));
      const Vector3<T> f = at.axis(cross.slide), ui = at.axis(i.slide), uj = at.axis(j.slide);
      const Vector3<T> fi = (f - ui * ui.dot(f)) * T(l1_ / at.actuator(i.drive)), fj = (f - uj * uj.dot(f)) * T(l2_ / at.actuator(j.drive));
      const Vector3<T> moment = arm(j).cross(fj) - arm(i).cross(fi);
      for (int c = 0; c < 3; ++c) g(cross.drive, c) = fj(c) - fi(c), g(cross.drive, c + 3) = moment(c);
    }
    return g;
  }

  // The paper's matrices. Constraint equations, X = (x, y, z, alpha, beta, gamma):
  //     f_i = rho_i^2 - v_i . v_i = 0,   f_{3+i} = rho_{3+i}^2 - w_i . w_i = 0,   w_i = A_iA_j + (l2 / rho_j) v_j - (l1 / rho_i) v_i
  //     A X' + B rho' = 0,  A = df/dX,  B = df/drho;   t = D X'
  std::vector<MatrixXd> matrices(const Coordinates<double>& q, const Placement<double>& at) const {
    Matrix6<double> a, b = Matrix6<double>::Zero();
    const Matrix6<double> d = twist_map(q, at.rotation(platform));
    const auto partials = [&](const Leg& leg) { return point_partials(d, at.centre(leg.high) - at.origin(platform)); };  // dB_i/dX
    const auto span = [&](const Leg& chain) { return Vector3d(at.centre(chain.high) - at.centre(chain.low)); };          // v_i, w_i
    for (std::size_t k = 0; k < 3; ++k) {
      const Leg &leg_i = chains[k], &leg_j = chains[(k + 1) % 3], &cross = chains[3 + k];
      const int i = leg_i.drive, j = leg_j.drive, c = cross.drive;
      const double rho_i = at.actuator(i), rho_j = at.actuator(j);
      const Vector3d w = span(cross);
      a.row(i) = -2 * span(leg_i).transpose() * partials(leg_i);
      a.row(c) = -2 * w.transpose() * (l2_ / rho_j * partials(leg_j) - l1_ / rho_i * partials(leg_i));
      b(i, i) = 2 * rho_i;
      b(c, c) = 2 * at.actuator(c);
      b(c, i) = -2 * l1_ / (rho_i * rho_i) * w.dot(span(leg_i));
      b(c, j) = 2 * l2_ / (rho_j * rho_j) * w.dot(span(leg_j));
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
  std::array<Vector3d, 6> e1_;     // first Cardan axes: of B_i in platform axes, of D_j in the body axes of leg j
  double l1_ = 0, l2_ = 0;
  Range leg_stroke_{}, cross_stroke_{};
  double cross_home_ = 0;  // length of the cross chains at home, all three alike
  Topology topology_;
};

ParallelCross::ParallelCross(const Parameters& p) {
  const bool inner = p.choice("variant") == "inner";
  const auto given = p.numbers("attachments");
  if (given.size() == 1) refuse("attachments: expected l1 and l2, or none; seen one number");
  l1_ = !given.empty() ? given[0] : inner ? 0.15 : -0.30;
  l2_ = !given.empty() ? given[1] : inner ? 0.65 : -0.75;
  if (std::max(l1_, l2_) > p["leg_cylinder_length"])
    refuse("attachments: C and D sit on the leg's cylinder, which ends leg_cylinder_length beyond A");
  if (l1_ == 0 && l2_ == 0) refuse("attachments: l1 and l2 are both zero, and a cross chain between feet of legs moves nothing");
  leg_stroke_ = range_of(p, "leg_min", "leg_max"), cross_stroke_ = range_of(p, "cross_min", "cross_max");

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
    const std::size_t j = (i + 1) % 3;
    const Vector3d w = a_[j] + l2_ * leg[j].col(2) - a_[i] - l1_ * leg[i].col(2), across = leg[j].col(2).cross(w);
    cross_home_ = w.norm();
    if (!(across.norm() > 1e-3 * w.norm())) refuse("home cannot be assembled: a cross chain has no length there, or lies along its leg");
    e1_[3 + i] = leg[j].transpose() * across.normalized();  // the Cardan joint D stands square to its leg and chain at home
  }
  topology_ = describe(p);
}

Topology ParallelCross::describe(const Parameters& p) const {
  Topology t;
  const double height = p["home_height"];
  t.coordinates = free_pose({0, 0, height, 0, 0, 0}, 0.15 * height, 10 * deg);
  t.coordinates[3].box = {-15 * deg, 5 * deg};  // turned the other way a singular surface is near: 9.7 degrees with the outer drives
  t.platform =
      t.add(Body{"platform", 0, false, Inertia::solid_cylinder(p["platform_mass"], p["platform_thickness"], p["platform_radius"], 0)});
  const double bottom = std::min({0.0, l1_, l2_});
  const Telescope leg{"leg cylinder ",
                      "leg rod ",
                      "rho",
                      "length of leg ",
                      solid_cylinder(p, "leg_cylinder", bottom, p["leg_cylinder_length"]),
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
  std::array cuts{bottom, l1_, l2_, p["leg_cylinder_length"]};  // drawn in pieces that end at C and D: their joints then show
  std::ranges::sort(cuts);
  for (std::size_t i = 0; i < 3; ++i) {
    const Leg& k = chains[i];
    const std::string n = std::to_string(k.limb);
    add_leg(t, k, n, leg, {"A" + n, JointKind::spherical, 0, k.cylinder, {base}, -1, upright},
            {"B" + n, JointKind::universal, platform, k.piston, {tilt, tilt}});
    for (std::size_t c = 0; c < 3; ++c)
      if (cuts[c] < cuts[c + 1]) t.draw_along_axis(k.cylinder, cuts[c], cuts[c + 1], p["leg_cylinder_radius"]);
    t.draw_along_axis(k.piston, -p["leg_rod_length"], 0, p["leg_rod_radius"]);
    t.add(beam("leg" + n, k.low, k.high, material_of(p, "material"), tube_of(p, "leg")));
    t.add(spring_drive("drive" + n, k.drive, p["drive_stiffness"]));
    t.shapes.push_back({0, ShapeKind::cylinder, a_[i], a_[(i + 1) % 3], p["leg_cylinder_radius"]});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Leg &k = chains[3 + i], &carries_c = chains[i], &carries_d = chains[(i + 1) % 3];
    const std::string n = std::to_string(carries_c.limb), m = std::to_string(carries_d.limb);
    add_leg(t, k, std::to_string(k.limb), cross, {"C" + n, JointKind::spherical, carries_c.cylinder, k.cylinder, {ball}},
            {"D" + m, JointKind::universal, carries_d.cylinder, k.piston, {turn, turn}});
    t.derived.push_back({"hinge_c" + n, "angle between leg " + n + " and the cross chain at C" + n, "rad"});
    t.derived.push_back({"hinge_d" + m, "angle between leg " + m + " and the cross chain at D" + m, "rad"});
    t.add(beam("cross" + std::to_string(k.limb), k.low, k.high, material_of(p, "material"), tube_of(p, "cross")));
    t.add(spring_drive("drive" + std::to_string(k.limb), k.drive, p["drive_stiffness"]));
    // Drawn as two stages that overlap over most of the stroke; one that is three times as long out as in needs more of them.
    t.draw_along_axis(k.cylinder, 0, 0.5 * cross_home_, p["cross_cylinder_radius"]);
    t.draw_along_axis(k.piston, -0.7 * cross_home_, 0, p["cross_rod_radius"]);
  }
  // What a leg has below its joint A carries the chains that hang there, out to the lower one.
  if (std::min(l1_, l2_) < 0)
    for (std::size_t i = 0; i < 3; ++i) {
      const int c = chains[3 + i].low, d = chains[3 + (i + 2) % 3].high;
      t.add(beam("stub" + std::to_string(i + 1), chains[i].low, l2_ < l1_ ? d : c, material_of(p, "material"), tube_of(p, "leg"), 2));
    }
  t.matrices = constraint_matrices();
  return t;
}
}  // namespace
PMREPORT_PLUGIN(ParallelCross)
