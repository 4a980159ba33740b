#include <algorithm>
#include <catch2/catch.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <limits>
#include <pmreport/mechanism.hpp>
#include <reports/scene/look.hpp>

using namespace pmreport;
using Eigen::Vector3d;
using scene::Solid;

namespace {

// A platform over its base on one telescopic limb: enough to have a size.
class Stool : public Mechanism<1> {
 public:
  static constexpr const char *name = "stool", *title = "stool", *source = "this test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Stool(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates.push_back({"z", "height", "m", 0.5, {0.4, 0.6}});
    t.platform = t.add(Body{"platform", 0, false, {}});
    t.add(Body{"cylinder", 1, true, {}});
    t.add(Body{"piston", 1, true, {}});
    t.add(Joint{"A", JointKind::spherical, 0, 2, {}});
    t.add(Joint{"P", JointKind::prismatic, 2, 3, {}});
    t.add(Joint{"B", JointKind::spherical, 3, 1, {}});
    t.add(Actuator{"l", "length", "m", 1, {0, 1}});
    for (const char* n : {"c1", "c2", "c3", "c4", "c5"}) t.constraints.push_back({n, "", "N"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> up = Vector3d::UnitZ().cast<T>(), foot = Vector3d(0.3, 0.2, 0).cast<T>(), p = up * q[0];
    at.body(1, p, Matrix3<T>(Matrix3<T>::Identity()));
    at.slender(2, foot, up), at.slender(3, p + foot, up);
    at.joint(0, foot), at.joint(1, p + foot, up), at.joint(2, p + foot);
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Matrix6<T>(Matrix6<T>::Identity());
  }
};

const scene::Color pink{0.82F, 0.0F, 0.42F, 1.0F};

std::vector<Solid> drawn(const scene::Screw& screw, std::vector<scene::Label>* labels = nullptr) {
  static const mechanics::Machine machine(contract::mechanism<Stool>, {});
  scene::Extras extras;
  extras.screws = {screw};
  const scene::Scene s = scene::build(machine, machine.home_pose(), extras);
  if (labels != nullptr) *labels = s.labels;
  std::vector<Solid> out;
  for (const Solid& x : s.solids)
    if (x.color.r == pink.r && x.color.g == pink.g && x.color.b == pink.b) out.push_back(x);
  return out;
}

std::vector<Solid> cones(const std::vector<Solid>& solids) {
  std::vector<Solid> out;
  for (const Solid& s : solids)
    if (s.kind == Solid::Kind::cone) out.push_back(s);
  return out;
}

}  // namespace

TEST_CASE("a screw is drawn as a long line on its axis with its label at the end") {
  const Vector3d through(0.1, -0.2, 0.4), along = Vector3d(1, 2, 0.5).normalized();
  std::vector<scene::Label> labels;
  const std::vector<Solid> solids = drawn({through, along, 0, "$", pink}, &labels);
  double longest = 0;
  Solid axis{};
  for (const Solid& s : solids)
    if (s.kind == Solid::Kind::cylinder && (s.b - s.a).norm() > longest) longest = (s.b - s.a).norm(), axis = s;
  CHECK(longest > 0.3);  // the machine is 0.5 m tall
  for (const Vector3d& end : {axis.a, axis.b}) CHECK((end - through).cross(along).norm() < 1e-12);
  CHECK(axis.through > 0.5F);  // it is seen behind the platform
  const auto label = std::find_if(labels.begin(), labels.end(), [](const auto& l) { return l.text == "$"; });
  REQUIRE(label != labels.end());
  CHECK((label->at - through).cross(along).norm() < 1e-12);
}

TEST_CASE("pitch zero turns about the axis, pitch infinite runs along it, any other does both with its hand") {
  const Vector3d through(0, 0, 0.5), up = Vector3d::UnitZ();
  const auto turning = cones(drawn({through, up, 0, "$", pink}));
  REQUIRE(turning.size() == 1);
  CHECK(std::abs((turning[0].b - turning[0].a).normalized().dot(up)) < 0.1);  // its arrow runs around
  const auto running = cones(drawn({through, up, std::numeric_limits<double>::infinity(), "$", pink}));
  REQUIRE(running.size() == 1);
  CHECK((running[0].b - running[0].a).normalized().dot(up) > 0.999);
  for (const double pitch : {0.05, -0.05}) {
    const auto both = cones(drawn({through, up, pitch, "$", pink}));
    REQUIRE(both.size() == 2);
    double along = 0, around = 0;
    for (const Solid& c : both) {
      const Vector3d d = (c.b - c.a).normalized();
      if (std::abs(d.z()) > 0.9)
        along = d.z();
      else
        around = (c.a - through).cross(d).z();  // right-handed about +Z when positive
    }
    CHECK(along * around * pitch > 0);
  }
}

TEST_CASE("a far axis is an arrow towards it with the distance, and the motion of the platform an arrow along it") {
  const Vector3d platform(0, 0, 0.5), foot = platform + Vector3d(4, 0, 0);
  std::vector<scene::Label> labels;
  const scene::Screw far{foot + Vector3d(0, 0, 7), Vector3d::UnitZ(), 0, "$", pink};
  const auto arrows = cones(drawn(far, &labels));
  REQUIRE(arrows.size() == 2);
  const auto points = [&](const Vector3d& d) {
    return std::ranges::any_of(arrows, [&](const Solid& c) { return (c.b - c.a).normalized().isApprox(d, 1e-9); });
  };
  CHECK(points(Vector3d::UnitX()));
  CHECK(points(-Vector3d::UnitY()));  // a turn about +Z at x = 4 m takes what is at x = 0 along -Y
  CHECK(std::ranges::any_of(labels, [](const auto& l) { return l.text == "axis 4 m away"; }));

  static const mechanics::Machine machine(contract::mechanism<Stool>, {});
  scene::Bounds bounds;
  scene::include(bounds, machine, machine.home_pose());
  const double before = (bounds.high - bounds.low).norm();
  scene::include(bounds, machine, machine.home_pose(), far);
  CHECK((bounds.high - bounds.low).norm() < 2 * before);
}

TEST_CASE("a screw adds one label and leaves those of the joints") {
  std::vector<scene::Label> labels;
  drawn({Vector3d::Zero(), Vector3d::UnitX(), 0, "$", pink}, &labels);
  CHECK(std::count_if(labels.begin(), labels.end(), [](const auto& l) { return l.text == "$"; }) == 1);
  CHECK(std::count_if(labels.begin(), labels.end(), [](const auto& l) { return l.text == "A" || l.text == "B"; }) == 2);
}
