// Gough's platform, the hexapod: six driven legs between base and platform, six degrees of freedom.
//
// Notation of Glazunov et al. 2008; README.md beside this file says what of the paper reproduces. Leg i runs from A_i on the base to
// B_i = P + R b_i on the platform, R = Rz(alpha) Rx(beta) Ry(gamma). v_i = A_iB_i, rho_i = |v_i|, u_i = v_i / rho_i.
#include <pmreport/mechanism.hpp>

using namespace pmreport;
using Eigen::MatrixXd;
using Eigen::Vector3d;
namespace {
constexpr double pi = std::numbers::pi, deg = pi / 180;
constexpr double home_position[] = {0, 0, 0.95}, home_angles[] = {0, 0, 0};
constexpr const char* pose_names[] = {"x", "y", "z", "alpha", "beta", "gamma"};
constexpr const char* pose_titles[] = {"X position", "Y position", "Z position", "turn about z0", "turn about x1", "turn about y2"};

constexpr int platform = 1;
struct Leg {  // bodies and joints of leg i = 0..5
  int i, cylinder = 2 + 2 * i, rod = 3 + 2 * i, a = 3 * i, p = 3 * i + 1, b = 3 * i + 2;
};

class Gough : public Mechanism<6> {
 public:
  static constexpr const char* name = "gough";
  static constexpr const char* title = "Gough's platform: six legs between base and platform, 6 degrees of freedom";
  static constexpr const char* source =
      "Glazunov, Briot, Arakelyan et al. 2008, Development of manipulators with a parallel-cross structure; Gough 1956";
  static constexpr Parameter parameters[] = {
      Parameter::length("base_radius", 0.3, "radius R_b of the circle of the base joints", {0.001, 100}),
      Parameter::length("platform_radius", 0.2, "radius R_pl of the circle of the platform joints, and of the platform", {0.001, 100}),
      Parameter::angle("base_half_angle", 10.6 * deg, "half the angle between the two base joints of a pair", {0, pi / 3}),
      Parameter::angle("platform_half_angle", 15.2 * deg, "half the angle between the two platform joints of a pair", {0, pi / 3}),
      Parameter::numbers("base_points", {}, {-100, 100}, 0, 18, "m", "mm",
                         "A1 to A6 in base axes, x y z each; none: from circle and angle"),
      Parameter::numbers("platform_points", {}, {-100, 100}, 0, 18, "m", "mm", "B1 to B6 in platform axes; none: from circle and angle"),
      Parameter::numbers("home_position", home_position, {-100, 100}, 3, 3, "m", "mm", "x y z at home"),
      Parameter::numbers("home_angles", home_angles, {-pi, pi}, 3, 3, "rad", "deg", "alpha beta gamma at home"),
      Parameter::length("stroke_min", 0.76, "shortest leg"),
      Parameter::length("stroke_max", 1.41, "longest leg"),
      Parameter::angle("base_cone", 60 * deg, "largest turn of a base joint from home, about either axis", {0, pi}),
      Parameter::angle("platform_cone", 60 * deg, "largest deflection of a platform joint from home", {0, pi}),
      Parameter::mass("platform_mass", 10, "mass of the platform, a disc about P"),
      Parameter::length("platform_thickness", 0.03, "thickness of the disc"),
      Parameter::mass("cylinder_mass", 4, "mass of a leg's cylinder"),
      Parameter::length("cylinder_length", 0.76, "length of a leg's cylinder, from A_i"),
      Parameter::length("cylinder_radius", 0.03, "radius of a leg's cylinder"),
      Parameter::mass("rod_mass", 2, "mass of a leg's rod"),
      Parameter::length("rod_length", 0.7, "length of a leg's rod, back from B_i"),
      Parameter::length("rod_radius", 0.02, "radius of a leg's rod"),
  };

  explicit Gough(const Parameters& p);
  Topology topology() const { return topology_; }

  // The first axis e1 of the Cardan joint at A_i is fixed in the base, the second, e2, in the leg: across both e1 and u_i, so that the leg
  // does not spin.
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]);
    const Matrix3<T> r = rotation_zxy(q[3], q[4], q[5]);
    at.body(platform, p, r);
    for (const Leg leg : legs_) {
      const auto i = std::size_t(leg.i);
      const Vector3<T> a = a_[i].cast<T>(), e1 = e1_[i].cast<T>(), b = p + r * b_[i], v = b - a;
      const T rho = length(v);
      const Vector3<T> u = v * T(1.0 / rho), across = e1.cross(u);
      const T sine = length(across);
      at.require(sine - 1e-6, "a leg points along the first axis of its Cardan joint on the base, which leaves its spin undetermined");
      const Vector3<T> e2 = across * T(1.0 / sine);
      const Matrix3<T> frame = frame_xz(e2, u);
      at.body(leg.cylinder, a, frame);
      at.body(leg.rod, b, frame);
      at.joint(leg.a, a, e1, e2);
      at.joint(leg.p, b, u);
      at.joint(leg.b, b);
      at.actuator(leg.i, rho);
    }
  }

  // rho_i' = u_i . B_i': a drive's force acts along its leg.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g;
    for (const Leg leg : legs_) force_row<T>(g, leg.i, at.axis(leg.p), at.centre(leg.b) - at.origin(platform));
    return g;
  }

  // The paper's matrices. Constraint equations f_i = rho_i^2 - v_i . v_i = 0, X = (x, y, z, alpha, beta, gamma):
  //     A X' + B rho' = 0,  A = df/dX = -2 v_i . dB_i/dX,  B = df/drho = 2 rho_i;    t = D X',  D = (I, 0; 0, L)
  // The columns of L are the axes of the three turns, z0, x1, y2, about which B_i moves: dB_i/dalpha = z0 x R b_i and so on.
  std::vector<MatrixXd> matrices(const Coordinates<double>& q, const Placement<double>& at) const {
    Matrix6<double> a, b = Matrix6<double>::Zero(), d = Matrix6<double>::Identity();
    d.bottomRightCorner<3, 3>() << Vector3d::UnitZ(), Vector3d(cos(q[3]), sin(q[3]), 0), at.rotation(platform).col(1);
    for (const Leg leg : legs_) {
      const Vector3d v = at.centre(leg.b) - at.centre(leg.a), arm = at.centre(leg.b) - at.origin(platform);
      for (int k = 0; k < 3; ++k) {
        a(leg.i, k) = -2 * v(k);
        a(leg.i, k + 3) = -2 * v.dot(d.col(k + 3).tail<3>().cross(arm));
      }
      b(leg.i, leg.i) = 2 * at.actuator(leg.i);
    }
    return {a, b, d};
  }

 private:
  Topology describe(const Parameters& p) const;

  static constexpr Leg legs_[] = {{0}, {1}, {2}, {3}, {4}, {5}};

  std::array<Vector3d, 6> a_, b_, e1_;  // A_i and e1 in base axes, b_i in platform axes
  std::array<double, 6> home_{};
  double mean_length_ = 0;  // of the legs at home
  Topology topology_;
};

// The six points of one side: as listed, or in three pairs around the azimuths of `vertex`, half an angle to either side.
std::array<Vector3d, 6> points(const Parameters& p, const char* list, double radius, const std::array<double, 6>& azimuth) {
  const auto given = p.numbers(list);
  if (!given.empty() && given.size() != 18)
    refuse(list, ": expected 18 numbers, x y z of six points, or none; seen ", std::to_string(given.size()));
  std::array<Vector3d, 6> out;
  for (std::size_t i = 0; i < 6; ++i)
    out[i] = given.empty() ? Vector3d(radius * cos(azimuth[i]), radius * sin(azimuth[i]), 0) : Vector3d(given.data() + 3 * i);
  return out;
}

// Base pairs stand about the vertices -150, -30 and 90 degrees; the legs of a pair part towards the two neighbouring platform pairs, which
// stand 60 degrees to either side.
Gough::Gough(const Parameters& p) {
  std::array<double, 6> azimuth_a{}, azimuth_b{};
  for (std::size_t i = 0; i < 6; ++i) {
    const double vertex = (-150.0 + 120.0 * double(i / 2)) * deg, side = i % 2 == 0 ? -1 : 1;
    azimuth_a[i] = vertex + side * p["base_half_angle"];
    azimuth_b[i] = vertex + side * (pi / 3 - p["platform_half_angle"]);
  }
  a_ = points(p, "base_points", p["base_radius"], azimuth_a);
  b_ = points(p, "platform_points", p["platform_radius"], azimuth_b);
  if (p["stroke_min"] >= p["stroke_max"]) refuse("stroke_min must be less than stroke_max");

  std::ranges::copy(p.numbers("home_position"), home_.begin());
  std::ranges::copy(p.numbers("home_angles"), home_.begin() + 3);
  const Vector3d centre(home_.data());
  const Matrix3<double> r = rotation_zxy(home_[3], home_[4], home_[5]);
  for (std::size_t i = 0; i < 6; ++i) {
    const Vector3d radial(a_[i].x(), a_[i].y(), 0), v = centre + r * b_[i] - a_[i];
    e1_[i] = radial.norm() > 1e-9 ? Vector3d(-radial.y(), radial.x(), 0).normalized() : Vector3d::UnitX();
    if (!(e1_[i].cross(v).norm() > 1e-3 * v.norm()))
      refuse("home cannot be assembled: leg ", std::to_string(i + 1),
             " has no length there, or points along the first axis of its Cardan joint; move it with home_position or home_angles");
    mean_length_ += v.norm() / 6;
  }
  topology_ = describe(p);
}

Topology Gough::describe(const Parameters& p) const {
  Topology t;
  for (std::size_t k = 0; k < 6; ++k)
    t.coordinates.push_back(
        Coordinate::around(home_[k], k < 3 ? 0.2 * mean_length_ : 20 * deg, pose_names[k], pose_titles[k], k < 3 ? "m" : "rad"));
  const double cylinder = p["cylinder_length"], rod = p["rod_length"];
  t.platform =
      t.add(Body{"platform", 0, false, Inertia::solid_cylinder(p["platform_mass"], p["platform_thickness"], p["platform_radius"], 0)});
  for (const Leg leg : legs_) {
    const std::string n = std::to_string(leg.i + 1);
    const Range turn{-p["base_cone"], p["base_cone"]};
    t.add(
        Body{"cylinder " + n, leg.i + 1, false, Inertia::solid_cylinder(p["cylinder_mass"], cylinder, p["cylinder_radius"], cylinder / 2)});
    t.add(Body{"rod " + n, leg.i + 1, false, Inertia::solid_cylinder(p["rod_mass"], rod, p["rod_radius"], -rod / 2)});
    t.add(Joint{"A" + n, JointKind::universal, 0, leg.cylinder, {turn, turn}});
    t.add(Joint{"P" + n, JointKind::prismatic, leg.cylinder, leg.rod, {}});
    t.add(Joint{"B" + n, JointKind::spherical, leg.rod, platform, {{0, p["platform_cone"]}}});
    t.add(Actuator{"rho" + n, "length of leg " + n, "m", leg.p, {p["stroke_min"], p["stroke_max"]}});
    t.draw_along_axis(leg.cylinder, 0, std::min(cylinder, 0.95 * p["stroke_min"]), p["cylinder_radius"]);
    t.draw_along_axis(leg.rod, -std::min(rod, 0.95 * p["stroke_min"]), 0, p["rod_radius"]);
  }
  t.matrices = {{"A", "constraint equations by the pose", 6, 6, Rates::coordinates, Rates::none, 0},
                {"B", "constraint equations by the drives", 6, 6, Rates::actuators, Rates::none, 0},
                {"D", "twist from the rates of the pose", 6, 6, Rates::coordinates, Rates::twist, 1}};
  return t;
}
}  // namespace
PMREPORT_PLUGIN(Gough)
