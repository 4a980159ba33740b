// Five PUS limbs, driven by their sliders, and one passive UPU limb; five degrees of freedom.
// Equation numbers are those of Wang, Lyu and Liu 2021; README.md beside this file says which of its numbers reproduce and where it errs.
//
// Slider i moves along Z through A_i on a circle; its universal joint U_i holds a rod of constant length L to the ball S_i = p + R s_i.
// The UPU limb runs from U6 = (0, 0, h6) along d = p - U6 to the platform's centre. Its axes are X (base), a2 = a3 (across the leg) and
// a4 = R ex (platform); a2 is perpendicular to X and to d, so it must be along X x d, and perpendicular to a4 it takes one freedom:
//     (X x d) . R ex = 0   <=>   d_z sin(gamma) cos(beta) + d_y sin(beta) = 0,   R = Rz(gamma) Ry(beta) Rx(alpha)          (C)
// The paper takes gamma = 0 instead: `constraint = "ideal"` has three slides along X, Y, Z and a universal joint about Y and R ex for it.
#include <pmreport/elastic.hpp>
#include <pmreport/mechanism.hpp>
#include <pmreport/parts.hpp>

using namespace pmreport;
using Eigen::Vector3d;
namespace {
constexpr double pi = std::numbers::pi, deg = pi / 180;
constexpr const char *constraints[] = {"upu", "ideal"}, *platforms[] = {"improved", "pentagon", "scheme-2"}, *sides[] = {"above", "below"},
                     *origins[] = {"home", "normal"};
constexpr double platform_centre[] = {0.002, -0.001, 0.010}, platform_inertia[] = {0.0012, 0.0013, 0.0021, 1e-5, 0, -2e-5};
constexpr double azimuths[] = {18 * deg, 162 * deg, 234 * deg, 306 * deg, 90 * deg};  // of A_1 to A_5
constexpr int platform = 1, lower = 12, upper = 13;                                   // bodies of the UPU limb
constexpr int u6 = 15, p6 = 16, u6p = 17;                                             // its joints
constexpr int gantry = 12, slide = 15, ideal_u = 18;  // of the ideal constraint: first body, first joint, last joint
struct Limb {                                         // bodies and joints of limb i = 0..4
  int i, slider = 2 + 2 * i, rod = 3 + 2 * i, p = 3 * i, u = 3 * i + 1, s = 3 * i + 2;
};

class FivePusUpu : public Mechanism<5> {
 public:
  static constexpr const char* name = "5pus-upu";
  static constexpr const char* title = "5PUS-UPU: five sliders with rods and one passive UPU limb, 5 degrees of freedom";
  static constexpr const char* source = "Wang, Lyu, Liu 2021, Kinematic Analysis and Verification of a New 5-DOF Parallel Mechanism";
  static constexpr Parameter parameters[] = {
      Parameter::choice("constraint", constraints, 0, "what holds the platform's turn about Z: the UPU limb, or the paper's gamma = 0"),
      Parameter::choice("platform", platforms, 0, "places of the balls: scheme 1, the preliminary pentagon, or scheme 2"),
      Parameter::length("base_radius", 0.135, "radius R of the circle of the sliders' universal joints", {0.001, 100}),
      Parameter::length("rod_length", 0.205, "length L of the rods", {0.001, 100}),
      Parameter::length("h6", -0.300, "height of U6 over O", {-100, 100}),
      Parameter::length("pentagon_radius", 0.0618, "radius of the preliminary pentagon of balls", {0.001, 100}),
      Parameter::angle("pentagon_angle", 0, "turn of the preliminary pentagon in the platform"),
      Parameter::working_mode("slider1", sides, 0, "side of ball S1 on which slider 1 stands"),
      Parameter::working_mode("slider2", sides, 0, "side of ball S2 on which slider 2 stands"),
      Parameter::working_mode("slider3", sides, 0, "side of ball S3 on which slider 3 stands"),
      Parameter::working_mode("slider4", sides, 0, "side of ball S4 on which slider 4 stands"),
      Parameter::working_mode("slider5", sides, 0, "side of ball S5 on which slider 5 stands"),
      Parameter::length("stroke_min", 0.080, "lowest place of a slider over O", {-100, 100}),
      Parameter::length("stroke_max", 0.285, "highest place of a slider over O", {-100, 100}),
      Parameter::angle("ball_cone", 45 * deg, "largest deflection of a ball S_i", {0, pi}),
      Parameter::choice("cones_from", origins, 0, "what ball_cone counts from: home, or the platform's normal on the side of the rod"),
      Parameter::angle("rod_angle", 45 * deg, "largest rotation of the joints U1 to U5 from home, each axis", {0, pi}),
      Parameter::angle("leg_angle", 45 * deg, "largest rotation of the joints U6 and U6' from home, each axis", {0, pi}),
      Parameter::length("leg_travel", 0.120, "largest travel of P6 from home"),
      Parameter::mass("slider_mass", 0.8, "mass of a slider"),
      Parameter::mass("rod_mass", 0.12, "mass of a rod"),
      Parameter::length("rod_centre", 0.1025, "centre of mass of a rod from U_i"),
      Parameter::inertia("rod_inertia", 4.2025e-4, "transverse inertia of a rod about its centre of mass"),
      Parameter::inertia("rod_axial_inertia", 1e-6, "axial inertia of a rod"),
      Parameter::mass("platform_mass", 1, "mass of the platform"),
      Parameter::numbers("platform_centre", platform_centre, {-10, 10}, 3, 3, "m", "mm", "centre of mass of the platform, platform axes"),
      Parameter::numbers("platform_inertia", platform_inertia, {-1e6, 1e6}, 6, 6, "kg*m^2", "kg*m^2",
                         "about that centre: xx yy zz xy xz yz"),
      Parameter::mass("lower_mass", 0.5, "mass of the lower part of the UPU leg"),
      Parameter::length("lower_centre", 0.1, "its centre of mass from U6 along the leg"),
      Parameter::inertia("lower_inertia", 0.0015, "its transverse inertia about the centre of mass"),
      Parameter::inertia("lower_axial_inertia", 8e-5, "its axial inertia"),
      Parameter::mass("upper_mass", 0.4, "mass of the upper part of the UPU leg"),
      Parameter::length("upper_centre", 0.08, "its centre of mass from U6' back along the leg"),
      Parameter::inertia("upper_inertia", 0.001, "its transverse inertia about the centre of mass"),
      Parameter::inertia("upper_axial_inertia", 5e-5, "its axial inertia"),
      Parameter::choice("material", material_names, 0, "material of the rods and of the UPU leg"),
      Parameter::length("bar_diameter", 0.010, "outer diameter of a rod", {0.0001, 10}),
      Parameter::length("bar_bore", 0, "inner diameter of a rod", {0, 10}),
      Parameter::length("leg_diameter", 0.030, "outer diameter of the UPU leg as a beam", {0.0001, 10}),
      Parameter::length("leg_bore", 0.020, "inner diameter of the UPU leg as a beam", {0, 10}),
      Parameter::number("drive_stiffness", 30e6, {1, 1e15}, "N/m", "N/um", "stiffness of a slider's drive"),
  };

  explicit FivePusUpu(const Parameters& p);
  Topology topology() const { return topology_; }

  template <class T>
  void place(const Coordinates<T>& c, Placement<T>& at) const {
    const Vector3<T> position(c[0], c[1], c[2]), d = position - u6_;
    const T gamma = ideal_ ? T(0.0) : turn(d, c[4], at);
    const Matrix3<T> r = rotation_zyx(gamma, c[4], c[3]), level = Eigen::Matrix3d::Identity().cast<T>();
    at.body(platform, position, r);
    at.derived(0, gamma);
    for (const Limb limb : limbs_) {
      const auto i = static_cast<std::size_t>(limb.i);
      const Vector3<T> s = position + r * s_[i];
      const T across_x = a_[i].x() - s(0), across_y = a_[i].y() - s(1);
      const T squared = length_ * length_ - across_x * across_x - across_y * across_y;  // Eq. (11), with its sign corrected
      at.require(squared, "a rod is shorter than the distance of its ball from the slider's axis");
      const T rise = side_[i] * sqrt(squared), q = s(2) + rise;
      const Vector3<T> u(T(a_[i].x()), T(a_[i].y()), q), tangent = guide_[i].col(1).template cast<T>();
      const Vector3<T> along = Vector3<T>(-across_x, -across_y, -rise) * (1.0 / length_), second = unit<T>(tangent.cross(along));
      at.body(limb.slider, u, guide_[i].template cast<T>());
      at.body(limb.rod, u, frame_xz(second, along));
      at.joint(limb.p, u, level.col(2));
      at.joint(limb.u, u, tangent, second);
      at.joint(limb.s, s);
      at.actuator(limb.i, q);
      at.derived(1 + limb.i, rise);
    }
    if (!ideal_) return place_leg(position, d, r, at);
    Vector3<T> corner = Vector3<T>::Zero();
    for (int k = 0; k < 3; ++k) {
      corner(k) = position(k);
      at.body(gantry + k, corner, level);
      at.joint(slide + k, corner, level.col(k));
    }
    at.joint(ideal_u, position, level.col(1), r.col(0));
  }

  // Rows of Eq. (12) by twists: with n_i from S_i to U_i, n_iz q_i' = n_i . v + (r_i x n_i) . w. Below them the constraint wrench,
  // reciprocal to the freedoms of its limb. Of the UPU limb these are X, a2, the travel along d, a3 = a2 and a4: the wrench
  //     (a4 x X; a4 x (X x d)) / |X x d|
  // is a couple only where a4 is along X; elsewhere it is a force parallel to a2, through the intersection of the axes X and a4. Its
  // magnitude counts as a couple everywhere. Of the ideal constraint: the couple a4 x Y.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Vector3<T> p = at.origin(platform);
    Matrix6<T> g;
    for (const Limb limb : limbs_) {
      const Vector3<T> s = at.centre(limb.s), link = at.centre(limb.u) - s;
      force_row<T>(g, limb.i, link * T(1.0 / link(2)), s - p);
    }
    const Vector3<T> fixed = at.axis(ideal_ ? ideal_u : u6), a4 = at.axis(ideal_ ? ideal_u : u6p, 1);
    if (ideal_) return couple_row<T>(g, 5, a4.cross(fixed)), g;
    const T scale = 1.0 / length<T>(fixed.cross(Vector3<T>(p - u6_)));
    g.row(5) << (a4.cross(fixed) * scale).transpose(), a4.cross(at.axis(u6, 1)).transpose();
    return g;
  }

  // Eq. (12). A coordinate's rate moves the platform by a column of twists (v; w): v for x, y, z; w = Z gamma' + Y1 beta' + X2 alpha'. With
  // the UPU limb gamma follows from y, z and beta: (C) as sin(gamma) = -(d_y / d_z) tan(beta), differentiated.
  std::vector<Eigen::MatrixXd> matrices(const Coordinates<double>& c, const Placement<double>& at) const {
    const double gamma = at.derived(0), t = tan(c[4]), z = at.origin(platform).z() - u6_.z(), ratio = at.origin(platform).y() / z;
    Eigen::Matrix<double, 6, 5> twists = Eigen::Matrix<double, 6, 5>::Identity();
    twists.bottomRightCorner<3, 2>() << at.rotation(platform).col(0), Vector3d(-sin(gamma), cos(gamma), 0);
    if (!ideal_) twists.row(5) += Eigen::Matrix<double, 1, 5>(0, -t / z, ratio * t / z, 0, -ratio * (1 + t * t)) / cos(gamma);
    return {jacobian(at).topRows<5>() * twists};
  }

 private:
  // (C), of its two roots the one with cos(gamma) > 0: the other is the same orientation by other angles.
  template <class T>
  T turn(const Vector3<T>& d, const T& beta, Placement<T>& at) const {
    const T cosine = d(2) * cos(beta), sine = -d(1) * sin(beta);
    at.require(abs(cosine) - abs(sine) - 1e-6, "the UPU limb does not let the platform tilt that far about Y so far from its XZ plane");
    return atan2(choose(cosine < 0.0, -sine, sine), sqrt(larger<T>(cosine * cosine - sine * sine, 1e-12)));
  }
  template <class T>
  void place_leg(const Vector3<T>& p, const Vector3<T>& d, const Matrix3<T>& r, Placement<T>& at) const {
    const Vector3<T> x = Vector3d::UnitX().cast<T>(), z = unit(d), a2 = unit<T>(x.cross(d)), foot = u6_.cast<T>();
    const Matrix3<T> turned = frame_xz<T>(a2.cross(z), z);
    at.body(lower, foot, turned);
    at.body(upper, p, turned);
    at.joint(u6, foot, x, a2);
    at.joint(p6, p, z);
    at.joint(u6p, p, a2, r.col(0));
  }
  Topology describe(const Parameters& p) const;
  void draw(Topology& t, const Vector3d& floor, const Vector3d& top) const;

  static constexpr Limb limbs_[] = {{0}, {1}, {2}, {3}, {4}};
  bool ideal_ = false, pentagon_ = false, scheme_2_ = false;
  double length_;
  Range stroke_{};
  Vector3d u6_;
  std::array<Vector3d, 5> a_, s_;         // A_i in base axes, s_i in platform axes
  std::array<Eigen::Matrix3d, 5> guide_;  // axes of slider i: outward, along the circle, Z
  std::array<double, 5> side_;            // +1: slider above its ball
  Topology topology_;
};

FivePusUpu::FivePusUpu(const Parameters& p) : length_(p["rod_length"]), u6_(0, 0, p["h6"]) {
  ideal_ = p.choice("constraint") == "ideal", pentagon_ = p.choice("platform") == "pentagon",
  scheme_2_ = p.choice("platform") == "scheme-2";
  constexpr double balls[2][5][2] = {{{35, 51}, {-35, 51}, {-51, -35}, {51, -35}, {0, 51}},
                                     {{51, 35}, {-51, 35}, {-51, 0}, {51, 0}, {0, 51}}};  // [mm]
  const auto& scheme = balls[scheme_2_ ? 1 : 0];
  const Eigen::AngleAxisd turned(p["pentagon_angle"], Vector3d::UnitZ());
  for (std::size_t i = 0; i < 5; ++i) {
    guide_[i] = Eigen::AngleAxisd(azimuths[i], Vector3d::UnitZ()).toRotationMatrix();
    a_[i] = p["base_radius"] * guide_[i].col(0);
    s_[i] = pentagon_ ? p["pentagon_radius"] * (turned * guide_[i].col(0)) : 1e-3 * Vector3d(scheme[i][0], scheme[i][1], 0);
    side_[i] = p.choice("slider" + std::to_string(i + 1)) == "above" ? 1 : -1;
  }
  stroke_ = range_of(p, "stroke_min", "stroke_max");
  if (!ideal_ && abs(u6_.z()) < 0.05) refuse("h6 must be 50 mm or more from 0, the height of U6' at home; it is ", u6_.z() * 1e3, " mm");
  topology_ = describe(p);
}

Topology FivePusUpu::describe(const Parameters& p) const {
  Topology t;
  // The pentagon is singular where it is centred and level, so its home stands beside; scheme 2 has singular surfaces all around.
  const double home = pentagon_ ? 0.010 : 0, box = pentagon_ ? 0.003 : scheme_2_ ? 0.020 : 0.040;
  const double tilt = pentagon_ ? 1 * deg : scheme_2_ ? 4 * deg : 12 * deg;
  t.coordinates = {Coordinate::around(home, box, "x", "X position", "m"), Coordinate::around(home, box, "y", "Y position", "m"),
                   Coordinate::around(0, 0.050, "z", "Z position", "m"), Coordinate::around(0, tilt, "alpha", "turn about X2", "rad"),
                   Coordinate::around(0, tilt, "beta", "turn about Y1", "rad")};
  t.derived.push_back({"gamma", "turn about Z", "rad", true});
  t.constraints.push_back({"constraint1", ideal_ ? "couple across Y and the platform's x" : "constraint wrench of the UPU limb", "N*m"});
  t.matrices.push_back({"J", "slider rates by coordinate rates, Eq. (12)", 5, 5, Rates::coordinates, Rates::actuators});
  Inertia body = Inertia::central(p["platform_mass"], p.numbers("platform_inertia"));
  body.centre = Vector3d(p.numbers("platform_centre").data());
  t.platform = t.add(Body{"platform", 0, false, body});
  const Inertia rod = axisymmetric(p, "rod", p["rod_centre"]);
  const Range turns = either_way(p["rod_angle"]), leg_turns = either_way(p["leg_angle"]);
  for (const Limb limb : limbs_) {
    const std::string n = std::to_string(limb.i + 1);
    t.add(Body{"slider " + n, limb.i + 1, false, Inertia::axisymmetric(p["slider_mass"], 0, 0, 0)});
    t.add(Body{"rod " + n, limb.i + 1, false, rod});
    t.add(Joint{"P" + n, JointKind::prismatic, 0, limb.slider, {}});
    t.add(Joint{"U" + n, JointKind::universal, limb.slider, limb.rod, {turns, turns}});
    const Vector3d from_slider(0, 0, p.choice("cones_from") == "normal" ? -side_[std::size_t(limb.i)] : 0);  // as the rod's z axis runs
    t.add(Joint{"S" + n, JointKind::spherical, limb.rod, platform, {up_to(p["ball_cone"])}, -1, from_slider});
    t.add(Actuator{"q" + n, "height of slider " + n, "m", limb.p, stroke_});
    t.add(beam("rod" + n, limb.u, limb.s, material_of(p, "material"), tube_of(p, "bar")));
    t.add(spring_drive("drive" + n, limb.i, p["drive_stiffness"]));
    t.derived.push_back({"rise" + n, "height of U" + n + " over S" + n, "m"});
  }
  if (ideal_) {
    for (const char* axis : {"X", "Y", "Z"}) {
      const int at = t.add(Body{std::string("gantry ") + axis, 6, false, {}});
      t.add(Joint{std::string("P6") + axis, JointKind::prismatic, at == gantry ? 0 : at - 1, at, {}});
      t.shapes.push_back({at, ShapeKind::ball, {0, 0, 0}, {0, 0, 0}, 0.001});  // an idea, not a part: not to be seen
    }
    t.add(Joint{"U6", JointKind::universal, gantry + 2, platform, {}});
  } else {
    t.add(Body{"leg, lower part", 6, false, axisymmetric(p, "lower", p["lower_centre"])});
    t.add(Body{"leg, upper part", 6, false, axisymmetric(p, "upper", -p["upper_centre"])});
    t.add(Joint{"U6", JointKind::universal, 0, lower, {leg_turns, leg_turns}});
    t.add(Joint{"P6", JointKind::prismatic, lower, upper, {either_way(p["leg_travel"])}});
    t.add(Joint{"U6p", JointKind::universal, upper, platform, {leg_turns, leg_turns}});
    t.add(beam("leg6", u6, u6p, material_of(p, "material"), tube_of(p, "leg")));
  }
  draw(t, {0, 0, std::min(u6_.z(), stroke_.min) - 0.030}, {0, 0, std::max(u6_.z(), stroke_.max) + 0.045});
  return t;
}

// The prototype of section 5. The leg, and the pentagon of the preliminary platform, are drawn from their joints.
void FivePusUpu::draw(Topology& t, const Vector3d& floor, const Vector3d& top) const {
  constexpr ShapeKind bar = ShapeKind::cylinder;
  const double back = 0.040, post = a_[0].norm() + back, half = 0.040;
  constexpr std::size_t next[] = {4, 2, 3, 0, 1};  // by azimuth
  t.shapes.push_back({0, ShapeKind::box, floor, {post + 0.020, post + 0.020, 0.006}, 0});
  if (!ideal_) t.shapes.push_back({0, bar, u6_, u6_.z() < 0 ? floor : top, 0.009});
  if (!pentagon_) t.shapes.push_back({platform, ShapeKind::box, {0, 0, 0}, {half, half, 0.004}, 0});
  for (const Limb limb : limbs_) {
    const auto i = static_cast<std::size_t>(limb.i);
    const Vector3d screw = top + post * guide_[i].col(0), neighbour = top + post * guide_[next[i]].col(0);
    t.shapes.push_back({0, bar, screw + floor - top, screw, 0.008});
    t.shapes.push_back({0, bar, screw, u6_.z() < 0 ? neighbour : top, 0.008});
    t.shapes.push_back({limb.slider, ShapeKind::box, {back, 0, 0}, {0.016, 0.020, 0.022}, 0});
    t.shapes.push_back({limb.slider, bar, {0, 0, 0}, {back, 0, 0}, 0.007});
    t.shapes.push_back({limb.rod, bar, {0, 0, 0}, {0, 0, length_}, 0.004});
    if (!pentagon_) t.shapes.push_back({platform, bar, s_[i].cwiseMax(-half).cwiseMin(half), s_[i], 0.004});
  }
}
}  // namespace
PMREPORT_PLUGIN(FivePusUpu)
