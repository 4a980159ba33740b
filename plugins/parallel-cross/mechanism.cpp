// The parallel-cross mechanisms of Glazunov et al. 2008: three legs between base and platform, three cross chains from leg to leg.
//
// Notation of the paper; README.md beside this file says what of it reproduces and where it errs. Leg i runs from A_i on the base to
// B_i = P + R b_i on the platform, R = Rz(alpha) Rx(beta) Ry(gamma). v_i = A_iB_i, rho_i = |v_i|, u_i = v_i / rho_i. Cross chain i runs
// from C_i = A_i + l1 u_i on leg i to D_j = A_j + l2 u_j on leg j, the next one; w_i = C_iD_j, rho_{3+i} = |w_i|, f_i = w_i / rho_{3+i}.
#include <pmreport/mechanism.hpp>

using namespace pmreport;
using Eigen::MatrixXd;
using Eigen::Vector3d;
namespace {
constexpr double pi = std::numbers::pi, deg = pi / 180;
constexpr const char* pose_names[] = {"x", "y", "z", "alpha", "beta", "gamma"};
constexpr const char* pose_titles[] = {"X position", "Y position", "Z position", "turn about z0", "turn about x1", "turn about y2"};
constexpr const char* variants[] = {"inner", "outer"};

constexpr int platform = 1;
struct Chain {  // bodies and joints of chain i: legs 0..2, cross chains 3..5
  int i, cylinder = 2 + 2 * i, rod = 3 + 2 * i, lower = 3 * i, slide = 3 * i + 1, upper = 3 * i + 2;
};

// Body frame of a chain along u: x along the second axis of its Cardan joint, across the first and the chain; z along the chain.
template <class T>
Matrix3<T> cardan_frame(const Vector3<T>& e1, const Vector3<T>& u) {
  return frame_xz(unit(Vector3<T>(e1.cross(u))), u);
}

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
      Parameter::angle("base_cone", 60 * deg, "largest deflection of a base joint A from home", {0, pi}),
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
  };

  explicit ParallelCross(const Parameters& p);
  Topology topology() const { return topology_; }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]);
    const Matrix3<T> r = rotation_zxy(q[3], q[4], q[5]);
    at.body(platform, p, r);
    std::array<Matrix3<T>, 3> leg;  // the legs' body frames; u_i is their third column
    for (const std::size_t i : {0u, 1u, 2u}) leg[i] = chain<T>(at, int(i), a_[i].cast<T>(), p + r * b_[i], r * e1_[i]);
    for (const std::size_t i : {0u, 1u, 2u}) {
      const std::size_t j = (i + 1) % 3;
      const Vector3<T> ui = leg[i].col(2), uj = leg[j].col(2);
      const Vector3<T> f = chain<T>(at, int(3 + i), ui * l1_ + a_[i], uj * l2_ + a_[j], leg[j] * e1_[3 + i]).col(2);
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
    const auto arm = [&](int i) { return Vector3<T>(at.centre(Chain{i}.upper) - at.origin(platform)); };
    for (int i = 0; i < 3; ++i) {
      force_row<T>(g, i, at.axis(Chain{i}.slide), arm(i));
      const int j = (i + 1) % 3;
      const Vector3<T> f = at.axis(Chain{3 + i}.slide), ui = at.axis(Chain{i}.slide), uj = at.axis(Chain{j}.slide);
      const Vector3<T> fi = (f - ui * ui.dot(f)) * T(l1_ / at.actuator(i)), fj = (f - uj * uj.dot(f)) * T(l2_ / at.actuator(j));
      const Vector3<T> moment = arm(j).cross(fj) - arm(i).cross(fi);
      for (int k = 0; k < 3; ++k) g(3 + i, k) = fj(k) - fi(k), g(3 + i, k + 3) = moment(k);
    }
    return g;
  }

  // The paper's matrices. Constraint equations, X = (x, y, z, alpha, beta, gamma):
  //     f_i = rho_i^2 - v_i . v_i = 0,   f_{3+i} = rho_{3+i}^2 - w_i . w_i = 0,   w_i = A_iA_j + (l2 / rho_j) v_j - (l1 / rho_i) v_i
  //     A X' + B rho' = 0,  A = df/dX,  B = df/drho;   t = D X',  D = (I, 0; 0, L)
  // with the axes of the three turns, z0, x1, y2, for columns of L: dB_i/dX = (I, z0 x R b_i, x1 x R b_i, y2 x R b_i).
  std::vector<MatrixXd> matrices(const Coordinates<double>& q, const Placement<double>& at) const {
    Matrix6<double> a, b = Matrix6<double>::Zero(), d = Matrix6<double>::Identity();
    d.bottomRightCorner<3, 3>() << Vector3d::UnitZ(), Vector3d(cos(q[3]), sin(q[3]), 0), at.rotation(platform).col(1);
    const auto partials = [&](int i) {  // dB_i/dX
      Eigen::Matrix<double, 3, 6> e = d.topRows<3>();
      for (int k = 3; k < 6; ++k) e.col(k) = d.col(k).tail<3>().cross(at.centre(Chain{i}.upper) - at.origin(platform));
      return e;
    };
    const auto span = [&](int i) { return Vector3d(at.centre(Chain{i}.upper) - at.centre(Chain{i}.lower)); };  // v_i, w_i
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, c = 3 + i;
      const double rho_i = at.actuator(i), rho_j = at.actuator(j);
      const Vector3d w = span(c);
      a.row(i) = -2 * span(i).transpose() * partials(i);
      a.row(c) = -2 * w.transpose() * (l2_ / rho_j * partials(j) - l1_ / rho_i * partials(i));
      b(i, i) = 2 * rho_i;
      b(c, c) = 2 * at.actuator(c);
      b(c, i) = -2 * l1_ / (rho_i * rho_i) * w.dot(span(i));
      b(c, j) = 2 * l2_ / (rho_j * rho_j) * w.dot(span(j));
    }
    return {a, b, d};
  }

 private:
  // A chain from its ball joint to its Cardan joint, whose first axis is e1: without spin, since the second lies across e1. Its body frame.
  template <class T>
  static Matrix3<T> chain(Placement<T>& at, const int i, const Vector3<T>& from, const Vector3<T>& to, const Vector3<T>& e1) {
    const Chain k{i};
    const Vector3<T> span = to - from;
    const T rho = length(span);
    const Vector3<T> u = span * T(1.0 / rho);
    at.require(length(Vector3<T>(e1.cross(u))) - 1e-6,
               "a chain points along the first axis of its Cardan joint, and its spin is undetermined");
    const Matrix3<T> frame = cardan_frame(e1, u);
    at.body(k.cylinder, from, frame);
    at.body(k.rod, to, frame);
    at.joint(k.lower, from);
    at.joint(k.slide, to, u);
    at.joint(k.upper, to, e1, frame.col(0));
    at.actuator(i, rho);
    return frame;
  }
  Topology describe(const Parameters& p) const;

  std::array<Vector3d, 3> a_, b_;  // A_i in base axes, b_i in platform axes
  std::array<Vector3d, 6> e1_;     // first Cardan axes: of B_i in platform axes, of D_j in the body axes of leg j
  double l1_ = 0, l2_ = 0;
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
  for (const std::string kind : {"leg", "cross"})
    if (p[kind + "_min"] >= p[kind + "_max"]) refuse(kind, "_min must be less than ", kind, "_max");

  std::array<Matrix3<double>, 3> leg;  // at home
  for (const std::size_t i : {0u, 1u, 2u}) {
    const double delta = (-150.0 + 120.0 * double(i)) * deg;
    a_[i] = p["base_radius"] * Vector3d(cos(delta), sin(delta), 0);
    b_[i] = p["platform_radius"] * Vector3d(cos(delta), sin(delta), 0);
    e1_[i] = {-sin(delta), cos(delta), 0};
    leg[i] = cardan_frame<double>(e1_[i], (b_[i] + Vector3d(0, 0, p["home_height"]) - a_[i]).normalized());
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
  for (std::size_t k = 0; k < 6; ++k)
    t.coordinates.push_back(
        Coordinate::around(k == 2 ? height : 0, k < 3 ? 0.15 * height : 10 * deg, pose_names[k], pose_titles[k], k < 3 ? "m" : "rad"));
  t.coordinates[3].box = {-15 * deg, 5 * deg};  // turned the other way a singular surface is near: 9.7 degrees with the outer drives
  t.platform =
      t.add(Body{"platform", 0, false, Inertia::solid_cylinder(p["platform_mass"], p["platform_thickness"], p["platform_radius"], 0)});
  const auto add_chain = [&](const std::string& kind, const Chain k, const Joint& lower, const Joint& upper, double bottom) {
    const std::string n = std::to_string(k.i + 1);
    const double top = p[kind + "_cylinder_length"], rod = p[kind + "_rod_length"];
    t.add(Body{kind + " cylinder " + n, k.i + 1, false,
               Inertia::solid_cylinder(p[kind + "_cylinder_mass"], top - bottom, p[kind + "_cylinder_radius"], (bottom + top) / 2)});
    t.add(Body{kind + " rod " + n, k.i + 1, false, Inertia::solid_cylinder(p[kind + "_rod_mass"], rod, p[kind + "_rod_radius"], -rod / 2)});
    t.add(lower);
    t.add(Joint{"P" + n, JointKind::prismatic, k.cylinder, k.rod, {}});
    t.add(upper);
    t.add(Actuator{
        "rho" + n, "length of " + (kind == "leg" ? kind : "cross chain") + " " + n, "m", k.slide, {p[kind + "_min"], p[kind + "_max"]}});
  };
  const Range base{0, p["base_cone"]}, tilt{-p["platform_cone"], p["platform_cone"]}, ball{0, p["cross_cone"]}, turn{-ball.max, ball.max};
  const double bottom = std::min({0.0, l1_, l2_});
  std::array cuts{bottom, l1_, l2_, p["leg_cylinder_length"]};  // drawn in pieces that end at C and D: their joints then show
  std::ranges::sort(cuts);
  for (int i = 0; i < 3; ++i) {
    const Chain k{i};
    const std::string n = std::to_string(i + 1);
    add_chain("leg", k, Joint{"A" + n, JointKind::spherical, 0, k.cylinder, {base}},
              Joint{"B" + n, JointKind::universal, platform, k.rod, {tilt, tilt}}, bottom);
    for (std::size_t c = 0; c < 3; ++c)
      if (cuts[c] < cuts[c + 1]) t.draw_along_axis(k.cylinder, cuts[c], cuts[c + 1], p["leg_cylinder_radius"]);
    t.draw_along_axis(k.rod, -p["leg_rod_length"], 0, p["leg_rod_radius"]);
    t.shapes.push_back({0, ShapeKind::cylinder, a_[std::size_t(i)], a_[std::size_t((i + 1) % 3)], p["leg_cylinder_radius"]});
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Chain k{3 + i}, carries_c{i}, carries_d{j};
    const std::string n = std::to_string(i + 1), m = std::to_string(j + 1);
    add_chain("cross", k, Joint{"C" + n, JointKind::spherical, carries_c.cylinder, k.cylinder, {ball}},
              Joint{"D" + m, JointKind::universal, carries_d.cylinder, k.rod, {turn, turn}}, 0);
    t.derived.push_back({"hinge_c" + n, "angle between leg " + n + " and the cross chain at C" + n, "rad"});
    t.derived.push_back({"hinge_d" + m, "angle between leg " + m + " and the cross chain at D" + m, "rad"});
    // Drawn as two stages that overlap over most of the stroke; one that is three times as long out as in needs more of them.
    t.draw_along_axis(k.cylinder, 0, 0.5 * cross_home_, p["cross_cylinder_radius"]);
    t.draw_along_axis(k.rod, -0.7 * cross_home_, 0, p["cross_rod_radius"]);
  }
  t.matrices = {{"A", "constraint equations by the pose", 6, 6, Rates::coordinates, Rates::none, 0},
                {"B", "constraint equations by the drives", 6, 6, Rates::actuators, Rates::none, 0},
                {"D", "twist from the rates of the pose", 6, 6, Rates::coordinates, Rates::twist, 1}};
  return t;
}
}  // namespace
PMREPORT_PLUGIN(ParallelCross)
