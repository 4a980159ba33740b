// A mechanism whose geometry is solved by Newton's method, as README.md shows it, against the law of cosines and the property suite.
#include <core/mechanics/conformance/properties.hpp>
#include <pmreport/mechanism.hpp>

#include <catch2/catch.hpp>

#include <fstream>
#include <random>

using namespace pmreport;
using Eigen::Vector3d;

namespace {

// A slider-crank: crank AB, rod BC, a slider on the X axis at C that carries the load.
class SliderCrank : public Mechanism<1> {
 public:
  static constexpr const char *name = "slider-crank", *title = "a slider-crank", *source = "README.md";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit SliderCrank(const Parameters&) {}

  Topology topology() const {
    Topology t;
    const double home = crank_ * std::cos(home_theta_) + std::sqrt(square(rod_) - square(crank_ * std::sin(home_theta_)));
    t.coordinates = {{"x", "place of the slider", "m", home, {home - 0.03, home + 0.03}}};
    t.platform = t.add(Body{"slider", 0, false, Inertia::central(1, std::array<double, 6>{1e-3, 1e-3, 1e-3, 0, 0, 0})});
    t.add(Body{"crank", 1, false, {}});
    t.add(Body{"rod", 1, false, {}});
    t.add(Joint{"A", JointKind::revolute, 0, 2, {}});
    t.add(Joint{"B", JointKind::revolute, 2, 3, {}});
    t.add(Joint{"C", JointKind::revolute, 3, 1, {}});
    t.add(Joint{"P", JointKind::prismatic, 0, 1, {}});
    t.add(Actuator{"theta", "angle of the crank", "rad", 0, {-3, 3}});
    t.constraints = {{"fy", "", "N"}, {"fz", "", "N"}, {"mx", "", "N*m"}, {"my", "", "N*m"}, {"mz", "", "N*m"}};
    return t;
  }

  // The rod has its length, f = |C - B|^2 - l^2 = 0, with B = r (cos theta, sin theta, 0) and C = (x, 0, 0):
  //     theta <- theta - f / f',   f' = -2 (C - B) . B'
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> a(T(0.0), T(0.0), T(0.0)), c(q[0], T(0.0), T(0.0)), x = Vector3d::UnitX().cast<T>(), z = Vector3d::UnitZ().cast<T>();
    T theta(home_theta_), f(0.0);  // from home, which chooses the branch
    Vector3<T> b;
    for (int step = 0; step < 8; ++step) {  // six to the last digit from anywhere in the box, two for rates and accelerations
      b = Vector3<T>(crank_ * cos(theta), crank_ * sin(theta), T(0.0));
      const Vector3<T> rod = c - b;
      f = rod.dot(rod) - square(rod_);
      theta -= f / (-2.0 * rod.dot(z.cross(b)));
    }
    at.require(choose(abs(f) < 1e-9 * square(rod_), T(1.0), T(-1.0)), "the rod does not reach from the crank to the slider");
    at.body(slider, c, Matrix3<T>(Matrix3<T>::Identity()));
    at.body(crank, a, frame_xz(unit(b), z));
    at.body(rod, b, frame_xz(unit<T>(c - b), z));
    at.joint(0, a, z);
    at.joint(1, b, z);
    at.joint(2, c, z);
    at.joint(3, c - 0.1 * Vector3d::UnitY(), x);  // its guide lies below
    at.actuator(0, theta);
  }

  // The rod pushes along itself, n; on the crank with the lever n . (z x B).
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    const Vector3<T> b = at.centre(1), n = unit<T>(at.centre(2) - b);
    Matrix6<T> g = Matrix6<T>::Zero();
    force_row<T>(g, 0, n / n.dot(at.axis(0).cross(b)), Vector3<T>::Zero());
    for (int k = 1; k < 6; ++k) g(k, k) = T(1.0);
    return g;
  }

 private:
  static constexpr int slider = 1, crank = 2, rod = 3;
  static constexpr double crank_ = 0.1, rod_ = 0.3, home_theta_ = 1;
};

mechanics::Machine slider_crank() {
  const pm_mechanism& table = contract::mechanism<SliderCrank>;
  return {table, mechanics::default_values(mechanics::describe(table))};
}

std::string text_of(const char* file) {
  std::ifstream in(file, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a geometry that is solved by iteration has every property, derivatives and lanes included") {
  const auto properties = mechanics::check_properties(slider_crank(), {100, 1});
  REQUIRE(properties.size() > 10);
  for (const mechanics::Property& p : properties) {
    INFO(p.claim << ": " << p.worst << " of " << p.tolerance << "; " << p.where);
    CHECK(p.worst <= p.tolerance);
  }
}

TEST_CASE("the iteration finds the angle of the law of cosines") {
  const mechanics::Machine machine = slider_crank();
  const Range box = machine.topology().coordinates[0].box;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> within(box.min, box.max);
  for (int i = 0; i < 100; ++i) {
    const double x = within(random), angle = std::acos((0.1 * 0.1 + x * x - 0.3 * 0.3) / (2 * 0.1 * x));
    CAPTURE(x);
    const mechanics::Pose pose = machine.pose(std::array{x});
    REQUIRE(pose.status == PM_OK);
    CHECK(std::abs(pose.numbers[machine.layout().actuator(0)] - angle) < 1e-13);
  }
}

TEST_CASE("where the iteration finds nothing the pose is out of reach, and says why") {
  const mechanics::Machine machine = slider_crank();
  for (const double x : {0.1 + 0.3 + 1e-3, 0.5, 0.1, 0.0}) {  // beyond crank and rod stretched, and folded
    CAPTURE(x);
    const mechanics::Pose pose = machine.pose(std::array{x});
    CHECK(pose.status == PM_UNREACHABLE);
    CHECK(pose.why == "the rod does not reach from the crank to the slider");
  }
}

TEST_CASE("the iteration stands in README.md as it is tested here") {
  const std::string readme = text_of(SOURCE "/README.md"), source = text_of(__FILE__);
  const auto begin = source.find("  // The rod has its length"), end = source.find("    at.body(slider");
  REQUIRE(begin < end);
  CHECK(readme.find(source.substr(begin, end - begin)) != std::string::npos);
}
