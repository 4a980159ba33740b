// Two RPU limbs on one driven carriage and an RPS limb on a driven slider, five degrees of freedom, two constraints too many.
//
// Equation numbers are those of Ren and Zhang 2025; README.md beside this file says what of the paper reproduces and where it errs.
//
// Limb i runs from A_i on its slide to C_i = o + e_i on the platform. The carriage takes A_2 and A_3 along X, the slider takes A_1 along Y:
//     A_1 = (0, l_y, 0)    A_2,3 = (l_x, +-L/2, 0)    e_1 = R (sigma h, 0, 0)    e_2,3 = +-R (0, e/2, 0)    R = Rx(alpha) Ry(beta)
// Each limb turns about one axis, Y or X, and stays in the plane across it: limb 1 in Y = l_y, limbs 2 and 3 in X = l_x. Hence (Eq. 4)
//     l_x = x    l_y = y + sigma h sin(alpha) sin(beta)    l_i = |C_i - A_i|
#include <pmreport/elastic.hpp>
#include <pmreport/leg.hpp>
#include <pmreport/mechanism.hpp>
#include <pmreport/parts.hpp>

using namespace pmreport;
using Eigen::Vector3d;
namespace {
constexpr double deg = std::numbers::pi / 180, half_turn = std::numbers::pi;
constexpr const char *sides[] = {"-1", "+1"}, *origins[] = {"home", "normal"}, *bendings[] = {"full", "couples"};
constexpr double platform_inertia[] = {0.12, 0.06, 0.17, 0, 0, 0};

constexpr int platform = 1, carriage = 2, slider = 3;
constexpr int px = 0, py = 1;  // joints
constexpr auto limbs = legs<3>(slider + 1, py + 1, 2);

class P2PrpuPrps : public Mechanism<5> {
 public:
  static constexpr const char* name = "p2prpu-prps";
  static constexpr const char* title = "P(2PRPU)/PRPS: three limbs on two driven slides, 5 degrees of freedom";
  static constexpr const char* source = "Ren, Zhang 2025, Kinematics and stiffness analysis of a novel 5-DOF parallel mechanism";
  static constexpr Parameter parameters[] = {
      Parameter::length("gauge", 1.2, "distance L of A2 and A3, which are L/2 either side of X", {0.001, 100}),
      Parameter::length("platform_width", 0.4, "distance e of C2 and C3", {0.001, 100}),
      Parameter::length("platform_arm", 0.24, "distance h of C1 from o, the middle of C2 C3", {0.001, 100}),
      Parameter::choice("sigma", sides, 0, "side of C1: -1 towards the rail of limb 1, +1 away from it"),
      Parameter::length("home_x", 0.8, "X of o at home", {0.001, 100}),
      Parameter::length("home_height", 1.15, "Z of o at home", {0.001, 100}),
      Parameter::length("limb_min", 0.99, "shortest limb, Eq. 16", {0.001, 100}),
      Parameter::length("limb_max", 1.49, "longest limb, Eq. 16", {0.001, 100}),
      Parameter::length("lx_min", 0.6, "least travel of the carriage, Eq. 16", {-100, 100}),
      Parameter::length("lx_max", 1.6, "largest travel of the carriage, Eq. 16", {-100, 100}),
      Parameter::length("ly_max", 0.7, "largest travel of the slider either way, Eq. 16", {0.001, 100}),
      Parameter::angle("limb_angle", 60 * deg, "largest angle of a limb against Z, Eq. 17", {0, half_turn}),
      Parameter::angle("ball_angle", 30 * deg, "largest angle of limb 1 against the platform's normal, Eq. 18", {0, half_turn}),
      Parameter::choice("cones_from", origins, 0,
                        "what the ball S1 counts from: home, with a cone that holds that of Eq. 18, or the normal, exactly"),
      Parameter::angle("universal_angle", 30 * deg, "largest angle of a universal joint about either axis, after Eq. 19", {0, half_turn}),
      Parameter::mass("platform_mass", 15, "mass of the platform"),
      Parameter::length("platform_centre", 0.08, "centre of mass of the platform from o towards C1", {-100, 100}),
      Parameter::numbers("platform_inertia", platform_inertia, {-1e6, 1e6}, 6, 6, "kg*m^2", "kg*m^2",
                         "about its centre: xx yy zz xy xz yz"),
      Parameter::mass("carriage_mass", 30, "mass of the carriage, with the slides of limbs 2 and 3"),
      Parameter::mass("slider_mass", 12, "mass of the slider of limb 1"),
      Parameter::mass("lower_mass", 8, "mass of a limb's lower part"),
      Parameter::length("lower_centre", 0.30, "centre of mass of a lower part from A_i"),
      Parameter::inertia("lower_inertia", 0.25, "transverse inertia of a lower part about its centre of mass"),
      Parameter::inertia("lower_axial_inertia", 0.01, "axial inertia of a lower part"),
      Parameter::mass("upper_mass", 4, "mass of a limb's upper part"),
      Parameter::length("upper_centre", 0.35, "centre of mass of an upper part from C_i"),
      Parameter::inertia("upper_inertia", 0.15, "transverse inertia of an upper part about its centre of mass"),
      Parameter::inertia("upper_axial_inertia", 0.003, "axial inertia of an upper part"),
      Parameter::number("young_modulus", 2.1e11, {1, 1e15}, "Pa", "GPa", "E of limbs and rails, section 4.1"),
      Parameter::number("shear_modulus", 8e10, {1, 1e15}, "Pa", "GPa", "G of limbs and rails, section 4.1"),
      Parameter::length("limb_diameter", 0.03, "diameter of a limb as a beam, section 4.1", {0.0001, 10}),
      Parameter::length("rail_x_diameter", 0.03, "diameter of the screws along X, section 4.1", {0.0001, 10}),
      Parameter::length("rail_y_diameter", 0.03, "diameter of the screw along Y, section 4.1", {0.0001, 10}),
      Parameter::length("rail_offset", 0, "of a screw beyond its travel, from its fixed end to zero", {0, 100}),
      Parameter::choice("limb_bending", bendings, 0, "full, or by couples alone, as Eqs. 22 to 35 have it"),
  };

  explicit P2PrpuPrps(const Parameters& p);
  Topology topology() const { return topology_; }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const auto& [x, y, z, alpha, beta] = q;
    const T ca = cos(alpha), sa = sin(alpha), cb = cos(beta), sb = sin(beta);
    Matrix3<T> r;  // Eq. (2)
    r << cb, T(0.0), sb, sa * sb, ca, -(sa * cb), -(ca * sb), sa, ca * cb;
    const Vector3<T> o(x, y, z), e2 = e2_ * r.col(1);
    const Vector3<T> c[] = {o + e1_ * r.col(0), o + e2, o - e2};
    const T &lx = x, &ly = c[0](1);

    const Matrix3<T> level = Matrix3<T>::Identity();
    const Vector3<T> x_axis = level.col(0), y_axis = level.col(1);
    const Vector3<T> a[] = {{T(0.0), ly, T(0.0)}, {lx, T(gauge_ / 2), T(0.0)}, {lx, T(-gauge_ / 2), T(0.0)}};
    at.body(platform, o, r);
    at.body(carriage, Vector3<T>(lx, T(0.0), T(0.0)), level);
    at.body(slider, a[0], level);
    at.joint(px, Vector3<T>(lx, T(0.0), T(0.0)), x_axis);
    at.joint(py, a[0], y_axis);
    at.actuator(0, lx);
    at.actuator(1, ly);

    for (std::size_t i = 0; i < 3; ++i) {
      const Line<T> line(a[i], c[i]);
      place_leg<T>(at, limbs[i], line, i == 0 ? Vector3<T>(y_axis.cross(line.n)) : x_axis);
      at.joint(limbs[i].low, a[i], i == 0 ? y_axis : x_axis);
      if (i == 0)
        at.joint(limbs[i].high, c[i]);
      else
        at.joint(limbs[i].high, c[i], x_axis, r.col(1));
    }
  }

  // Eq. (14), and below it the couple that limbs 2 and 3 apply: across both axes of their universal joints, hence along n = X x y_m, in the
  // plane of Y and Z. Along the platform's normal, as the paper has it, it would do work as the platform turns about X with beta not zero.
  // The line of the force along X may pass through any point of C2 C3: those differ by multiples of the couple. It is taken through o.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Vector3<T> o = at.origin(platform), x_axis = at.axis(px);
    Matrix6<T> g;
    force_row<T>(g, 0, x_axis, Vector3<T>::Zero());
    force_row<T>(g, 1, at.axis(py), at.centre(limbs[0].high) - o);
    for (const Leg& limb : limbs) force_row<T>(g, limb.drive, at.axis(limb.slide), at.centre(limb.high) - o);
    couple_row<T>(g, 5, x_axis.cross(at.axis(limbs[1].high, 1)));
    return g;
  }

  // J_m of Eq. (14), whose first line passes through C2, and J_D = J_m J_B of Eq. (15) multiplied out, J_B by Eqs. (5) and (6).
  std::vector<Eigen::MatrixXd> matrices(const Coordinates<double>& q, const Placement<double>& at) const {
    const double ca = cos(q[3]), sa = sin(q[3]), cb = cos(q[4]), sb = sin(q[4]);
    Matrix6<double> jm = jacobian(at);
    force_row<double>(jm, 0, at.axis(px), at.centre(limbs[1].high) - at.origin(platform));
    const Vector3d d1 = at.axis(limbs[0].slide), d2 = at.axis(limbs[1].slide), d3 = at.axis(limbs[2].slide);
    Eigen::MatrixXd jd(5, 5);
    jd << 1, 0, 0, 0, 0,                                                                     //
        0, 1, 0, e1_ * ca * sb, e1_ * sa * cb,                                               //
        d1.x(), 0, d1.z(), e1_ * sa * sb * d1.z(), -e1_ * (sb * d1.x() + ca * cb * d1.z()),  //
        0, d2.y(), d2.z(), e2_ * (ca * d2.z() - sa * d2.y()), 0,                             //
        0, d3.y(), d3.z(), -e2_ * (ca * d3.z() - sa * d3.y()), 0;
    return {jm.topRows<5>(), jd};
  }

  // Transmission index of limb i, Eq. (20): mu_i = |delta_i . v_Ci| / |v_Ci|, the cosine of its pressure angle, v_Ci the velocity of C_i.
  // The paper does not say which actuators move; taken is limb i alone, the other four locked, a column of the inverse of G. That choice
  // has the symmetries that the paper describes; all actuators moving at once has not. Of the limbs the least, Eq. (21), stands for the
  // mechanism.
  std::vector<double> readings(const Coordinates<double>&, const Placement<double>& at) const {
    const Matrix6<double> twists = jacobian(at).inverse();
    const Vector3d o = at.origin(platform), normal = at.rotation(platform).col(2);
    std::vector<double> mu, tilt;
    for (const Leg& limb : limbs) {
      const auto twist = twists.col(limb.drive);
      const Vector3d delta = at.axis(limb.slide), v = twist.head<3>() + twist.tail<3>().cross(at.centre(limb.high) - o);
      mu.push_back(abs(delta.dot(v)) / v.norm());
      tilt.push_back(atan2(delta.cross(normal).norm(), delta.dot(normal)));  // Eqs. (18), (19)
    }
    return {mu[0], mu[1], mu[2], std::ranges::min(mu), tilt[0], tilt[1], tilt[2]};
  }

 private:
  Topology describe(const Parameters& p) const;
  void draw(Topology& t, const Parameters& p) const;

  double gauge_, e1_, e2_;  // L, sigma h, e/2
  Range limb_, travel_;     // strokes
  Topology topology_;
};

P2PrpuPrps::P2PrpuPrps(const Parameters& p)
    : gauge_(p["gauge"]),
      e1_(p["platform_arm"] * (p.choice("sigma") == "-1" ? -1 : 1)),
      e2_(p["platform_width"] / 2),
      limb_(range_of(p, "limb_min", "limb_max")),
      travel_(range_of(p, "lx_min", "lx_max")) {
  topology_ = describe(p);
}

Topology P2PrpuPrps::describe(const Parameters& p) const {
  Topology t;
  const double x = p["home_x"], z = p["home_height"], size = 0.1 * z;
  t.coordinates = {Coordinate::around(x, size, "x", "X position", "m"), Coordinate::around(0, size, "y", "Y position", "m"),
                   Coordinate::around(z, size, "z", "Z position", "m"), Coordinate::around(0, 8 * deg, "alpha", "turn about X", "rad"),
                   Coordinate::around(0, 8 * deg, "beta", "turn about Y1", "rad")};
  Inertia of_platform = Inertia::central(p["platform_mass"], p.numbers("platform_inertia"));
  of_platform.centre.x() = p["platform_centre"] * (e1_ < 0 ? -1 : 1);
  t.platform = t.add(Body{"platform", 0, false, of_platform});
  t.add(Body{"carriage", 0, false, {p["carriage_mass"]}});  // of no limb: limbs 2 and 3 both stand on it
  t.add(Body{"slider", 1, false, {p["slider_mass"]}});
  t.add(Joint{"PX", JointKind::prismatic, 0, carriage, {}});
  t.add(Joint{"PY", JointKind::prismatic, 0, slider, {}});
  t.add(Actuator{"lx", "travel of the carriage", "m", px, travel_});
  t.add(Actuator{"ly", "travel of the slider", "m", py, either_way(p["ly_max"])});

  const Telescope telescope{
      "lower ", "upper ", "l", "length of limb ", axisymmetric(p, "lower", p["lower_centre"]), axisymmetric(p, "upper", -p["upper_centre"]),
      limb_};
  // The paper's angles count from Z and from the platform's normal, a joint's from home, where the limb stands `home` off both. Counted
  // from home, the cone of S1 is wider by that and holds the paper's; counted from the normal it is the paper's. S1_tilt is the angle that
  // the paper limits, either way.
  const bool exact = p.choice("cones_from") == "normal";
  const Vector3d from(0, 0, exact ? 1 : 0);
  const double across[] = {x + e1_, gauge_ / 2 - e2_, e2_ - gauge_ / 2};
  for (std::size_t i = 0; i < 3; ++i) {
    const Leg& limb = limbs[i];
    const std::string n = std::to_string(limb.limb);
    const double home = atan2(across[i], z), reach = p["limb_angle"], bend = p["universal_angle"];
    const Joint ball{"S" + n, JointKind::spherical, limb.piston, platform, {up_to(p["ball_angle"] + (exact ? 0 : abs(home)))}, -1, from},
        cardan{"U" + n, JointKind::universal, limb.piston, platform, {{-bend + home, bend + home}, either_way(bend)}};
    add_leg(t, limb, n, telescope,
            {"R" + n + "1", JointKind::revolute, i == 0 ? slider : carriage, limb.cylinder, {{-reach - home, reach - home}}},
            i == 0 ? ball : cardan);
  }
  // Eq. 22: what limb 1 passes along Y, limbs 2 and 3 along X, stretches their screws.
  const Material made_of{p["young_modulus"], p["shear_modulus"], steel.expansion};
  for (const Leg& limb : limbs) {
    const std::string n = std::to_string(limb.limb);
    Element& bar = t.elements[std::size_t(t.add(beam("limb" + n, limb.low, limb.high, made_of, solid(p["limb_diameter"]))))];
    bar.bends = p.choice("limb_bending") == "full" ? Bending::full : Bending::couples;
    const CrossSection screw = solid(p[limb.limb == 1 ? "rail_y_diameter" : "rail_x_diameter"]);
    t.add(rail("rail" + n, limb.limb == 1 ? py : px, limb.low, made_of, screw, p["rail_offset"]));
  }
  for (const char* n : {"1", "2", "3"}) t.readings.push_back({std::string("mu") + n, std::string("transmission index of limb ") + n, ""});
  t.readings.push_back({"mu", "transmission index, the least of the limbs'", ""});
  for (const char* joint : {"S1", "U2", "U3"})
    t.readings.push_back({std::string(joint) + "_tilt", std::string("limb ") + joint[1] + " against the platform's normal", "rad"});
  t.constraints.push_back({"constraint1", "couple of limbs 2 and 3 along n = X x y_m", "N*m"});
  t.matrices = {{"J_m", "actuator rates from the twist, Eq. 14", 5, 6, Rates::twist, Rates::actuators, 0},
                {"J_D", "actuator rates from the coordinates' rates, Eq. 15", 5, 5, Rates::coordinates, Rates::actuators, 1}};
  draw(t, p);
  return t;
}

void P2PrpuPrps::draw(Topology& t, const Parameters& p) const {
  const double s = p["home_height"], end = std::min(p["lx_max"], 2 * p["home_x"]) + 0.08 * s, side = gauge_ / 2;
  const double reach = std::min(p["ly_max"], gauge_) + 0.08 * s, tube = 0.95 * limb_.min, z = -0.05 * s;
  const auto bar = [&](int body, Vector3d a, Vector3d b) { t.shapes.push_back({body, ShapeKind::cylinder, a, b, 0.018 * s}); };
  const auto block = [&](int body, double y) { t.shapes.push_back({body, ShapeKind::box, {0, y, z}, Vector3d(0.05, 0.05, 0.032) * s}); };
  for (const double y : {-side, side}) {
    bar(0, {0, y, z}, {end, y, z});
    t.shapes.push_back({0, ShapeKind::ball, {end, y, z}, Vector3d::Zero(), 0.018 * s});
    block(carriage, y);
  }
  bar(0, {0, -reach, z}, {0, reach, z});
  bar(0, {end, -side, z}, {end, side, z});
  bar(carriage, {0, -side, z}, {0, side, z});
  block(slider, 0);
  for (const Leg& limb : limbs) draw_leg(t, limb, tube, 0.024 * s, 0.014 * s);
}
}  // namespace
PMREPORT_PLUGIN(P2PrpuPrps)
