// Gough's platform, the hexapod: six driven legs between base and platform, six degrees of freedom.
//
// Notation of Glazunov et al. 2008; README.md beside this file says what of the paper reproduces. Leg i runs from A_i on the base to
// B_i = P + R b_i on the platform, R = Rz(alpha) Rx(beta) Ry(gamma). v_i = A_iB_i, rho_i = |v_i|, u_i = v_i / rho_i.
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
constexpr double home_position[] = {0, 0, 0.95}, home_angles[] = {0, 0, 0};

constexpr int platform = 1;
constexpr auto legs = pmreport::legs<6>(platform + 1);

class Gough : public Mechanism<6> {
 public:
  static constexpr const char* name = "gough";
  static constexpr const char* title = "Gough's platform: six legs between base and platform, 6 degrees of freedom";
  static constexpr const char* source =
      "Glazunov, Briot, Arakelyan et al. 2008, Development of manipulators with a parallel-cross structure; Gough 1956";
  static constexpr Parameter parameters[] = {
      Parameter::length("base_radius", 0.3, "radius R_b of the circle of the base joints", {0.001, 100}).unless("base_points"),
      Parameter::length("platform_radius", 0.2, "radius R_pl of the circle of the platform joints, and of the platform", {0.001, 100}),
      Parameter::angle("base_half_angle", 10.6 * deg, "half the angle between the two base joints of a pair", {0, pi / 3})
          .unless("base_points"),
      Parameter::angle("platform_half_angle", 15.2 * deg, "half the angle between the two platform joints of a pair", {0, pi / 3})
          .unless("platform_points"),
      Parameter::numbers("base_points", {}, {-100, 100}, 0, 18, "m", "mm",
                         "A1 to A6 in base axes, x y z each; none: from circle and angle"),
      Parameter::numbers("platform_points", {}, {-100, 100}, 0, 18, "m", "mm", "B1 to B6 in platform axes; none: from circle and angle"),
      Parameter::numbers("home_position", home_position, {-100, 100}, 3, 3, "m", "mm", "x y z at home"),
      Parameter::numbers("home_angles", home_angles, {-pi, pi}, 3, 3, "rad", "deg", "alpha beta gamma at home"),
      Parameter::length("stroke_min", 0.76, "shortest leg"),
      Parameter::length("stroke_max", 1.41, "longest leg"),
      Parameter::angle("base_cone", 60 * deg, "largest turn of a base joint from home, about either axis", {0, pi}),
      Parameter::angle("platform_cone", 60 * deg, "largest deflection of a platform joint", {0, pi}),
      Parameter::choice("cones_from", origins, 0, "what platform_cone counts from: home, or the platform's normal on the side of the legs"),
      Parameter::mass("platform_mass", 10, "mass of the platform, a disc about P"),
      Parameter::length("platform_thickness", 0.03, "thickness of the disc"),
      Parameter::mass("cylinder_mass", 4, "mass of a leg's cylinder"),
      Parameter::length("cylinder_length", 0.76, "length of a leg's cylinder, from A_i"),
      Parameter::length("cylinder_radius", 0.03, "radius of a leg's cylinder"),
      Parameter::mass("rod_mass", 2, "mass of a leg's rod"),
      Parameter::length("rod_length", 0.7, "length of a leg's rod, back from B_i"),
      Parameter::length("rod_radius", 0.02, "radius of a leg's rod"),
      Parameter::choice("material", material_names, 0, "material of the legs"),
      Parameter::length("leg_diameter", 0.04, "outer diameter of a leg as a beam", {0.0001, 10}),
      Parameter::length("leg_bore", 0.02, "inner diameter of a leg as a beam", {0, 10}),
      Parameter::number("drive_stiffness", 50e6, {1, 1e15}, "N/m", "N/um", "stiffness of a leg's drive, in series with the leg"),
  };

  explicit Gough(const Parameters& p);
  Topology topology() const { return topology_; }

  // The first axis e1 of the Cardan joint at A_i is fixed in the base, the second, e2, in the leg: across both e1 and u_i, so that the leg
  // does not spin.
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]);
    const Matrix3<T> r = place_free(at, platform, q);
    for (std::size_t i = 0; i < 6; ++i)
      place_ups<T>(at, legs[i], {a_[i].cast<T>(), p + r * b_[i]}, e1_[i].cast<T>(),
                   "a leg points along the first axis of its Cardan joint on the base, which leaves its spin undetermined");
  }

  // rho_i' = u_i . B_i': a drive's force acts along its leg.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g;
    for (const Leg& leg : legs) force_row<T>(g, leg.drive, at.axis(leg.slide), at.centre(leg.high) - at.origin(platform));
    return g;
  }

  // The paper's matrices. Constraint equations f_i = rho_i^2 - v_i . v_i = 0, X = (x, y, z, alpha, beta, gamma):
  //     A X' + B rho' = 0,  A = df/dX = -2 v_i . dB_i/dX,  B = df/drho = 2 rho_i;    t = D X'
  std::vector<MatrixXd> matrices(const Coordinates<double>& q, const Placement<double>& at) const {
    Matrix6<double> a, b = Matrix6<double>::Zero();
    const Matrix6<double> d = twist_map(q, at.rotation(platform));
    for (const Leg& leg : legs) {
      const Vector3d v = at.centre(leg.high) - at.centre(leg.low);
      a.row(leg.drive) = -2 * v.transpose() * point_partials(d, at.centre(leg.high) - at.origin(platform));
      b(leg.drive, leg.drive) = 2 * at.actuator(leg.drive);
    }
    return {a, b, d};
  }

 private:
  Topology describe(const Parameters& p) const;

  std::array<Vector3d, 6> a_, b_, e1_;  // A_i and e1 in base axes, b_i in platform axes
  std::array<Vector3d, 6> cone_axis_;   // of the balls, platform axes; zero: as at home
  std::array<double, 6> home_{};
  Range stroke_{};
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
  stroke_ = range_of(p, "stroke_min", "stroke_max");

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
    // A platform may hang, or stand beside its base: the normal counts on the side to which the leg runs.
    cone_axis_[i] = {0, 0, p.choice("cones_from") == "home" ? 0.0 : r.col(2).dot(v) < 0 ? -1.0 : 1.0};
  }
  topology_ = describe(p);
}

Topology Gough::describe(const Parameters& p) const {
  Topology t;
  t.coordinates = free_pose(home_, 0.2 * mean_length_, 20 * deg);
  t.platform =
      t.add(Body{"platform", 0, false, Inertia::solid_cylinder(p["platform_mass"], p["platform_thickness"], p["platform_radius"], 0)});
  const double cylinder = p["cylinder_length"], rod = p["rod_length"],
               shortest = 0.95 * std::max(stroke_.min, 0.5 * mean_length_);  // a stroke from nothing draws legs all the same
  const Telescope telescope{
      "cylinder ", "rod ", "rho", "length of leg ", solid_cylinder(p, "cylinder", 0, cylinder), solid_cylinder(p, "rod", -rod, 0), stroke_};
  const Range turn = either_way(p["base_cone"]), cone = up_to(p["platform_cone"]);
  for (const Leg& leg : legs) {
    const std::string n = std::to_string(leg.limb);
    add_leg(t, leg, n, telescope, {"A" + n, JointKind::universal, 0, leg.cylinder, {turn, turn}},
            {"B" + n, JointKind::spherical, leg.piston, platform, {cone}, -1, cone_axis_[std::size_t(leg.drive)]});
    t.add(beam("leg" + n, leg.low, leg.high, material_of(p, "material"), tube_of(p, "leg")));
    t.add(spring_drive("drive" + n, leg.drive, p["drive_stiffness"]));
    t.draw_along_axis(leg.cylinder, 0, std::min(cylinder, shortest), p["cylinder_radius"]);
    t.draw_along_axis(leg.piston, -std::min(rod, shortest), 0, p["rod_radius"]);
  }
  t.matrices = constraint_matrices();
  return t;
}
}  // namespace
PMREPORT_PLUGIN(Gough)
