// Two planar limbs Q1, Q2 and one SPR limb, five degrees of freedom.
//
// Equation numbers are those of Zhang et al. 2016; README.md beside this file says where the paper errs and what of it reproduces.
//
// Platform and base are regular triangles with vertices b_i = p + R b_i and B_i. A planar limb Q_i stands in a plane through its base hinge
// R_i1, the line B_i n_i. Lower beam, two driven rods and upper beam close a loop of hinges along the plane's normal N_i inside it; the
// vertical rod's hinges R_i5 (about the upper beam mu_i) and R_i4 (about the platform's normal n_z) let the plane and the platform go their
// own ways. Such a limb drives two freedoms and takes none. The SPR limb stays perpendicular to its hinge f3 = R u3, which takes one:
//     f3 . (B_3 - b_3) = 0   <=>   f3 . (p - B_3) + u3 . b_3 = 0          (C)
#include <pmreport/mechanism.hpp>

using namespace pmreport;
using Eigen::Vector3d;
namespace {
constexpr double pi = std::numbers::pi, deg = pi / 180;
constexpr const char* rod_words[] = {"uncrossed", "crossed"};
constexpr double tangential_axis[] = {0, 0, 0}, platform_inertia[] = {0.002, 0.002, 0.002, 0, 0, 0};

constexpr int platform = 1, spr_cylinder = 16, spr_piston = 17, s3 = 18, p3 = 19, r3 = 20;
struct Planar {  // bodies and joints of limb Q_i, i = 0, 1, in its rods j = 0, 1
  int i, lower = 2 + 7 * i, upper = 7 + 7 * i, vertical = 8 + 7 * i;
  int r1 = 9 * i, r5 = 9 * i + 7, r4 = 9 * i + 8;
  constexpr int cylinder(int j) const { return lower + 1 + 2 * j; }
  constexpr int piston(int j) const { return lower + 2 + 2 * j; }
  constexpr int base_pin(int j) const { return r1 + 1 + 3 * j; }  // R_Bij
  constexpr int slide(int j) const { return r1 + 2 + 3 * j; }     // P_ij
  constexpr int beam_pin(int j) const { return r1 + 3 + 3 * j; }  // R_bij
};
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
      Parameter::length("stroke_max", 0.410, "longest rod", {0.001, 100}),
      Parameter::angle("plane_tilt", 45 * deg, "largest turn of a limb's plane (R_i1) from home", {0, pi}),
      Parameter::angle("pin_angle", 45 * deg, "largest turn of a rod against a beam (R_Bij, R_bij) from home", {0, pi}),
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

    // ZYZ angles (Eq. 2) have no derivative at home. These have one wherever beta < 180 degrees, and say the same:
    // n_z = (sin beta cos alpha, sin beta sin alpha, cos beta), and (1 + cos beta)(cos, sin)(alpha + gamma) as below.
    at.derived(0, y);
    at.derived(1, nz.x());
    at.derived(2, nz.y());
    at.derived(3, atan2(T(r(1, 0) - r(0, 1)), T(r(0, 0) + r(1, 1))));

    for (const Planar limb : planar_) place_planar<T>(limb, p + r * platform_[std::size_t(limb.i)], nz, at);

    const auto b3 = base_[2].cast<T>().eval();
    const Vector3<T> tip = p + r * platform_[2], along = tip - b3;
    const T l = length(along);
    const Vector3<T> delta = along * T(1.0 / l);
    const Matrix3<T> turned = frame_xz(f3, delta);
    at.body(spr_cylinder, b3, turned);
    at.body(spr_piston, tip, turned);
    at.joint(s3, b3);
    at.joint(p3, tip, delta);
    at.joint(r3, tip, f3);
    at.actuator(4, l);
  }

  // Statics of a planar limb. Rod ij pushes the upper beam with delta at b_ij: with delta at b_i, and a couple of size
  //     lever = +-d mu x delta . N
  // about N. R_i5 and R_i4 pass on to the platform no couple but one along w = n_z x mu, so the platform gets k w with k = lever / (N . w).
  // What k w has beside N, the lower beam holds, all but its part about the hinge R_i1: a force f N at b_i balances that one,
  // k n . w + f n . (r_i x N) = 0, with n . (r_i x N) = |n x r_i|. The rod thus applies (delta + f N) at b_i and the couple k w; read as a
  // row, the same wrench gives the rod's rate, Eqs. (12) and (13), for which the paper leaves J_wbi open.
  // The force of R3 acts along f3 through B_3, where the ball cannot give way, Eq. (16).
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Vector3<T> p = at.origin(platform);
    Matrix6<T> g;
    for (const Planar limb : planar_) {
      const Vector3d& n = hinge_[std::size_t(limb.i)];
      const Vector3<T> b = at.centre(limb.r4), r = b - base_[std::size_t(limb.i)], mu = at.axis(limb.r5);
      const Vector3<T> normal = at.axis(limb.base_pin(0)), w = at.axis(limb.r4).cross(mu);
      for (int j = 0; j < 2; ++j) {
        const Vector3<T> delta = at.axis(limb.slide(j));
        const T lever = end_sign[j] * upper_ * mu.cross(delta).dot(normal), k = lever / normal.dot(w);
        const T f = -k * w.dot(n) / r.cross(normal).dot(n);
        force_row<T>(g, 2 * limb.i + j, delta + normal * f, b - p);
        for (int c = 0; c < 3; ++c) g(2 * limb.i + j, 3 + c) += k * w(c);
      }
    }
    force_row<T>(g, 4, at.axis(p3), at.centre(r3) - p);  // Eq. (14)
    force_row<T>(g, 5, at.axis(r3), at.centre(s3) - p);
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
    at.require(height - 0.02 * lower_,
               "a platform joint lies almost on the base hinge of its planar limb, whose plane it no longer determines");
    const Vector3<T> normal = across * T(1.0 / height), along = nz.cross(normal);
    const T sine = length(along);
    at.require(sine - 0.05, "the platform is almost parallel to the plane of a planar limb, whose upper beam it no longer directs");
    const Vector3<T> mu = along * T(mode_[i] / sine);

    at.body(limb.lower, foot, frame_xz(normal, n));
    at.body(limb.upper, b, frame_xz(normal, mu));
    at.body(limb.vertical, b, frame_xz(mu, nz));
    at.joint(limb.r1, foot, n);
    at.joint(limb.r5, b, mu);
    at.joint(limb.r4, b, nz);
    for (int j = 0; j < 2; ++j) {
      const Vector3<T> low = foot + n * (end_sign[j] * lower_), high = b + mu * (end_sign[j] * upper_), rod = high - low;
      const T l = length(rod);
      const Vector3<T> delta = rod * T(1.0 / l);
      const Matrix3<T> turned = frame_xz(normal, delta);
      at.body(limb.cylinder(j), low, turned);
      at.body(limb.piston(j), high, turned);
      at.joint(limb.base_pin(j), low, normal);
      at.joint(limb.slide(j), high, delta);
      at.joint(limb.beam_pin(j), high, normal);
      at.actuator(2 * limb.i + j, l);
    }
  }

  Topology describe(const Parameters& p) const;

  static constexpr Planar planar_[] = {{0}, {1}};

  std::array<Vector3d, 3> base_, platform_;  // B_i in base axes, b_i in platform axes
  std::array<Vector3d, 2> hinge_;            // n_i
  Vector3d u3_;                              // axis of R3, platform axes
  double offset_, lower_, upper_;            // u3 . b_3, D, d
  std::array<double, 2> mode_;               // sign of mu_i
  Topology topology_;
};

TwoQSpr::TwoQSpr(const Parameters& p)
    : lower_(p["lower_beam"]),
      upper_(p["upper_beam"]),
      mode_{p.choice("rods_1") == "crossed" ? -1.0 : 1.0, p.choice("rods_2") == "crossed" ? -1.0 : 1.0} {
  constexpr double azimuth[] = {-30 * deg, 90 * deg, 210 * deg};
  for (std::size_t i = 0; i < 3; ++i) {  // Eq. (1)
    const Vector3d vertex = Vector3d(cos(azimuth[i]), sin(azimuth[i]), 0) / sqrt(3.0);
    base_[i] = p["base_side"] * vertex;
    platform_[i] = p["platform_side"] * vertex;
  }
  hinge_ = {(base_[1] - base_[2]).normalized(), (base_[0] - base_[2]).normalized()};  // Eq. (5): along the opposite side
  if (p["stroke_min"] >= p["stroke_max"]) refuse("stroke_min must be less than stroke_max");

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
  const double height = p["home_height"], tube = 0.95 * p["stroke_min"];  // no part is drawn longer than the shortest rod
  t.add(Coordinate::around(0, 0.1 * height, "x", "X position", "m"), false);
  t.add(Coordinate::around(height, height / 6, "z", "Z position", "m"), false);
  t.add(Coordinate::around(0, 10 * deg, "yaw", "turn about Z", "rad"), false);
  t.add(Coordinate::around(0, 10 * deg, "pitch", "turn about Y1", "rad"), false);
  t.add(Coordinate::around(0, 10 * deg, "roll", "turn about X2", "rad"), false);
  t.derived = {{"y", "Y position", "m", true},
               {"normal_x", "X part of the platform's normal, sin(beta) cos(alpha)", "", false},
               {"normal_y", "Y part of the platform's normal, sin(beta) sin(alpha)", "", false},
               {"torsion", "torsion alpha + gamma of the ZYZ angles", "rad", false}};

  const auto beam = [&p](const std::string& n) {
    return Inertia::axisymmetric(p[n + "_mass"], 0, p[n + "_inertia"], p[n + "_axial_inertia"]);
  };
  const auto cylinder = Inertia::axisymmetric(p["cylinder_mass"], p["cylinder_centre"], p["cylinder_inertia"], p["cylinder_axial_inertia"]);
  const auto piston = Inertia::axisymmetric(p["piston_mass"], -p["piston_centre"], p["piston_inertia"], p["piston_axial_inertia"]);
  const auto within = [&p](const char* angle) { return std::vector<Range>{{-p[angle], p[angle]}}; };
  const Range stroke{p["stroke_min"], p["stroke_max"]};
  const auto rod = [&](const std::string& n, int limb) {
    const int a = t.add(Body{"cylinder " + n, limb, false, cylinder}), b = t.add(Body{"piston " + n, limb, false, piston});
    t.draw_along_axis(a, 0, tube, 0.030 * height);
    t.draw_along_axis(b, -tube, 0, 0.017 * height);
  };
  const auto drive = [&](const std::string& n, int slide) { t.add(Actuator{"r" + n, "length of rod " + n, "m", slide, stroke}); };

  t.platform = t.add(Body{"platform", 0, false, Inertia::central(p["platform_mass"], p.numbers("platform_inertia"))});
  for (const Planar limb : planar_) {
    const std::string n = std::to_string(limb.i + 1);
    t.add(Body{"lower beam G" + n, limb.i + 1, false, beam("lower_beam")});
    for (const char* j : {"1", "2"}) rod(n + j, limb.i + 1);
    t.add(Body{"upper beam g" + n, limb.i + 1, false, beam("upper_beam")});
    t.add(Body{"vertical rod " + n, limb.i + 1, false, {}});
    t.add(Joint{"R" + n + "1", JointKind::revolute, 0, limb.lower, within("plane_tilt")});
    for (int j = 0; j < 2; ++j) {
      const std::string ij = n + std::to_string(j + 1);
      t.add(Joint{"RB" + ij, JointKind::revolute, limb.lower, limb.cylinder(j), within("pin_angle")});
      drive(ij, t.add(Joint{"P" + ij, JointKind::prismatic, limb.cylinder(j), limb.piston(j), {}}));
      t.add(Joint{"Rb" + ij, JointKind::revolute, limb.upper, limb.piston(j), within("pin_angle")});
    }
    t.add(Joint{"R" + n + "5", JointKind::revolute, limb.vertical, limb.upper, within("swivel_angle")});
    t.add(Joint{"R" + n + "4", JointKind::revolute, platform, limb.vertical, within("swivel_angle")});
  }
  rod("3", 3);
  t.add(Joint{"S3", JointKind::spherical, 0, spr_cylinder, {{0, p["ball_cone"]}}});
  drive("3", t.add(Joint{"P3", JointKind::prismatic, spr_cylinder, spr_piston, {}}));
  t.add(Joint{"R3", JointKind::revolute, platform, spr_piston, within("revolute_angle")});
  t.constraints.push_back({"constraint1", "force F_y along the axis of R3 through B3", "N"});
  return t;
}
}  // namespace
PMREPORT_PLUGIN(TwoQSpr)
