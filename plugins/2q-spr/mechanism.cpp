// Two planar limbs Q1, Q2 and one SPR limb, five degrees of freedom.
//
// Equation numbers are those of Zhang et al. 2016; README.md beside this file says where the paper errs and what of it reproduces.
//
// Platform and base are regular triangles with vertices b_i = p + R b_i and B_i. A planar limb Q_i stands in a plane through its base hinge
// R_i1, the line B_i n_i. Lower beam, two driven rods and upper beam close a loop of hinges along the plane's normal N_i inside it; the
// vertical rod's hinges R_i5 (about the upper beam mu_i) and R_i4 (about the platform's normal n_z) let the plane and the platform go their
// own ways. Such a limb drives two freedoms and takes none. The SPR limb stays perpendicular to its hinge f3 = R u3, which takes one:
//     f3 . (B_3 - b_3) = 0   <=>   f3 . (p - B_3) + u3 . b_3 = 0          (C)
#include <pmreport/elastic.hpp>
#include <pmreport/leg.hpp>
#include <pmreport/mechanism.hpp>
#include <pmreport/parts.hpp>

using namespace pmreport;
using Eigen::Vector3d;
namespace {
constexpr double pi = std::numbers::pi, deg = pi / 180;
constexpr const char* rod_words[] = {"uncrossed", "crossed"};
constexpr double tangential_axis[] = {0, 0, 0}, platform_inertia[] = {0.002, 0.002, 0.002, 0, 0, 0};

constexpr int platform = 1;
constexpr Leg spr{3, 4, 16, 17, 18, 19, 20};
struct Planar {  // bodies and joints of limb Q_i, i = 0, 1, and its rods j = 0, 1
  int i, lower = 2 + 7 * i, upper = 7 + 7 * i, vertical = 8 + 7 * i, r1 = 9 * i, r5 = 9 * i + 7, r4 = 9 * i + 8;
  constexpr Leg rod(int j) const {
    return {i + 1, 2 * i + j, lower + 1 + 2 * j, lower + 2 + 2 * j, r1 + 1 + 3 * j, r1 + 2 + 3 * j, r1 + 3 + 3 * j};
  }
};
constexpr Planar planar[] = {{0}, {1}};
constexpr double end_sign[] = {1, -1};  // of the beams' ends j = 0, 1 along n_i and mu_i

class TwoQSpr : public Mechanism<5> {
 public:
  static constexpr const char* name = "2q-spr";
  static constexpr const char* title = "2Q-SPR: two planar limbs and one SPR limb, 5 degrees of freedom";
  static constexpr const char* source =
      "Zhang, Lu, Liang, Geng 2016, Dynamics analysis of a novel limited-DOF parallel manipulator with two planar limbs";
  static constexpr Parameter parameters[] = {
      Parameter::length("base_side", 0.240, "side L of the base triangle B1 B2 B3", {0.001, 100}),
      Parameter::length("platform_side", 0.120, "side l of the platform triangle b1 b2 b3", {0.001, 100}),
      Parameter::length("lower_beam", 0.040, "half length D of a lower beam, B_i to B_ij", {0.0001, 100}),
      Parameter::length("upper_beam", 0.0125, "half length d of an upper beam, b_i to b_ij", {0.0001, 100}),
      Parameter::length("home_height", 0.300, "height Z0 of p above O at home", {0.001, 100}),
      Parameter::numbers("revolute_axis", tangential_axis, {-1, 1}, 3, 3, "", "", "axis u3 of R3, platform axes; 0 0 0: along b2 b1"),
      Parameter::working_mode("rods_1", rod_words, 0, "rods of limb Q1: the end of the upper beam that each rod drives"),
      Parameter::working_mode("rods_2", rod_words, 0, "rods of limb Q2, likewise"),
      Parameter::length("stroke_min", 0.230, "shortest rod", {0.001, 100}),
      Parameter::length("stroke_max", 0.430, "longest rod", {0.001, 100}),
      Parameter::angle("plane_tilt", 45 * deg, "largest turn of a limb's plane (R_i1) from home", {0, pi}),
      Parameter::angle("pin_angle", 60 * deg, "largest turn of a rod against a beam (R_Bij, R_bij) from home", {0, pi}),
      Parameter::angle("swivel_angle", 45 * deg, "largest turn of a vertical rod's hinges (R_i4, R_i5) from home", {0, pi}),
      Parameter::angle("ball_cone", 45 * deg, "largest deflection of the ball S3 from home", {0, pi}),
      Parameter::angle("revolute_angle", 60 * deg, "largest turn of the hinge R3 from home", {0, pi}),
      Parameter::mass("platform_mass", 10, "mass m_o of the platform, centre of mass at p"),
      Parameter::numbers("platform_inertia", platform_inertia, {-1e6, 1e6}, 6, 6, "kg*m^2", "kg*m^2", "about p: xx yy zz xy xz yz"),
      Parameter::mass("cylinder_mass", 5, "mass m_q of a cylinder"),
      Parameter::length("cylinder_centre", 0.1, "centre of mass of a cylinder from B_ij or B_3, l_q"),
      Parameter::inertia("cylinder_inertia", 0.001, "transverse inertia of a cylinder about its centre of mass"),
      Parameter::inertia("cylinder_axial_inertia", 0.001, "axial inertia of a cylinder"),
      Parameter::mass("piston_mass", 5, "mass m_p of a piston"),
      Parameter::length("piston_centre", 0.1, "centre of mass of a piston from b_ij or b_3, l_p"),
      Parameter::inertia("piston_inertia", 0.001, "transverse inertia of a piston about its centre of mass"),
      Parameter::inertia("piston_axial_inertia", 0.001, "axial inertia of a piston"),
      Parameter::mass("lower_beam_mass", 3, "mass m_G of a lower beam, centre of mass at B_i"),
      Parameter::inertia("lower_beam_inertia", 0.0005, "transverse inertia of a lower beam"),
      Parameter::inertia("lower_beam_axial_inertia", 0.0005, "axial inertia of a lower beam"),
      Parameter::mass("upper_beam_mass", 3, "mass m_g of an upper beam, centre of mass at b_i"),
      Parameter::inertia("upper_beam_inertia", 0.0005, "transverse inertia of an upper beam"),
      Parameter::inertia("upper_beam_axial_inertia", 0.0005, "axial inertia of an upper beam"),
      Parameter::choice("material", material_names, 0, "material of rods and beams"),
      Parameter::length("rod_diameter", 0.030, "outer diameter of a driven rod as a beam", {0.0001, 10}),
      Parameter::length("rod_bore", 0.015, "inner diameter of a driven rod as a beam", {0, 10}),
      Parameter::length("beam_width", 0.025, "side of the square section of lower and upper beams", {0.0001, 10}),
      Parameter::number("drive_stiffness", 50e6, {1, 1e15}, "N/m", "N/um", "stiffness of a rod's drive, in series with the rod"),
  };

  explicit TwoQSpr(const Parameters& p);
  Topology topology() const { return topology_; }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const auto& [x, z, yaw, pitch, roll] = q;
    const Matrix3<T> r = rotation_zyx(yaw, pitch, roll);
    const Vector3<T> f3 = r * u3_, nz = r.col(2);
    at.require(abs(f3.y()) - 0.05, "the axis of R3 is almost perpendicular to y, which it no longer determines");
    const T y = (f3.dot(base_[2]) - offset_ - f3.x() * x - f3.z() * z) / f3.y();  // (C)
    const Vector3<T> p(x, y, z);
    at.body(platform, p, r);

    at.derived(0, y);
    for (const Planar limb : planar) place_planar<T>(limb, p + r * platform_[std::size_t(limb.i)], nz, at);

    const Vector3<T> low = base_[2].cast<T>(), high = p + r * platform_[2];
    place_rod<T>(spr, low, high, f3, at);
    at.joint(spr.low, low);
  }

  // Eq. (2), R = Rz(alpha) Ry(beta) Rz(gamma). At home, beta = 0, only alpha + gamma is defined: no rates, hence readings.
  std::vector<double> readings(const Coordinates<double>&, const Placement<double>& at) const {
    const Matrix3<double> r = at.rotation(platform);
    const double tilt = hypot(r(0, 2), r(1, 2)), undefined = std::numeric_limits<double>::quiet_NaN();
    if (tilt < 1e-9) return {undefined, 0, undefined};
    return {atan2(r(1, 2), r(0, 2)), atan2(tilt, r(2, 2)), atan2(r(2, 1), -r(2, 0))};
  }

  // Statics of a planar limb. Rod ij pushes the upper beam with delta at b_ij: with delta at b_i, and a couple of size
  //     lever = +-d mu x delta . N
  // about N. R_i5 and R_i4 pass on to the platform no couple but one along w = n_z x mu, so the platform gets k w with k = lever / (N . w).
  // What k w has beside N, the loop carries across its plane down to R_i1, which holds all but the part about n: a force f N at b_i
  // balances that, k n . w + f n . (r_i x N) = 0. The rod thus applies (delta + f N) at b_i and the couple k w. Read as a row, the same
  // wrench gives the rod's rate, Eqs. (12) and (13), for which the paper leaves J_wbi open. The SPR limb pushes along itself, Eq. (14), and
  // holds b_3 along f3; its force acts through B_3, where the ball cannot give way, Eq. (16).
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Vector3<T> p = at.origin(platform);
    Matrix6<T> g;
    for (const Planar limb : planar) {
      const Vector3d& n = hinge_[std::size_t(limb.i)];
      const Vector3<T> b = at.centre(limb.r4), r = b - base_[std::size_t(limb.i)], mu = at.axis(limb.r5);
      const Vector3<T> normal = at.axis(limb.rod(0).low), w = at.axis(limb.r4).cross(mu);
      for (int j = 0; j < 2; ++j) {
        const Vector3<T> delta = at.axis(limb.rod(j).slide);
        const T lever = end_sign[j] * upper_ * mu.cross(delta).dot(normal), k = lever / normal.dot(w);
        const T f = -k * w.dot(n) / r.cross(normal).dot(n);
        force_row<T>(g, 2 * limb.i + j, delta + normal * f, b - p);
        for (int c = 0; c < 3; ++c) g(2 * limb.i + j, 3 + c) += k * w(c);
      }
    }
    force_row<T>(g, 4, at.axis(spr.slide), at.centre(spr.high) - p);
    force_row<T>(g, 5, at.axis(spr.high), at.centre(spr.low) - p);
    return g;
  }

 private:
  // Limb Q_i from its platform point b and the platform's normal n_z. Eq. (6): N = n x r / |n x r| and mu = +-n_z x N / |n_z x N|, the
  // direction in the limb's plane that is across n_z; both signs assemble. Eq. (7), its last lines: r_ij = r_i +- (d mu - D n).
  template <class T>
  void place_planar(const Planar& limb, const Vector3<T>& b, const Vector3<T>& nz, Placement<T>& at) const {
    const auto i = std::size_t(limb.i);
    const Vector3<T> foot = base_[i].cast<T>(), n = hinge_[i].cast<T>(), r = b - foot, across = n.cross(r);
    const T height = length(across);
    at.require(height - 0.02 * lower_, "a platform joint is almost on the base hinge of its planar limb, whose plane it leaves open");
    const Vector3<T> normal = across * T(1.0 / height), along = nz.cross(normal);
    const T sine = length(along);
    at.require(sine - 0.05, "the platform is almost parallel to the plane of a planar limb, whose upper beam it leaves free");
    const Vector3<T> mu = along * T(mode_[i] / sine);

    at.body(limb.lower, foot, frame_xz(normal, n));
    at.body(limb.upper, b, frame_xz(normal, mu));
    at.body(limb.vertical, b, frame_xz(mu, nz));
    at.joint(limb.r1, foot, n);
    at.joint(limb.r5, b, mu);
    at.joint(limb.r4, b, nz);
    for (int j = 0; j < 2; ++j) {
      const Vector3<T> low = foot + n * (end_sign[j] * lower_), high = b + mu * (end_sign[j] * upper_);
      place_rod<T>(limb.rod(j), low, high, normal, at);
      at.joint(limb.rod(j).low, low, normal);
    }
  }

  // A driven rod from `low` to `high`, Eq. (8). Its upper hinge lies along `x`, which it is perpendicular to. (By place_leg partial
  // derivatives of this mechanism cost a seventh more.)
  template <class T>
  void place_rod(const Leg& rod, const Vector3<T>& low, const Vector3<T>& high, const Vector3<T>& x, Placement<T>& at) const {
    const Vector3<T> along = high - low;
    const T l = length(along);
    const Vector3<T> delta = along * T(1.0 / l);
    const Matrix3<T> turned = frame_xz(x, delta);
    at.body(rod.cylinder, low, turned);
    at.body(rod.piston, high, turned);
    at.joint(rod.slide, high, delta);
    at.joint(rod.high, high, x);
    at.actuator(rod.drive, l);
  }

  Topology describe(const Parameters& p) const;

  std::array<Vector3d, 3> base_, platform_;  // B_i in base axes, b_i in platform axes
  std::array<Vector3d, 2> hinge_;            // n_i
  Vector3d u3_;                              // axis of R3, platform axes
  double offset_, lower_, upper_;            // u3 . b_3, D, d
  std::array<double, 2> mode_;               // sign of mu_i
  Range stroke_{};
  Topology topology_;
};

TwoQSpr::TwoQSpr(const Parameters& p) : lower_(p["lower_beam"]), upper_(p["upper_beam"]) {
  constexpr double azimuth[] = {-30 * deg, 90 * deg, 210 * deg};
  for (std::size_t i = 0; i < 3; ++i) {  // Eq. (1)
    const Vector3d vertex = Vector3d(cos(azimuth[i]), sin(azimuth[i]), 0) / sqrt(3.0);
    base_[i] = p["base_side"] * vertex;
    platform_[i] = p["platform_side"] * vertex;
  }
  for (std::size_t i = 0; i < 2; ++i) mode_[i] = p.choice(i == 0 ? "rods_1" : "rods_2") == "crossed" ? -1 : 1;
  hinge_ = {(base_[1] - base_[2]).normalized(), (base_[0] - base_[2]).normalized()};  // Eq. (5): along the opposite side
  stroke_ = range_of(p, "stroke_min", "stroke_max");

  const Vector3d limb3 = platform_[2] + Vector3d(0, 0, p["home_height"]) - base_[2];
  u3_ = Vector3d(p.numbers("revolute_axis").data());
  if (u3_.isZero()) u3_ = platform_[0] - platform_[1];
  u3_.normalize();
  if (!(abs(u3_.dot(limb3)) < 1e-6 * limb3.norm()))
    refuse("home cannot be assembled: revolute_axis must be perpendicular to the SPR limb there, (", limb3.x(), ", ", limb3.y(), ", ",
           limb3.z(), ")");
  if (abs(u3_.y()) < 0.1) refuse("revolute_axis must not be perpendicular to y, the dependent coordinate");
  offset_ = u3_.dot(platform_[2]);
  topology_ = describe(p);
}

Topology TwoQSpr::describe(const Parameters& p) const {
  Topology t;
  const double height = p["home_height"], thick = 0.013 * height, tube = 0.95 * stroke_.min;  // no part longer than the shortest rod
  t.coordinates = {
      Coordinate::around(0, 0.1 * height, "x", "X position", "m"), Coordinate::around(height, height / 6, "z", "Z position", "m"),
      Coordinate::around(0, 10 * deg, "yaw", "turn about Z", "rad"), Coordinate::around(0, 10 * deg, "pitch", "turn about Y1", "rad"),
      Coordinate::around(0, 10 * deg, "roll", "turn about X2", "rad")};
  t.derived = {{"y", "Y position", "m", true}};
  t.readings = {{"alpha", "ZYZ angle alpha", "rad"}, {"beta", "ZYZ angle beta, the tilt", "rad"}, {"gamma", "ZYZ angle gamma", "rad"}};

  const auto within = [&p](const char* angle) { return std::vector<Range>{either_way(p[angle])}; };
  const Telescope telescope{"cylinder ",
                            "piston ",
                            "r",
                            "length of rod ",
                            axisymmetric(p, "cylinder", p["cylinder_centre"]),
                            axisymmetric(p, "piston", -p["piston_centre"]),
                            stroke_};
  const auto add_rod = [&](const Leg& rod, const std::string& n, const Joint& low, const Joint& high) {
    add_leg(t, rod, n, telescope, low, high);
    t.add(beam("rod" + n, rod.low, rod.high, material_of(p, "material"), tube_of(p, "rod")));
    t.add(spring_drive("drive" + n, rod.drive, p["drive_stiffness"]));
    draw_leg(t, rod, tube, 0.030 * height, 0.017 * height);
  };

  t.platform = t.add(Body{"platform", 0, false, Inertia::central(p["platform_mass"], p.numbers("platform_inertia"))});
  for (const Planar limb : planar) {
    const std::string n = std::to_string(limb.i + 1);
    t.add(Body{"lower beam G" + n, limb.i + 1, false, axisymmetric(p, "lower_beam", 0)});
    t.add(Joint{"R" + n + "1", JointKind::revolute, 0, limb.lower, within("plane_tilt")});
    for (const int j : {0, 1}) {
      const Leg rod = limb.rod(j);
      const std::string ij = n + std::to_string(j + 1);
      add_rod(rod, ij, {"RB" + ij, JointKind::revolute, limb.lower, rod.cylinder, within("pin_angle")},
              {"Rb" + ij, JointKind::revolute, limb.upper, rod.piston, within("pin_angle")});
    }
    t.add(Body{"upper beam g" + n, limb.i + 1, false, axisymmetric(p, "upper_beam", 0)});
    t.add(Body{"vertical rod " + n, limb.i + 1, false, {}});
    t.add(Joint{"R" + n + "5", JointKind::revolute, limb.vertical, limb.upper, within("swivel_angle")});
    t.add(Joint{"R" + n + "4", JointKind::revolute, platform, limb.vertical, within("swivel_angle")});
    for (const int j : {0, 1}) {  // the beams' halves, from their middle out to the rods
      const std::string ij = n + std::to_string(j + 1);
      const CrossSection square = rectangle(p["beam_width"], p["beam_width"]);
      t.add(beam("lower" + ij, limb.r1, limb.rod(j).low, material_of(p, "material"), square, 2));
      t.add(beam("upper" + ij, limb.r5, limb.rod(j).high, material_of(p, "material"), square, 2));
    }
    t.shapes.push_back({limb.lower, ShapeKind::box, {0, 0, 0}, {thick, thick, lower_}, 0});
    t.shapes.push_back({limb.upper, ShapeKind::box, {0, 0, 0}, {thick, thick, upper_ + 2 * thick}, 0});
  }
  add_rod(spr, "3", {"S3", JointKind::spherical, 0, spr.cylinder, {up_to(p["ball_cone"])}},
          {"R3", JointKind::revolute, platform, spr.piston, within("revolute_angle")});
  t.constraints.push_back({"constraint1", "force F_y along the axis of R3 through B3", "N"});
  return t;
}
}  // namespace
PMREPORT_PLUGIN(TwoQSpr)
