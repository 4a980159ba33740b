// The linear Delta of printers: three carriages on upright towers carry a platform on paired rods, three translations.
//
// In the base's axes tower i stands at azimuth phi_i: u_i points outwards, v_i along the pair's spacing, k = Z up. The platform hangs below
// the carriages and keeps the base's orientation, because each pair of rods is a parallelogram with sides along v_i. Halfway between its
// rods lie
//     B_i = R_i u_i + s_i k                          on the carriage, s_i its height over the bed,
//     C_i = p + r u_i                                on the platform,
// and the rods close the limb when they have their length:
//     |C_i - B_i| = l_i                                                                                                            (1)
#include <pmreport/elastic.hpp>
#include <pmreport/mechanism.hpp>
#include <pmreport/parts.hpp>

using namespace pmreport;
using Eigen::Vector3d;
namespace {
constexpr double pi = std::numbers::pi, deg = pi / 180;
constexpr const char* sides[] = {"above", "below"};
constexpr const char* axes[] = {"x", "y", "z"};
constexpr const char* axis_titles[] = {"X position", "Y position", "Z position"};
constexpr double azimuths[] = {210 * deg, 330 * deg, 90 * deg};

constexpr int platform = 1;
struct Limb {  // bodies and joints of limb i = 0..2; rod k = 0, 1
  int i, carriage = 2 + 3 * i, slide = 5 * i;
  int rod(int k) const { return carriage + 1 + k; }
  int b(int k) const { return slide + 1 + k; }
  int c(int k) const { return slide + 3 + k; }
};

class LinearDelta : public Mechanism<3> {
 public:
  static constexpr const char* name = "linear-delta";
  static constexpr const char* title = "Linear Delta: three carriages on upright towers, each with a pair of rods, 3 translations";
  static constexpr const char* source =
      "Clavel 1988, DELTA, a fast robot with parallel geometry, with slides for its arms; conventions of Klipper and Marlin";
  static constexpr Parameter parameters[] = {
      Parameter::length("tower_radius", 0.205, "distance R of the balls on the carriages from the middle", {0.001, 100})
          .unless("tower_radii"),
      Parameter::length("platform_radius", 0.03, "distance r of the balls on the platform from p", {0, 100}),
      Parameter::length("rod_length", 0.333, "length l of a rod, from ball to ball", {0.001, 100}).unless("rod_lengths"),
      Parameter::numbers("tower_radii", {}, {0.001, 100}, 0, 3, "m", "mm", "R of towers 1 to 3; none: tower_radius for all"),
      Parameter::numbers("rod_lengths", {}, {0.001, 100}, 0, 3, "m", "mm", "l of limbs 1 to 3; none: rod_length for all"),
      Parameter::numbers("tower_angles", azimuths, {-7, 7}, 3, 3, "rad", "deg", "azimuths of towers 1 to 3, which printers call A, B, C"),
      Parameter::length("rod_spacing", 0.05, "distance of the two rods of a limb", {0.001, 100}),
      Parameter::length("home_height", 0.1, "height of p over the bed at home", {-100, 100}),
      Parameter::working_mode("carriage1", sides, 0, "side of the platform on which carriage 1 stands"),
      Parameter::working_mode("carriage2", sides, 0, "side of the platform on which carriage 2 stands"),
      Parameter::working_mode("carriage3", sides, 0, "side of the platform on which carriage 3 stands"),
      Parameter::length("stroke_min", 0.1, "lowest place of the carriages' balls over the bed", {-100, 100}),
      Parameter::length("stroke_max", 0.58, "highest place of the carriages' balls over the bed", {-100, 100}),
      Parameter::angle("ball_cone", 60 * deg, "largest deflection of a ball joint from home", {0, pi}),
      Parameter::mass("platform_mass", 0.3, "mass of the platform with its tool, centre of mass at p"),
      Parameter::mass("carriage_mass", 0.2, "mass of a carriage with its share of the belt"),
      Parameter::mass("rod_mass", 0.02, "mass of one rod, a uniform tube"),
      Parameter::choice("bar_material", material_names, 6, "material of the rods"),
      Parameter::length("bar_diameter", 0.006, "outer diameter of a rod as a beam", {0.0001, 10}),
      Parameter::length("bar_bore", 0.004, "inner diameter of a rod as a beam", {0, 10}),
      Parameter::number("drive_stiffness", 2e5, {1, 1e15}, "N/m", "N/mm", "stiffness of a carriage's drive"),
  };

  explicit LinearDelta(const Parameters& p);
  Topology topology() const { return topology_; }

  // (1) squared: the carriage stands at (s_i - z)^2 = l_i^2 - |e_i|^2 over the platform, e_i = (R_i - r) u_i - (x, y) from ball to ball in
  // plan; of the two roots one is above the platform. They meet where the rods lie level, and beyond the limb does not reach.
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], q[2]);
    at.body(platform, p, Eigen::Matrix3d::Identity().cast<T>());
    for (const Limb limb : limbs_) {
      const auto i = static_cast<std::size_t>(limb.i);
      const Vector3d &u = u_[i], &v = v_[i];
      const T across = radius_[i] * u.x() - p(0) - platform_radius_ * u.x(), along = radius_[i] * u.y() - p(1) - platform_radius_ * u.y();
      const T squared = square(rod_[i]) - across * across - along * along;
      at.require(squared, "a rod is too short to reach from its tower to the platform");
      const T rise = side_[i] * sqrt(squared), s = p(2) + rise;
      const Vector3<T> ball(T(radius_[i] * u.x()), T(radius_[i] * u.y()), s), wrist = p + platform_radius_ * u;  // B_i, C_i
      const Vector3<T> n = Vector3<T>(-across, -along, -rise) * (1.0 / rod_[i]);
      Eigen::Matrix3d guide;
      guide << u, v, Vector3d::UnitZ();
      at.body(limb.carriage, ball, guide.cast<T>());
      at.joint(limb.slide, ball, Vector3d::UnitZ().cast<T>());
      at.actuator(limb.i, s);
      for (int k = 0; k < 2; ++k) {
        const Vector3d aside = (k - 0.5) * spacing_ * v;
        at.slender(limb.rod(k), ball + aside, n);
        at.joint(limb.b(k), ball + aside);
        at.joint(limb.c(k), wrist + aside);
      }
    }
  }

  // Along the rods, n_i, carriage and platform have the same speed: n_i . p' = n_iz s_i'. So a drive's force reaches the platform as a
  // force along n_i through C_i. The difference of the forces in the two rods is a couple across both, along v_i x n_i; three of them
  // hold the platform's orientation, unless they become coplanar.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g;
    for (const Limb limb : limbs_) {
      const Vector3<T> n = at.spine(limb.rod(0)), wrist = 0.5 * (at.centre(limb.c(0)) + at.centre(limb.c(1))) - at.origin(platform);
      force_row<T>(g, limb.i, n / n(2), wrist);
      couple_row<T>(g, 3 + limb.i, unit<T>(Vector3<T>(v_[static_cast<std::size_t>(limb.i)].cast<T>()).cross(n)));
    }
    return g;
  }

  // (1) squared and differentiated: (C_i - B_i) . p' - (C_i - B_i)_z s_i' = 0, that is A p' + B s' = 0.
  std::vector<Eigen::MatrixXd> matrices(const Coordinates<double>&, const Placement<double>& at) const {
    Eigen::MatrixXd a(3, 3), b = Eigen::MatrixXd::Zero(3, 3);
    for (const Limb limb : limbs_) {
      const Vector3d rod = rod_[static_cast<std::size_t>(limb.i)] * at.spine(limb.rod(0));
      a.row(limb.i) = rod;
      b(limb.i, limb.i) = -rod.z();
    }
    return {a, b};
  }

 private:
  Topology describe(const Parameters& p) const;

  static constexpr Limb limbs_[] = {{0}, {1}, {2}};

  double platform_radius_, spacing_;
  std::array<double, 3> radius_, rod_, side_;  // R_i; l_i; 1 above, -1 below
  std::array<Vector3d, 3> u_, v_;              // outwards, and along the spacing
  Topology topology_;
};

// One number for each limb: as listed, or the same for all.
std::array<double, 3> each(const Parameters& p, const char* list, const char* one) {
  const auto given = p.numbers(list);
  if (!given.empty() && given.size() != 3) refuse(list, ": expected 3 numbers, or none; seen ", std::to_string(given.size()));
  const double all = p[one];
  return given.empty() ? std::array{all, all, all} : std::array{given[0], given[1], given[2]};
}

LinearDelta::LinearDelta(const Parameters& p)
    : platform_radius_(p["platform_radius"]),
      spacing_(p["rod_spacing"]),
      radius_(each(p, "tower_radii", "tower_radius")),
      rod_(each(p, "rod_lengths", "rod_length")) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double azimuth = p.numbers("tower_angles")[i];
    u_[i] = {cos(azimuth), sin(azimuth), 0};
    v_[i] = {-sin(azimuth), cos(azimuth), 0};
    side_[i] = p.choice("carriage" + std::to_string(i + 1)) == "above" ? 1 : -1;
    const double across = abs(radius_[i] - platform_radius_);
    if (!(across < 0.98 * rod_[i]))
      refuse("home has the platform in the middle: the rods of limb ", std::to_string(i + 1), " must be longer than ", across / 0.98,
             " m to reach it");
    if (across < 0.02 * rod_[i])
      refuse("home has the platform in the middle: the rods of limb ", std::to_string(i + 1),
             " stand upright there, and such a platform turns freely about Z; its tower must be ", 0.02 * rod_[i],
             " m nearer or farther than the platform's joints");
    for (std::size_t k = 0; k < i; ++k)
      if (abs(u_[i].cross(u_[k]).z()) < 0.01 && u_[i].dot(u_[k]) > 0)
        refuse("tower_angles: towers ", std::to_string(k + 1), " and ", std::to_string(i + 1),
               " stand in one direction; such a platform tips freely");
  }
  topology_ = describe(p);
}

Topology LinearDelta::describe(const Parameters& p) const {
  Topology t;
  const double shortest = *std::ranges::min_element(rod_);
  double room = 0.24 * shortest;  // in plan, from home
  for (std::size_t i = 0; i < 3; ++i) room = std::min(room, 0.5 * (rod_[i] - abs(radius_[i] - platform_radius_)));
  for (int k = 0; k < 3; ++k)
    t.add(Coordinate::around(k == 2 ? p["home_height"] : 0, k == 2 ? 0.24 * shortest : room, axes[k], axis_titles[k], "m"), false);
  const double tube = 0.02 * shortest, wide = 0.5 * spacing_, round = std::max(platform_radius_, tube);
  t.platform = t.add(Body{"platform", 0, false, Inertia::solid_cylinder(p["platform_mass"], tube, round, 0)});
  const Range stroke = range_of(p, "stroke_min", "stroke_max");
  const std::vector<Range> cone{up_to(p["ball_cone"])};
  for (const Limb limb : limbs_) {
    const auto i = static_cast<std::size_t>(limb.i);
    const std::string n = std::to_string(limb.i + 1), rods[] = {n + "1", n + "2"};
    // A tube, m (a^2 + b^2) / 2 about its axis and m (3 (a^2 + b^2) + l^2) / 12 across.
    const double m = p["rod_mass"], radii = square(0.5 * p["bar_diameter"]) + square(0.5 * p["bar_bore"]);
    const Inertia rod = Inertia::axisymmetric(m, 0.5 * rod_[i], m * (3 * radii + square(rod_[i])) / 12, m * radii / 2);
    t.add(Body{"carriage " + n, limb.i + 1, false, Inertia::axisymmetric(p["carriage_mass"], 0, 0, 0)});
    t.add(Joint{"P" + n, JointKind::prismatic, 0, limb.carriage, {}});  // bounded by the stroke
    for (int k = 0; k < 2; ++k) {
      t.add(Body{"rod " + rods[k], limb.i + 1, true, rod});
      t.add(Joint{"B" + rods[k], JointKind::spherical, limb.carriage, limb.rod(k), cone});
      t.draw_along_axis(limb.rod(k), 0, rod_[i], 0.4 * tube);
    }
    for (int k = 0; k < 2; ++k) t.add(Joint{"C" + rods[k], JointKind::spherical, limb.rod(k), platform, cone});
    t.add(Actuator{"s" + n, "height of carriage " + n + " over the bed", "m", limb.slide, stroke});
    t.constraints.push_back({"couple" + n, "couple of the rods of limb " + n + " on the platform", "N*m"});
    for (const int k : {0, 1}) t.add(beam("rod" + rods[k], limb.b(k), limb.c(k), material_of(p, "bar_material"), tube_of(p, "bar")));
    t.add(spring_drive("drive" + n, limb.i, p["drive_stiffness"]));

    // Rails stand behind the carriages, from the bed to where the stroke ends.
    const double back = 3 * tube;
    const Vector3d foot = (radius_[i] + back) * u_[i], rail = foot + std::max(stroke.max + back, 2 * back) * Vector3d::UnitZ();
    t.shapes.push_back({0, ShapeKind::cylinder, foot - back * Vector3d::UnitZ(), rail, tube});
    t.shapes.push_back({limb.carriage, ShapeKind::box, {back, 0, 0}, {1.4 * tube, 1.6 * tube, 2 * tube}, 0});
    t.shapes.push_back({limb.carriage, ShapeKind::cylinder, {0, 0, 0}, {back, 0, 0}, 0.6 * tube});
    t.shapes.push_back({limb.carriage, ShapeKind::cylinder, {0, -wide, 0}, {0, wide, 0}, 0.6 * tube});
  }
  t.matrices = {{"A", "closure by the position, C_i - B_i in its rows [m]", 3, 3, Rates::coordinates, Rates::none, 0},
                {"B", "closure by the carriages' heights [m]", 3, 3, Rates::actuators, Rates::none, 0}};
  t.idle = 6;  // every rod may spin about itself
  return t;
}
}  // namespace
PMREPORT_PLUGIN(LinearDelta)
