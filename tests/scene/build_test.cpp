#include <algorithm>
#include <catch2/catch.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <pmreport/mechanism.hpp>
#include <reports/figure/palette.hpp>
#include <reports/scene/look.hpp>
#include <set>

using namespace pmreport;
using Eigen::Vector3d;
using scene::Solid;

namespace {

// A platform that goes up and down on one limb of every sort: universal, telescope, ball; slide on the base, hinge, link, ball; and a
// limb whose parts declare shapes, with a sleeve at its foot. Only what is drawn of it matters here.
class Rig : public Mechanism<1> {
 public:
  static constexpr const char *name = "rig", *title = "rig", *source = "this test";
  static constexpr Parameter parameters[] = {Parameter::number("scale", 1, {1e-3, 1e3}, "", "", "size")};
  explicit Rig(const Parameters& p) : s_(p["scale"]) {}

  Topology topology() const {
    Topology t;
    t.coordinates.push_back({"z", "height", "m", 0.5 * s_, {0.45 * s_, 0.55 * s_}});
    t.platform = t.add(Body{"platform", 0, false, {}});
    for (const char* n : {"cylinder", "piston"}) t.add(Body{n, 1, true, {}});
    for (const char* n : {"slider", "link"}) t.add(Body{n, 2, false, {}});
    t.add(Body{"post", 3, true, {}});
    t.add(Joint{"A1", JointKind::universal, 0, 2, {}});
    t.add(Joint{"P1", JointKind::prismatic, 2, 3, {}});
    t.add(Joint{"B1", JointKind::spherical, 3, 1, {}});
    t.add(Joint{"P2", JointKind::prismatic, 0, 4, {{-0.1 * s_, 0.1 * s_}}});
    t.add(Joint{"A2", JointKind::revolute, 4, 5, {}});
    t.add(Joint{"B2", JointKind::spherical, 5, 1, {}});
    t.add(Joint{"A3", JointKind::cylindrical, 0, 6, {}});
    t.add(Joint{"B3", JointKind::spherical, 6, 1, {}});
    t.add(Actuator{"l", "length", "m", 1, {0, s_}});
    t.shapes.push_back({6, ShapeKind::cylinder, {0, 0, -0.4 * s_}, {0, 0, 0}, 0.02 * s_});
    for (int k = 0; k < 5; ++k) t.constraints.push_back({"c" + std::to_string(k), "", "N"});
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const auto point = [&](double x, double y) { return Vector3d(s_ * x, s_ * y, 0).cast<T>().eval(); };
    const Vector3<T> up = Vector3d(0, 0, 1).cast<T>(), x = Vector3d(1, 0, 0).cast<T>(), y = Vector3d(0, 1, 0).cast<T>();
    const Vector3<T> p = up * q[0];
    const Matrix3<T> upright = Eigen::Matrix3d::Identity().cast<T>();
    at.body(1, p, upright);
    at.slender(2, point(0.3, 0), up), at.slender(3, p + point(0.3, 0), up);
    at.body(4, point(-0.3, 0.3), upright), at.body(5, point(-0.3, 0.3), upright);
    at.slender(6, p + point(-0.3, -0.3), up);
    at.joint(0, point(0.3, 0), x, y), at.joint(1, p + point(0.3, 0), up), at.joint(2, p + point(0.3, 0));
    at.joint(3, point(-0.3, 0.3), x), at.joint(4, point(-0.3, 0.3), y), at.joint(5, p + point(-0.3, 0.3));
    at.joint(6, point(-0.3, -0.3), up), at.joint(7, p + point(-0.3, -0.3));
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Eigen::Matrix<double, 6, 6>::Identity().template cast<T>();
  }

 private:
  double s_;
};

const mechanics::Machine& rig(double scale) {
  static const mechanics::Machine one(contract::mechanism<Rig>, {{1}}), hundred(contract::mechanism<Rig>, {{100}});
  return scale == 1 ? one : hundred;
}
bool has_color(const Solid& s, const scene::Color& c) { return s.color.r == c.r && s.color.g == c.g && s.color.b == c.b; }
std::vector<Solid> of_color(const scene::Scene& s, const scene::Color& c) {
  std::vector<Solid> all;
  for (const Solid& x : s.solids)
    if (has_color(x, c)) all.push_back(x);
  return all;
}
Solid plate_of(const std::vector<Solid>& solids) {
  const auto it = std::find_if(solids.begin(), solids.end(), [](const Solid& s) { return s.kind == Solid::Kind::plate; });
  REQUIRE(it != solids.end());
  return *it;
}

}  // namespace

TEST_CASE("every joint but a slide has its name beside it, and the frames have theirs") {
  const auto& m = rig(1);
  const scene::Scene s = scene::build(m, m.home_pose(), {});
  std::multiset<std::string> names;
  for (const auto& l : s.labels) names.insert(l.text);
  CHECK((names == std::multiset<std::string>{"A1", "B1", "A2", "B2", "A3", "B3", "O", "X", "Y", "Z", "o", "x", "y", "z", "l"}));
  scene::Extras without;
  without.joint_names = false;
  without.drives = {"λ"};
  names.clear();
  for (const auto& l : scene::build(m, m.home_pose(), without).labels) names.insert(l.text);
  CHECK((names == std::multiset<std::string>{"O", "X", "Y", "Z", "o", "x", "y", "z", "λ"}));
  scene::Extras bare;
  bare.labels = bare.frames = false;
  CHECK(scene::build(m, m.home_pose(), bare).labels.empty());
}

TEST_CASE("what an actuator moves has the colour that plots give its curves, most of it where it moves, and its name beside it") {
  const auto& m = rig(1);
  const scene::Scene s = scene::build(m, m.home_pose(), {});
  const figure::Colour curve = figure::line_style(0).colour;
  const auto from_curve = [&](const scene::Color& c) {
    return std::max({std::abs(c.r - curve.red), std::abs(c.g - curve.green), std::abs(c.b - curve.blue)});
  };
  double piston = 1, cylinder = 1;
  Vector3d middle;
  for (const Solid& x : s.solids) {
    if (x.kind != Solid::Kind::cylinder) continue;  // the ball
    if (x.body == 3) piston = from_curve(x.color), middle = (x.a + x.b) / 2;
    if (x.body == 2 && !has_color(x, scene::palette::universal)) cylinder = from_curve(x.color);
  }
  CHECK(piston < 0.2);
  CHECK(cylinder < from_curve(scene::palette::tube));
  CHECK(piston < cylinder);
  // The limbs that no actuator moves are grey.
  CHECK(std::ranges::any_of(s.solids, [](const Solid& x) { return x.body == 6 && has_color(x, scene::palette::tube); }));
  CHECK(std::ranges::any_of(s.solids, [](const Solid& x) { return x.body == 5 && has_color(x, scene::palette::rod); }));

  const auto name = std::ranges::find_if(s.labels, [](const scene::Label& l) { return l.text == "l"; });
  REQUIRE(name != s.labels.end());
  CHECK(from_curve(name->color) < 1e-6);
  CHECK(name->at.isApprox(middle));
  CHECK(name->clear > 0);
}

TEST_CASE("of two actuators in one limb each colours its own part, and a limb of one actuator belongs to it altogether") {
  Topology t;
  t.platform = t.add(Body{"platform", 0, false, {}});
  const int slider = t.add(Body{"slider", 1, false, {}}), tube = t.add(Body{"tube", 1, false, {}}), rod = t.add(Body{"rod", 1, false, {}});
  const int arm = t.add(Body{"arm", 2, false, {}}), link = t.add(Body{"link", 2, false, {}});
  t.add(Joint{"P1", JointKind::prismatic, 0, slider, {}});
  t.add(Joint{"P2", JointKind::prismatic, tube, rod, {}});
  t.add(Joint{"A", JointKind::revolute, arm, 0, {}});
  for (const int joint : {0, 1, 2}) t.add(Actuator{"q" + std::to_string(joint + 1), "", "m", joint, {0, 1}});
  const std::vector<scene::Drive> drives = scene::drives_of_bodies(t);
  const auto is = [&](int body, int actuator, bool driven) {
    const scene::Drive& d = drives[static_cast<std::size_t>(body)];
    return d.actuator == actuator && d.driven == driven;
  };
  CHECK(is(0, -1, false));
  CHECK(is(t.platform, -1, false));
  CHECK(is(slider, 0, true));
  CHECK(is(tube, 1, false));
  CHECK(is(rod, 1, true));
  CHECK(is(arm, 2, true));
  CHECK(is(link, 2, false));
}

TEST_CASE("each kind of joint is drawn by its symbol, at its centre, along its axes") {
  const auto& m = rig(1);
  const scene::Scene s = scene::build(m, m.home_pose(), {});
  const auto balls = of_color(s, scene::palette::spherical);
  REQUIRE(balls.size() == 3);
  CHECK(balls[0].a.isApprox(Vector3d(0.3, 0, 0.5)));

  const auto hinge = of_color(s, scene::palette::revolute).front();
  CHECK(((hinge.a + hinge.b) / 2).isApprox(Vector3d(-0.3, 0.3, 0)));
  CHECK((hinge.b - hinge.a).normalized().isApprox(Vector3d(0, 1, 0)));

  std::set<int> arms;
  for (const Solid& arm : of_color(s, scene::palette::universal))
    for (int k = 0; k < 3; ++k)
      if (std::abs((arm.b - arm.a).normalized()(k)) > 0.999) arms.insert(k);
  CHECK((arms == std::set<int>{0, 1}));

  const auto sleeve = of_color(s, scene::palette::cylindrical);
  REQUIRE(sleeve.size() == 1);
  CHECK((sleeve[0].b - sleeve[0].a).normalized().isApprox(Vector3d(0, 0, 1)));
}

TEST_CASE("a joint's ball shows beside the thickest limb that ends in it") {
  const auto& m = rig(1);
  const auto balls = of_color(scene::build(m, m.home_pose(), {}), scene::palette::spherical);
  for (const Solid& b : balls)
    if (b.a.isApprox(Vector3d(-0.3, -0.3, 0.5))) CHECK(b.radius > 0.02 * 1.1);
}

TEST_CASE("a machine a hundred times as large looks the same") {
  const auto &small = rig(1), &large = rig(100);
  scene::Extras load;
  load.force = {0, 0, -1}, load.moment = {0, 1, 0};
  const scene::Scene a = scene::build(small, small.home_pose(), load), b = scene::build(large, large.home_pose(), load);
  REQUIRE(a.solids.size() == b.solids.size());
  constexpr double tolerance = 1e-9;  // [m] at size 1: a few hundred roundings
  for (std::size_t k = 0; k < a.solids.size(); ++k) {
    CAPTURE(k);
    CHECK((a.solids[k].a - b.solids[k].a / 100).norm() < tolerance);
    CHECK((a.solids[k].b - b.solids[k].b / 100).norm() < tolerance);
    CHECK(std::abs(a.solids[k].radius - b.solids[k].radius / 100) < tolerance);
  }
  CHECK(a.grid == Approx(b.grid / 100));
  CHECK(a.ground == Approx(b.ground / 100));
}

TEST_CASE("the platform's plate moves with the platform, the base's stays") {
  const auto& m = rig(1);
  const double z = 0.53;
  const scene::Scene home = scene::build(m, m.home_pose(), {}), up = scene::build(m, m.pose({&z, 1}), {});
  const auto at = [](const scene::Scene& s, const scene::Color& c) { return plate_of(of_color(s, c)).outline; };
  const auto before = at(home, scene::palette::platform), after = at(up, scene::palette::platform);
  REQUIRE(before.size() == after.size());
  for (std::size_t k = 0; k < before.size(); ++k) CHECK((after[k] - before[k] - Vector3d(0, 0, 0.03)).norm() < 1e-12);
  const auto base = at(home, scene::palette::base);
  CHECK((base == at(up, scene::palette::base)));
}

TEST_CASE("plates stand outside the limbs, with the ground under them") {
  const auto& m = rig(1);
  const scene::Scene s = scene::build(m, m.home_pose(), {});
  for (const auto& p : plate_of(of_color(s, scene::palette::base)).outline) CHECK(p.z() < 0);
  for (const auto& p : plate_of(of_color(s, scene::palette::platform)).outline) CHECK(p.z() > 0.5);
  for (const Solid& x : s.solids)
    if (x.kind == Solid::Kind::plate) CHECK(x.outline.front().z() - x.radius / 2 >= s.ground - 1e-12);
}

TEST_CASE("a force that pushes ends at the reference point, one that pulls begins there") {
  const auto& m = rig(1);
  const Vector3d p(0, 0, 0.5);
  for (const double sign : {-1.0, 1.0}) {
    CAPTURE(sign);
    scene::Extras load;
    load.force = {0, 0, sign * 40};
    const scene::Scene s = scene::build(m, m.home_pose(), load);
    const auto arrow = of_color(s, scene::palette::load);
    REQUIRE(arrow.size() == 2);
    const Solid &shaft = arrow[0], &head = arrow[1];
    REQUIRE(head.kind == Solid::Kind::cone);
    CHECK((head.b - head.a).normalized().isApprox(Vector3d(0, 0, sign)));
    CHECK((sign < 0 ? head.b : shaft.a).isApprox(p));
    CHECK(std::max(head.b.z(), shaft.a.z()) > 0.5);
  }
}

TEST_CASE("arrows of force are to scale where the full force is told") {
  const auto& m = rig(1);
  const auto length = [&](double force, double full) {
    scene::Extras load;
    load.force = {0, 0, force};
    load.full_force = full;
    const auto arrow = of_color(scene::build(m, m.home_pose(), load), scene::palette::load);
    return (arrow[1].b - arrow[0].a).norm();
  };
  const double longest = scene::longest_force * scene::overall_size(m);
  CHECK(length(40, 0) == Approx(longest));
  CHECK(length(40, 40) == Approx(longest));
  CHECK(length(10, 40) == Approx(longest / 4));
}

TEST_CASE("forces in joints begin at their centres, to the scale of the load, and one without a name has no label") {
  const auto& m = rig(1);
  scene::Extras extras;
  extras.full_force = 40;
  extras.joint_forces = {{1, {0, 20, 0}, "one 20 N"}, {0, {0, 0, 0}, "zero"}, {2, {-10, 0, 0}, ""}};
  const scene::Scene s = scene::build(m, m.home_pose(), extras);
  const auto arrows = of_color(s, scene::palette::reaction);
  REQUIRE(arrows.size() == 4);  // shaft and head of two
  const double longest = scene::longest_force * scene::overall_size(m);
  CHECK(arrows[0].a.isApprox(m.centre(m.home_pose(), 1)));
  CHECK((arrows[1].b - arrows[0].a).isApprox(Vector3d(0, longest / 2, 0)));
  CHECK(arrows[2].a.isApprox(m.centre(m.home_pose(), 2)));
  CHECK((arrows[3].b - arrows[2].a).isApprox(Vector3d(-longest / 4, 0, 0)));
  std::multiset<std::string> names;
  for (const scene::Label& l : s.labels) names.insert(l.text);
  CHECK(names.count("one 20 N") == 1);
  CHECK(names.count("zero") + names.count("") == 0);
}

TEST_CASE("a base that is seen through is a ghost with its rails, and nothing else is") {
  const auto& m = rig(1);
  scene::Extras extras;
  extras.base_opacity = 0.3f;
  for (const Solid& x : scene::build(m, m.home_pose(), extras).solids) {
    const bool of_base =
        x.body == 0 && (has_color(x, scene::palette::base) || has_color(x, scene::palette::post) || has_color(x, scene::palette::rod));
    CHECK(x.color.a == (of_base ? 0.3f : 1.0f));
  }
}

TEST_CASE("a moment turns by the right hand") {
  const auto& m = rig(1);
  scene::Extras load;
  load.moment = {0, 0, 2};
  const auto parts = of_color(scene::build(m, m.home_pose(), load), scene::palette::load);
  REQUIRE(parts.size() > 4);
  Vector3d centre = Vector3d::Zero();
  for (const Solid& s : parts) centre += s.a / double(parts.size());
  for (const Solid& s : parts) CHECK((s.a - centre).cross(s.b - s.a).z() > 0);
}

TEST_CASE("the frame of a motion holds every solid of every pose") {
  const auto& m = rig(1);
  scene::Bounds bounds;
  std::vector<scene::Scene> scenes;
  for (double z = 0.45; z <= 0.551; z += 0.01) {
    const mechanics::Pose pose = m.pose({&z, 1});
    scene::include(bounds, m, pose);
    scenes.push_back(scene::build(m, pose, {}));
  }
  for (const double elevation : {0.0, 0.47, 1.57}) {
    const scene::Camera camera = scene::frame(bounds, 0.6, elevation, 4.0 / 3);
    for (const auto& s : scenes)
      for (const Solid& x : s.solids)
        for (const Vector3d& p : {x.a, x.kind == Solid::Kind::box ? x.a : x.b}) {
          if (x.kind == Solid::Kind::plate || (x.kind == Solid::Kind::ball && p == x.b)) continue;
          const Eigen::Vector2d q = project(camera, p, 800, 600);
          CHECK((q.x() > 0.04 * 800 && q.x() < 0.96 * 800 && q.y() > 0.04 * 600 && q.y() < 0.96 * 600));
        }
  }
}
