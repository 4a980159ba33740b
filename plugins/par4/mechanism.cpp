// Par4, the robot behind the Quattro: four driven arms, each with two parallel rods, under a plate of four bodies that shears to turn the
// tool. Three translations and one rotation.
//
// After Nabat et al. 2005. Limb i stands at azimuth phi_i: u_i points outwards, v_i along the motor's axis, k = Z up. The plate hangs
// below: two halves, two bars of length 2 a between them, and four upright hinges at the corners of a parallelogram,
//
//       C3                        C2         the bars turned by theta: h = a (cos(theta), sin(theta), 0)
//           H2 --- tool bar --- H1           the hinges of a half apart by s, 2 b long, fixed in the half
//    half 2 |        p         |  s  half 1  p  the middle of the tool bar
//           H4 --- link bar --- H3           c = p - s / 2      the middle of the plate
//       C4                        C1         half 1 stands at c + h, half 2 at c - h
//
// Each pair of rods is a parallelogram with sides along v_i, which holds its half against turning about v_i x n_i, n_i along the rods. Two
// limbs a half and the parallel hinges keep both halves as they are at home, so they only translate, and opposite to each other as the bars
// turn. With sigma_i = 1 for limbs 1 and 2 on half 1, -1 for 3 and 4 on half 2, halfway between the rods of limb i lie
//     A_i = R u_i                                          on the motor's axis,
//     B_i = A_i + L e_i,                                   the elbow, e_i = cos(theta_i) u_i - sin(theta_i) k: theta_i lowers the arm,
//     C_i = c + sigma_i h + (r u_i - sigma_i h at home)    on the half,
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

constexpr int platform = 1, link_bar = 2, halves[] = {3, 4};
constexpr int h1 = 0, h2 = 1, h3 = 2, h4 = 3;
struct Limb {  // bodies and joints of limb i = 0..3; rod k = 0, 1
  int i, arm = 5 + 3 * i, a = 4 + 5 * i;
  int half() const { return halves[i / 2]; }
  double side() const { return i < 2 ? 1 : -1; }  // sigma_i
  int rod(int k) const { return arm + 1 + k; }
  int b(int k) const { return a + 1 + k; }
  int c(int k) const { return a + 3 + k; }
};

// A uniform round bar along axis `axis` of its body, its middle at `centre`.
Inertia bar(double mass, double length, double radius, int axis, const Vector3d& centre) {
  Vector3d about = Vector3d::Constant(mass * (3 * square(radius) + square(length)) / 12);
  about(axis) = mass * square(radius) / 2;
  return {mass, centre, about.asDiagonal()};
}

class Par4 : public Mechanism<4> {
 public:
  static constexpr const char* name = "par4";
  static constexpr const char* title =
      "Par4: four driven arms, each with a pair of rods, and a plate that shears, 3 translations and a turn";
  static constexpr const char* source =
      "Nabat, Rodriguez, Company, Krut, Pierrot 2005, Par4: very high speed parallel robot for pick-and-place; sizes like a Quattro s650";
  static constexpr Parameter parameters[] = {
      Parameter::length("base_radius", 0.275, "distance R of the motors' axes from O", {0.001, 100}),
      Parameter::length("platform_radius", 0.1, "distance r of the rods from the middle of the plate, at home", {0.001, 100}),
      Parameter::length("arm_length", 0.375, "length L of an arm, from the motor's axis to the elbow", {0.001, 100}),
      Parameter::length("rod_length", 0.825, "length l of a rod, from ball to ball", {0.001, 100}),
      Parameter::length("rod_spacing", 0.08, "distance of the two rods of a limb", {0.001, 100}),
      Parameter::length("bar_length", 0.11, "length 2 a of the plate's bars, from hinge to hinge", {0.001, 100}),
      Parameter::length("hinge_spacing", 0.1, "distance 2 b of the two hinges of a half", {0.001, 100}),
      Parameter::angle("plate_angle", 90 * deg, "angle between bars and hinge lines at home", {15 * deg, 165 * deg}),
      Parameter::working_mode("elbow1", elbows, 0, "elbow of limb 1: arm above or below the line from A1 to C1"),
      Parameter::working_mode("elbow2", elbows, 0, "elbow of limb 2"),
      Parameter::working_mode("elbow3", elbows, 0, "elbow of limb 3"),
      Parameter::working_mode("elbow4", elbows, 0, "elbow of limb 4"),
      Parameter::angle("arm_highest", -50 * deg, "smallest angle of an arm", {-pi / 2, 3 * pi / 2}),
      Parameter::angle("arm_lowest", 100 * deg, "largest angle of an arm", {-pi / 2, 3 * pi / 2}),
      Parameter::angle("ball_cone", 60 * deg, "largest deflection of a ball joint from home", {0, pi}),
      Parameter::angle("hinge_turn", 46.25 * deg, "largest turn of the plate's hinges from home, and so of the tool", {0, pi}),
      Parameter::mass("tool_bar_mass", 0.3, "mass of the bar that carries the tool, with the tool"),
      Parameter::mass("link_bar_mass", 0.3, "mass of the other bar"),
      Parameter::mass("half_mass", 0.3, "mass of a half of the plate, a bar from wrist to wrist"),
      Parameter::mass("arm_mass", 1, "mass of an arm, a uniform tube"),
      Parameter::mass("rod_mass", 0.1, "mass of one rod, a uniform tube"),
      Parameter::inertia("motor_inertia", 0.03, "inertia of a motor and its gear, felt at the arm"),
      Parameter::choice("arm_material", material_names, 3, "material of the arms"),
      Parameter::length("arm_diameter", 0.06, "outer diameter of an arm as a beam", {0.0001, 10}),
      Parameter::length("arm_bore", 0.05, "inner diameter of an arm as a beam", {0, 10}),
      Parameter::choice("bar_material", material_names, 6, "material of the rods"),
      Parameter::length("bar_diameter", 0.014, "outer diameter of a rod as a beam", {0.0001, 10}),
      Parameter::length("bar_bore", 0.010, "inner diameter of a rod as a beam", {0, 10}),
      Parameter::number("drive_stiffness", 25000, {1e-3, 1e12}, "N*m/rad", "N*m/rad", "stiffness of a motor with its gear"),
  };

  explicit Par4(const Parameters& p);
  Topology topology() const { return topology_; }

  // With d = C_i - A_i and a = d . u_i, c = -d . k its shares in the plane of the arm, (1) squared is
  //     a cos(theta_i) + c sin(theta_i) = m,     m = (|d|^2 + L^2 - l^2) / 2L.
  // So the arm's direction (cos, sin) has the component m / h along (a, c), h^2 = a^2 + c^2, and w / h across, w^2 = h^2 - m^2: to the one
  // side or the other, elbow out or in. The two meet where w = 0, arm and rods in one plane, and beyond the limb does not reach.
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]), up = Vector3d::UnitZ().cast<T>();
    const Matrix3<T> turned = rotation_z(q[3]), level = Eigen::Matrix3d::Identity().cast<T>();
    const Vector3<T> h = half_bar_ * turned.col(0), across = hinge_line_.cast<T>(), middle = p - 0.5 * across;
    const Vector3<T> half[] = {middle + h, middle - h};
    at.body(platform, p, turned);
    at.body(link_bar, p - across, turned);
    at.body(halves[0], half[0], level);
    at.body(halves[1], half[1], level);
    at.joint(h1, p + h, up);
    at.joint(h2, p - h, up);
    at.joint(h3, p - across + h, up);
    at.joint(h4, p - across - h, up);
    at.derived(0, plate_angle_ - q[3]);

    for (const Limb limb : limbs_) {
      const Vector3d &u = u_[limb.i], &v = v_[limb.i], motor = base_radius_ * u;
      const Vector3<T> wrist = half[limb.i / 2] + wrist_[limb.i], d = wrist - motor;  // C_i
      const T a = d.dot(u), c = -d(2), h2 = a * a + c * c, m = (d.dot(d) + square(arm_) - square(rod_)) * (0.5 / arm_);
      const T w2 = h2 - m * m;
      at.require(w2, "a wrist is too far from its motor, or too near, for arm and rods");
      const T w = elbow_[limb.i] * sqrt(w2), cosine = (m * a + w * c) / h2, sine = (m * c - w * a) / h2;

      const Vector3<T> axis = v.cast<T>(), along = cosine * u - sine * Vector3d::UnitZ();  // v_i, e_i
      const Vector3<T> elbow = motor + arm_ * along, n = (wrist - elbow) * (1.0 / rod_);   // B_i, n_i
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

  // Along the rods elbow and half have the same speed: n_i . (p' + sigma_i h') = n_i . t_i L theta_i', t_i = v_i x e_i the way the elbow
  // goes, h' = theta' k x h. So a motor's torque reaches the plate as the force F = n_i / (L n_i . t_i) through C_i. As halves do not turn,
  // the bar feels about Z not its moment but sigma_i F . (k x h): it is turned by halves that push its ends aside. About X and Y it feels
  // the moment. What is missing, and every tilt of the load, the rods take by the difference of their forces, couples along v_i x n_i. On
  // the bar they act through the hinges, about X and Y alone.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g;
    const Vector3<T> h = 0.5 * (at.centre(h1) - at.centre(h2)), aside(-h(1), h(0), T(0.0)), p = at.origin(platform);
    for (const Limb limb : limbs_) {
      const Vector3<T> n = at.spine(limb.rod(0)), t = at.axis(limb.a).cross(at.rotation(limb.arm).col(2));
      const Vector3<T> force = n / T(arm_ * n.dot(t)), wrist = 0.5 * (at.centre(limb.c(0)) + at.centre(limb.c(1)));
      force_row<T>(g, limb.i, force, wrist - p);
      g(limb.i, 5) = limb.side() * force.dot(aside);
    }
    for (const int k : {0, 1}) couple_row<T>(g, 4 + k, Vector3d::Unit(k).cast<T>());
    return g;
  }

  // (1) squared and differentiated: (C_i - B_i) . (p' + sigma_i h') - L (C_i - B_i) . t_i theta_i' = 0, that is A x' + B theta' = 0.
  std::vector<Eigen::MatrixXd> matrices(const Coordinates<double>& q, const Placement<double>& at) const {
    Eigen::MatrixXd a(4, 4), b = Eigen::MatrixXd::Zero(4, 4);
    const Vector3d aside = half_bar_ * Vector3d(-sin(q[3]), cos(q[3]), 0);
    for (const Limb limb : limbs_) {
      const Vector3d rod = rod_ * at.spine(limb.rod(0)), t = v_[limb.i].cross(at.rotation(limb.arm).col(2));
      a.row(limb.i) << rod.transpose(), limb.side() * rod.dot(aside);
      b(limb.i, limb.i) = -arm_ * rod.dot(t);
    }
    return {a, b};
  }

 private:
  Topology describe(const Parameters& p) const;
  void draw(Topology& t) const;

  static constexpr Limb limbs_[] = {{0}, {1}, {2}, {3}};

  double base_radius_, arm_, rod_, spacing_, half_bar_, plate_angle_;
  double elbow_[4];       // 1 out, -1 in
  double home_;           // height of p with level arms, elbows out
  Vector3d hinge_line_;   // s: from the link bar's hinges to the tool bar's
  Vector3d u_[4], v_[4];  // outwards, and along the motor's axis
  Vector3d wrist_[4];     // C_i in the axes of its half
  Topology topology_;
};

Par4::Par4(const Parameters& p)
    : base_radius_(p["base_radius"]),
      arm_(p["arm_length"]),
      rod_(p["rod_length"]),
      spacing_(p["rod_spacing"]),
      half_bar_(0.5 * p["bar_length"]),
      plate_angle_(p["plate_angle"]),
      hinge_line_(p["hinge_spacing"] * Vector3d(cos(plate_angle_), sin(plate_angle_), 0)) {
  constexpr double x[] = {1, 1, -1, -1}, y[] = {-1, 1, 1, -1};  // azimuths -45, 45, 135 and 225 degrees
  for (const Limb limb : limbs_) {
    const int i = limb.i;
    u_[i] = sqrt(0.5) * Vector3d(x[i], y[i], 0);
    v_[i] = sqrt(0.5) * Vector3d(-y[i], x[i], 0);
    wrist_[i] = p["platform_radius"] * u_[i] - limb.side() * half_bar_ * Vector3d::UnitX();
    elbow_[i] = p.choice("elbow" + std::to_string(i + 1)) == "out" ? 1 : -1;
  }
  const double across = base_radius_ + arm_ - p["platform_radius"];
  if (!(abs(across) < 0.98 * rod_))
    refuse("home has level arms, from whose elbows the rods must hang: rod_length must be above ", abs(across) / 0.98, " m");
  if (p["arm_highest"] >= p["arm_lowest"]) refuse("arm_highest must be less than arm_lowest: theta lowers the arm");
  home_ = -sqrt(square(rod_) - square(across));
  topology_ = describe(p);
}

Topology Par4::describe(const Parameters& p) const {
  Topology t;
  const Vector3d home = 0.5 * hinge_line_ + home_ * Vector3d::UnitZ();  // the middle of the plate is under O
  t.coordinates = {Coordinate::around(home.x(), 0.24 * rod_, "x", "X position", "m"),
                   Coordinate::around(home.y(), 0.24 * rod_, "y", "Y position", "m"),
                   Coordinate::around(home.z(), 0.12 * rod_, "z", "Z position", "m"),
                   Coordinate::around(0, 30 * deg, "theta", "turn of the tool about Z", "rad")};
  const double tube = 0.04 * arm_, thick = 0.12 * p["bar_length"];
  const auto of_bar = [&](const char* mass) { return bar(p[mass], p["bar_length"], thick, 0, Vector3d::Zero()); };
  t.platform = t.add(Body{"tool bar", 0, false, of_bar("tool_bar_mass")});
  t.add(Body{"link bar", 0, false, of_bar("link_bar_mass")});
  for (const int k : {0, 1}) {
    const Vector3d &first = wrist_[2 * k], &second = wrist_[2 * k + 1];
    t.add(Body{k == 0 ? "half 1" : "half 2", 0, false, bar(p["half_mass"], (second - first).norm(), thick, 1, 0.5 * (first + second))});
  }
  const std::vector<Range> turn{either_way(p["hinge_turn"])}, cone{up_to(p["ball_cone"])};
  for (const int k : {0, 1, 2, 3}) {
    const std::string n = std::to_string(k + 1);
    t.add(Joint{"H" + n, JointKind::revolute, halves[k % 2], k < 2 ? platform : link_bar, turn});
  }
  t.derived.push_back({"opening", "angle between bars and hinge lines of the plate; at 0 and 180 degrees it is flat", "rad"});

  Inertia arm = Inertia::solid_cylinder(p["arm_mass"], arm_, 0.05 * arm_, 0.5 * arm_);
  arm.about_centre(0, 0) += p["motor_inertia"];
  const Inertia rod = Inertia::solid_cylinder(p["rod_mass"], rod_, 0.006 * rod_, 0.5 * rod_);
  for (const Limb limb : limbs_) {
    const std::string n = std::to_string(limb.i + 1), rods[] = {n + "1", n + "2"};
    t.add(Body{"arm " + n, limb.i + 1, false, arm});
    t.add(Joint{"A" + n, JointKind::revolute, 0, limb.arm, {}});  // bounded by the stroke
    for (int k = 0; k < 2; ++k) {
      t.add(Body{"rod " + rods[k], limb.i + 1, true, rod});
      t.add(Joint{"B" + rods[k], JointKind::spherical, limb.arm, limb.rod(k), cone});
      t.draw_along_axis(limb.rod(k), 0, rod_, 0.35 * tube);
    }
    for (int k = 0; k < 2; ++k) t.add(Joint{"C" + rods[k], JointKind::spherical, limb.rod(k), limb.half(), cone, limb.rod(k)});
    t.add(Actuator{"theta" + n, "angle of arm " + n + " below level", "rad", limb.a, {p["arm_highest"], p["arm_lowest"]}});
    t.add(arm_beam("arm" + n, limb.a, limb.b(0), limb.b(1), material_of(p, "arm_material"), tube_of(p, "arm")));
    for (const int k : {0, 1}) t.add(beam("rod" + rods[k], limb.b(k), limb.c(k), material_of(p, "bar_material"), tube_of(p, "bar")));
    t.add(spring_drive("drive" + n, limb.i, p["drive_stiffness"]));
    t.draw_along_axis(limb.arm, 0, arm_, tube);
    for (const double z : {0.0, arm_})
      t.shapes.push_back({limb.arm, ShapeKind::cylinder, {-spacing_ / 2, 0, z}, {spacing_ / 2, 0, z}, (z == 0 ? 1.5 : 0.5) * tube});
  }
  t.constraints = {{"couple_x", "couple of the rods about X", "N*m"}, {"couple_y", "couple of the rods about Y", "N*m"}};
  t.matrices = {
      {"A", "closure by the pose, (C_i - B_i, its share of the turn) in its rows [m], [m^2]", 4, 4, Rates::coordinates, Rates::none, 0},
      {"B", "closure by the arms' angles [m^2]", 4, 4, Rates::actuators, Rates::none, 0}};
  t.idle = 8;  // every rod may spin about itself
  draw(t);
  return t;
}

// A half is its hinge line, the line of its wrists and what joins them; a bar is flat, and the tool hangs on its own. The base is drawn as
// a plate, from its joints.
void Par4::draw(Topology& t) const {
  const double thin = 0.12 * half_bar_;
  const auto stick = [&](int body, const Vector3d& a, const Vector3d& b, double radius) {
    t.shapes.push_back({body, ShapeKind::cylinder, a, b, radius});
  };
  for (const int k : {0, 1}) {
    const Vector3d middle = 0.5 * (wrist_[2 * k] + wrist_[2 * k + 1]);
    stick(halves[k], -0.5 * hinge_line_, 0.5 * hinge_line_, 1.2 * thin);
    stick(halves[k], wrist_[2 * k], wrist_[2 * k + 1], 1.2 * thin);
    stick(halves[k], Vector3d::Zero(), middle, 1.2 * thin);
  }
  for (const Limb limb : limbs_) {
    const Vector3d aside = 0.5 * spacing_ * v_[limb.i];
    stick(limb.half(), wrist_[limb.i] - aside, wrist_[limb.i] + aside, thin);
  }
  for (const int body : {platform, link_bar}) t.shapes.push_back({body, ShapeKind::box, Vector3d::Zero(), {half_bar_, 2 * thin, thin}, 0});
  stick(platform, Vector3d::Zero(), {0, 0, -0.8 * half_bar_}, 3 * thin);
}
}  // namespace
PMREPORT_PLUGIN(Par4)
