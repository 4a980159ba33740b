#include <algorithm>
#include <catch2/catch.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <map>
#include <pmreport/mechanism.hpp>
#include <reports/scene/diagram/diagram.hpp>
#include <set>

using namespace pmreport;
using Eigen::Vector3d;
using scene::Solid;

namespace {

// Three limbs that each have a telescope on a joint of another kind, below a triangular platform; the first one is driven.
class Tripod : public Mechanism<1> {
 public:
  static constexpr const char *name = "tripod", *title = "tripod", *source = "this test";
  static constexpr Parameter parameters[] = {Parameter::number("scale", 1, {1e-3, 1e3}, "", "", "size")};
  explicit Tripod(const Parameters& p) : s_(p["scale"]) {}

  Topology topology() const {
    Topology t;
    t.coordinates.push_back({"z", "height", "m", s_, {0.9 * s_, 1.1 * s_}});
    t.platform = t.add(Body{"platform", 0, false, {}});
    constexpr JointKind feet[] = {JointKind::universal, JointKind::revolute, JointKind::cylindrical};
    for (int k = 0; k < 3; ++k) {
      const std::string n = std::to_string(k + 1);
      const int tube = t.add(Body{"tube" + n, k + 1, true, {}}), rod = t.add(Body{"rod" + n, k + 1, true, {}});
      t.add(Joint{"A" + n, feet[k], 0, tube, {}});
      t.add(Joint{"P" + n, JointKind::prismatic, tube, rod, {}});
      t.add(Joint{"B" + n, JointKind::spherical, rod, 1, {}});
    }
    t.add(Actuator{"l", "length", "m", 1, {0, 2 * s_}});
    for (int k = 0; k < 5; ++k) t.constraints.push_back({"c" + std::to_string(k), "", "N"});
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> up = Vector3d(0, 0, 1).cast<T>(), x = Vector3d(1, 0, 0).cast<T>(), y = Vector3d(0, 1, 0).cast<T>();
    const Vector3<T> p = up * q[0];
    const Matrix3<T> upright = Eigen::Matrix3d::Identity().cast<T>();
    at.body(1, p, upright);
    for (int k = 0; k < 3; ++k) {
      const Vector3<T> foot = foot_of(k).cast<T>();
      at.slender(2 * k + 2, foot, up), at.slender(2 * k + 3, foot + p, up);
      k == 0 ? at.joint(3 * k, foot, x, y) : at.joint(3 * k, foot, y);
      at.joint(3 * k + 1, foot + p, up), at.joint(3 * k + 2, foot + p);
    }
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Eigen::Matrix<double, 6, 6>::Identity().template cast<T>();
  }

 private:
  Vector3d foot_of(int k) const { return s_ * Vector3d(std::cos(2.1 * k), std::sin(2.1 * k), 0); }
  double s_;
};

const scene::Quality quality{1600, 1200, false, 2, 140};
scene::Diagram diagram_of(double scale) {
  static std::map<double, std::unique_ptr<mechanics::Machine>> machines;
  auto& m = machines[scale];
  if (!m) m = std::make_unique<mechanics::Machine>(contract::mechanism<Tripod>, mechanics::ParameterValues{{scale}});
  return scene::diagram(*m, {"λ1"}, 0.6, 0.5, quality);
}
std::vector<Solid> of_kind(const scene::Scene& s, Solid::Kind kind) {
  std::vector<Solid> out;
  for (const Solid& x : s.solids)
    if (x.kind == kind) out.push_back(x);
  return out;
}

}  // namespace

TEST_CASE("a diagram has a symbol for every joint, at its place") {
  const scene::Scene s = diagram_of(1).scene;
  CHECK(of_kind(s, Solid::Kind::ball).size() == 3);
  CHECK(of_kind(s, Solid::Kind::cylinder).size() == 2 + 1 + 1);  // two bars of the cross, the hinge, the sleeve
  CHECK(of_kind(s, Solid::Kind::plate).size() == 2);             // base and platform
  const std::vector<Solid> slides = of_kind(s, Solid::Kind::box);
  REQUIRE(slides.size() == 3);
  for (const Solid& box : slides) {  // halfway up the limb
    CHECK(box.a.z() == Approx(0.5));
    CHECK(box.a.head<2>().norm() == Approx(1));
  }
}

TEST_CASE("driven joints are grey, the others white") {
  int driven = 0, others = 0;
  for (const Solid& box : of_kind(diagram_of(1).scene, Solid::Kind::box)) ++(box.color.r < 0.9f ? driven : others);
  CHECK(driven == 1);
  CHECK(others == 2);
  for (const Solid& ball : of_kind(diagram_of(1).scene, Solid::Kind::ball)) CHECK(ball.color.r == 1);
}

TEST_CASE("a diagram names joints, drives, frames and axes") {
  std::multiset<std::string> names;
  for (const scene::Label& l : diagram_of(1).scene.labels) names.insert(l.text);
  CHECK((names ==
         std::multiset<std::string>{"A1", "A2", "A3", "B1", "B2", "B3", "λ1", "s1", "s2", "s3", "O", "X", "Y", "Z", "o", "x", "y", "z"}));
}

TEST_CASE("a diagram looks alike at every size of the machine") {
  const scene::Diagram small = diagram_of(1), large = diagram_of(100);
  REQUIRE(small.scene.lines.size() == large.scene.lines.size());
  REQUIRE(small.scene.solids.size() == large.scene.solids.size());
  CHECK(large.camera.height == Approx(100 * small.camera.height));
  for (std::size_t k = 0; k < small.scene.lines.size(); ++k) CHECK(small.scene.lines[k].width == large.scene.lines[k].width);
}

TEST_CASE("the legend tells the symbols that occur, and no others") {
  const mechanics::Machine m(contract::mechanism<Tripod>, mechanics::ParameterValues{{1}});
  CHECK(
      scene::legend(m) ==
      "balls are spherical joints, cylinders revolute ones, long cylinders cylindrical ones, crosses universal ones, boxes prismatic ones; "
      "grey joints are driven, dash-dot lines are axes, dashed lines are hidden");
}
