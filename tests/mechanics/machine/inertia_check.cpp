// Inertias that bodies have are taken, those that no body has are told, and the parameter that brought it is named.
#include <core/mechanics/machine/inertia_check.hpp>
#include <pmreport/mechanism.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Catch::Contains;
using Catch::StartsWith;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// Of mass points, by the definition of an inertia: the kinetic energy of a turn about e is e^T I e / 2.
Inertia of_points(const std::vector<Vector3d>& points, double mass) {
  Vector3d centre = Vector3d::Zero();
  for (const Vector3d& p : points) centre += p / static_cast<double>(points.size());
  Matrix3d inertia = Matrix3d::Zero();
  for (const Vector3d& p : points)
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        const Vector3d a = Vector3d::Unit(i).cross(p - centre), b = Vector3d::Unit(k).cross(p - centre);
        inertia(i, k) += mass * a.dot(b);
      }
  return {mass * static_cast<double>(points.size()), centre, inertia};
}
Vector3d random_vector(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}
std::string fault(double mass, const Matrix3d& inertia, std::vector<Vector3d> turned_about = {}) {
  return inertia_fault({mass, Vector3d::Zero(), inertia}, turned_about).sentence;
}
std::string fault(double mass, const Vector3d& moments) { return fault(mass, Matrix3d(moments.asDiagonal())); }

// An arm that a geared motor turns, hanging on nothing else.
class Arm : public Mechanism<1> {
 public:
  static constexpr const char *name = "arm", *title = "an arm", *source = "a test";
  static constexpr double about_centre[] = {0.02, 0.02, 0.001, 0, 0, 0};
  static constexpr Parameter parameters[] = {
      Parameter::length("reach", 0.4, "of the arm"), Parameter::mass("upper_arm_mass", 2, "of the arm", {-10, 10}),
      Parameter::numbers("upper_arm_inertia", about_centre, {-10, 10}, 6, 6, "kg*m^2", "kg*m^2", "of the arm"),
      Parameter::inertia("rotor", 0, "of the motor, felt at the arm"),
      Parameter::inertia("twist", 0, "an inertia that belongs to nothing")};
  explicit Arm(const Parameters& p) : inertia_(Inertia::central(p["upper_arm_mass"], p.numbers("upper_arm_inertia"))) {
    inertia_.about_centre(1, 1) += p["rotor"];
    inertia_.about_centre(2, 2) += p["twist"];
  }
  Topology topology() const {
    Topology t;
    t.coordinates = {{"theta", "angle", "rad", 0.3, {0, 1}}};
    t.platform = t.add(Body{"upper arm 1", 0, false, inertia_});
    t.add(Joint{"R", JointKind::revolute, 0, 1, {}});
    t.add(Actuator{"q", "angle", "rad", 0, {-1, 1}});
    for (const char* n : {"fx", "fy", "fz"}) t.constraints.push_back({n, "", "N"});
    for (const char* n : {"mx", "mz"}) t.constraints.push_back({n, "", "N*m"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> o = Vector3d::Zero().cast<T>();
    at.body(1, o, rotation_y(q[0]));
    at.joint(0, o, Vector3d::UnitY().cast<T>());
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    couple_row<T>(g, 0, Vector3d::UnitY().cast<T>());
    for (int k = 0; k < 3; ++k) g(1 + k, k) = T(1.0);
    couple_row<T>(g, 4, Vector3d::UnitX().cast<T>());
    couple_row<T>(g, 5, Vector3d::UnitZ().cast<T>());
    return g;
  }

 private:
  Inertia inertia_;
};

// What is said of an arm whose parameters are changed; "" when it is taken.
std::string said(const std::map<std::string, std::vector<double>>& changes, pm_status expected = PM_BAD_ARGUMENT) {
  const pm_mechanism& table = contract::mechanism<Arm>;
  const MechanismInfo info = describe(table);
  ParameterValues values = default_values(info);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const auto found = changes.find(info.parameters[i].name); found != changes.end()) values[i] = found->second;
  try {
    const Machine machine(table, values);
  } catch (const MechanismError& e) {
    CHECK(e.status == expected);
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("whatever mass points make has an inertia that is taken") {
  std::mt19937_64 random(1);
  for (int k = 0; k < 300; ++k) {
    std::vector<Vector3d> points;
    for (int i = 0; i < 2 + k % 5; ++i) points.push_back(random_vector(random));  // two make a rod, three a plate
    const Inertia body = of_points(points, 0.3);
    CAPTURE(k, body.about_centre);
    CHECK(inertia_fault(body).sentence.empty());
  }
}

TEST_CASE("rods, plates, mass points and bodies without mass are taken") {
  CHECK(fault(2, Vector3d(0.1, 0.1, 0)).empty());
  CHECK(fault(2, Vector3d(0.1, 0.2, 0.3)).empty());
  CHECK(fault(2, Vector3d(0.0333, 0.0333, 0.0667)).empty());  // a disc, its moments rounded to three digits
  CHECK(fault(2, Vector3d(0, 0, 0)).empty());
  CHECK(fault(0, Vector3d(0, 0, 0)).empty());
}

TEST_CASE("an inertia that no body has is told with its principal moments, whatever axes it is given in") {
  std::mt19937_64 random(2);
  for (int k = 0; k < 50; ++k) {
    const Matrix3d r = Eigen::AngleAxisd(random_vector(random).norm(), random_vector(random).normalized()).toRotationMatrix();
    const auto turned = [&](const Vector3d& moments) { return Matrix3d(r * moments.asDiagonal() * r.transpose()); };
    CHECK_THAT(fault(2, turned({0.1, 0.2, 0.31})),
               StartsWith("the principal moments of its inertia are 0.1, 0.2 and 0.31 kg m^2, and the largest cannot exceed"));
    CHECK_THAT(fault(2, turned({-0.1, 0.2, 0.2})),
               StartsWith("the principal moments of its inertia are -0.1, 0.2 and 0.2 kg m^2, and none can be negative"));
    CHECK_THAT(fault(0, turned({0.1, 0.1, 0.1})), Contains("but its mass is 0"));
  }
}

TEST_CASE("masses below zero, numbers that are none and matrices that are not symmetric are told") {
  CHECK(fault(-1, Vector3d(0.1, 0.1, 0.1)) == "its mass is -1 kg");
  CHECK(fault(std::nan(""), Vector3d(0.1, 0.1, 0.1)) == "its mass is not a finite number");
  CHECK(fault(1, Vector3d(0.1, std::nan(""), 0.1)) == "its inertia is not finite");
  CHECK(inertia_fault({1, {0, std::nan(""), 0}, Matrix3d::Zero()}).sentence == "its centre of mass is not finite");
  Matrix3d skew = Vector3d(0.1, 0.1, 0.1).asDiagonal();
  skew(0, 1) = 0.01;
  CHECK_THAT(fault(1, skew), StartsWith("its inertia is not symmetric"));
}

TEST_CASE("the rotor of a geared motor may be felt about the axis that it turns, and about no other") {
  const Matrix3d rod = Vector3d(0.02, 0.02, 0).asDiagonal();
  const Vector3d axis = Vector3d(1, 2, 0).normalized(), other = Vector3d(2, -1, 0).normalized();
  const Matrix3d felt = 5 * axis * axis.transpose(), arm = rod + felt;
  CHECK_FALSE(fault(1, arm).empty());
  CHECK(fault(1, arm, {axis}).empty());
  CHECK(fault(1, arm, {other, axis}).empty());
  CHECK_FALSE(fault(1, arm, {other}).empty());
  CHECK(fault(0, felt, {axis}).empty());  // a motor on an arm without mass
  CHECK_FALSE(fault(0, felt, {other}).empty());
  CHECK_FALSE(fault(0, arm, {axis}).empty());
  CHECK_FALSE(fault(1, Matrix3d(rod - 0.1 * axis * axis.transpose()), {axis}).empty());
}

TEST_CASE("the parameter that brought an impossible body is named") {
  CHECK(said({}).empty());
  CHECK(said({{"rotor", {3}}, {"reach", {0.5}}}).empty());
  CHECK(said({{"upper_arm_mass", {0}}, {"upper_arm_inertia", std::vector<double>(6, 0.0)}, {"rotor", {3}}}).empty());
  CHECK_THAT(
      said({{"reach", {0.5}}, {"upper_arm_mass", {1}}, {"upper_arm_inertia", {0.02, 0.02, 0.001, 0.1, 0, 0}}}),
      StartsWith("upper_arm_inertia gives body upper arm 1 what no body can have: the principal moments of its inertia are -0.08, "));
  CHECK_THAT(said({{"upper_arm_mass", {-2}}, {"upper_arm_inertia", {0.02, 0.02, 0.002, 0, 0, 0}}}),
             StartsWith("upper_arm_mass gives body upper arm 1 what no body can have: its mass is -2 kg"));
  CHECK_THAT(said({{"upper_arm_mass", {0}}}), StartsWith("upper_arm_mass gives ") && Contains("but its mass is 0"));
  // Not named after the body, but changed: nothing of the body's own is.
  CHECK_THAT(said({{"reach", {0.5}}, {"twist", {0.1}}}), StartsWith("upper_arm_inertia gives ") && Contains("the largest cannot exceed"));
}
