// What a camera sees of a machine, from where it is looked at, and several poses in one picture.
#include <algorithm>
#include <catch2/catch.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <numbers>
#include <pmreport/mechanism.hpp>
#include <reports/scene/look.hpp>
#include <reports/scene/showing/choose_view.hpp>
#include <reports/scene/showing/overlay.hpp>
#include <reports/scene/showing/visible.hpp>

using namespace pmreport;
using Eigen::Vector3d;
using scene::Solid;

namespace {

constexpr double pi = std::numbers::pi, deg = pi / 180;

// A platform that goes up and down on three telescopes, and a wall of the base beside it: `wall` tells on which side, 0 nowhere, 1 towards
// the isometric camera, 2 all round; 3 a thin post towards a camera at `azimuth`.
// Where no telescope stands before the middle: they are at 0.3 and thirds of a turn from there.
constexpr double between_limbs = 0.3 + pi / 2 + 30 * deg;

Vector3d post_at(double azimuth) { return {0.6 * std::sin(azimuth), -0.6 * std::cos(azimuth), 0.5}; }

class Booth : public Mechanism<1> {
 public:
  static constexpr const char *name = "booth", *title = "booth", *source = "this test";
  static constexpr Parameter parameters[] = {
      Parameter::number("wall", 0, {0, 3}, "", "", "side"),
      Parameter::number("azimuth", 0, {-4, 4}, "rad", "deg", "of the camera that a post is towards")};
  explicit Booth(const Parameters& p) : wall_(p["wall"]), azimuth_(p["azimuth"]) {}

  Topology topology() const {
    Topology t;
    t.coordinates.push_back({"z", "height", "m", 0.5, {0.4, 0.6}});
    t.platform = t.add(Body{"platform", 0, false, {}});
    for (int i = 0; i < 3; ++i) {
      const std::string n = std::to_string(i + 1);
      const int cylinder = t.add(Body{"cylinder " + n, i + 1, true, {}}), piston = t.add(Body{"piston " + n, i + 1, true, {}});
      t.add(Joint{"A" + n, JointKind::spherical, 0, cylinder, {}});
      t.add(Joint{"P" + n, JointKind::prismatic, cylinder, piston, {}});
      t.add(Joint{"B" + n, JointKind::spherical, piston, t.platform, {}});
    }
    t.add(Actuator{"l", "length", "m", 1, {0, 1}});
    for (int k = 0; k < 5; ++k) t.constraints.push_back({"c" + std::to_string(k), "", "N"});
    t.shapes.push_back({0, ShapeKind::box, {0, 0, -0.02}, {0.5, 0.5, 0.02}, 0});
    const double far = 0.45;
    if (wall_ == 1) t.shapes.push_back({0, ShapeKind::box, {far, -far, 0.5}, {0.3, 0.3, 0.5}, 0});
    if (wall_ == 3) t.shapes.push_back({0, ShapeKind::box, post_at(azimuth_), {0.012, 0.012, 0.5}, 0});
    if (wall_ == 2)
      for (const double side : {-1.0, 1.0}) {
        t.shapes.push_back({0, ShapeKind::box, {side * far, 0, 0.5}, {0.02, far, 0.5}, 0});
        t.shapes.push_back({0, ShapeKind::box, {0, side * far, 0.5}, {far, 0.02, 0.5}, 0});
      }
    return t;
  }

  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> up = Vector3d::UnitZ().cast<T>(), p = up * q[0];
    at.body(1, p, Matrix3<T>(Matrix3<T>::Identity()));
    for (int i = 0; i < 3; ++i) {
      const double angle = 2 * pi * i / 3 + 0.3;
      const Vector3<T> foot = Vector3d(0.25 * std::cos(angle), 0.25 * std::sin(angle), 0).cast<T>();
      at.slender(2 + 2 * i, foot, up), at.slender(3 + 2 * i, p + foot, up);
      at.joint(3 * i, foot), at.joint(3 * i + 1, p + foot, up), at.joint(3 * i + 2, p + foot);
    }
    at.actuator(0, q[0]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Matrix6<T>(Matrix6<T>::Identity());
  }

 private:
  double wall_, azimuth_;
};

const mechanics::Machine& booth(int wall) {
  static const mechanics::Machine open(contract::mechanism<Booth>, {{0}, {0}}), walled(contract::mechanism<Booth>, {{1}, {0}}),
      closed(contract::mechanism<Booth>, {{2}, {0}});
  return wall == 0 ? open : wall == 1 ? walled : closed;
}
mechanics::Pose at_height(const mechanics::Machine& m, double z) { return m.pose({&z, 1}); }

scene::Bounds bounds_of(const mechanics::Machine& m) {
  scene::Bounds out;
  scene::include(out, m, m.home_pose());
  return out;
}
scene::Direction chosen(const mechanics::Machine& m) { return scene::choose_direction(m, {m.home_pose()}, bounds_of(m)); }

Solid solid(Solid::Kind kind, const Vector3d& a, const Vector3d& b, double radius) {
  Solid s{};
  s.kind = kind, s.a = a, s.b = b, s.radius = radius;
  return s;
}

}  // namespace

TEST_CASE("of two bars in a line only the nearer is seen, of two side by side both, and half of one that is half covered") {
  scene::Scene scene;
  scene.solids = {solid(Solid::Kind::cylinder, {0.002, 0, -0.4}, {0.002, 0, 0.4}, 0.05),
                  solid(Solid::Kind::cylinder, {0.002, 1, -0.4}, {0.002, 1, 0.4}, 0.05),
                  solid(Solid::Kind::cylinder, {0.3, 0, -0.4}, {0.3, 0, 0.4}, 0.05),
                  solid(Solid::Kind::box, {0.3, -1, 0.5}, {0.1, 0.1, 0.5}, 0)};
  const auto seen = scene::visible(scene, {0, 1, 2, -1}, 3, {}, 200, 150);  // along +Y, a window of 1 m
  CHECK(seen[0].seen == seen[0].alone);
  CHECK(seen[1].seen == 0);
  CHECK(seen[1].alone == seen[0].alone);
  CHECK(seen[2].seen == Approx(seen[2].alone / 2.0).epsilon(0.03));
  // 0.8 m by 0.1 m with round ends, at 150 pixels a metre.
  CHECK(seen[0].alone == Approx(150 * 150 * (0.8 * 0.1 + pi * 0.05 * 0.05)).epsilon(0.03));
  const auto without = scene::visible(scene, {-2, 1, 2, -2}, 3, {}, 200, 150);
  CHECK(without[1].seen == without[1].alone);
  CHECK(without[2].seen == without[2].alone);
}

TEST_CASE("plates and boxes cover what is behind them, and no more than their outline") {
  scene::Scene scene;
  Solid plate{};
  plate.kind = Solid::Kind::plate, plate.radius = 0.02;
  plate.outline = {{-0.2, 0, -0.1}, {0.2, 0, -0.1}, {0.2, 0, 0.1}, {-0.2, 0, 0.1}};
  scene.solids = {plate, solid(Solid::Kind::ball, {0, 0.5, 0}, {}, 0.05), solid(Solid::Kind::ball, {0.3, 0.5, 0}, {}, 0.05),
                  solid(Solid::Kind::ball, {0, -0.5, 0}, {}, 0.03)};
  const auto seen = scene::visible(scene, {0, 1, 2, 3}, 4, {}, 200, 150);
  CHECK(seen[0].alone == Approx(150 * 150 * 0.4 * 0.2).epsilon(0.03));
  CHECK(seen[0].seen == seen[0].alone - seen[3].alone);
  CHECK(seen[1].seen == 0);
  CHECK(seen[2].seen == seen[2].alone);
}

TEST_CASE("the isometric view stands unless another shows clearly more, and that one is as good as any") {
  for (const int wall : {0, 1, 2}) {
    CAPTURE(wall);
    const mechanics::Machine& m = booth(wall);
    std::vector<scene::Direction> all{scene::isometric(), chosen(m)};
    for (int azimuth = -165; azimuth < 180; azimuth += 30)
      for (const double elevation : {15.0, 25.0, 45.0}) all.push_back({azimuth * deg, elevation * deg});
    const auto seen = scene::visibility(m, {m.home_pose()}, bounds_of(m), all);
    const double best = *std::max_element(seen.begin(), seen.end());
    const bool kept = all[1].azimuth == all[0].azimuth && all[1].elevation == all[0].elevation;
    if (kept)
      CHECK(seen[0] >= 0.95 * best);
    else
      CHECK(seen[0] < 0.95 * seen[1] + 0.01);
    CHECK(seen[1] >= (kept ? 0.95 * best : best - 0.01));
  }
}

TEST_CASE("a wall before the isometric camera sends it to a side from which more is seen, the same every time") {
  const mechanics::Machine& m = booth(1);
  const scene::Direction d = chosen(m), again = chosen(m);
  CHECK(std::abs(d.azimuth - 45 * deg) > 20 * deg);
  CHECK((d.azimuth == again.azimuth && d.elevation == again.elevation));
  const auto seen = scene::visibility(m, {m.home_pose()}, bounds_of(m), {scene::isometric(), d});
  CHECK(seen[0] < 0.8 * seen[1]);
  CHECK(seen[1] <= 1);
}

TEST_CASE("a post before the middle counts, though it hides nothing of the limbs and little of the rest") {
  const mechanics::Machine m(contract::mechanism<Booth>, {{3}, {between_limbs}});
  const scene::Direction at_post{between_limbs, 35 * deg};
  const auto seen = [&](const mechanics::Machine& of, const scene::Direction& from) {
    return scene::visibility(of, {of.home_pose()}, bounds_of(m), {from}).front();
  };
  CHECK(seen(m, at_post) < seen(booth(0), at_post) - 0.03);
  const scene::Direction aside = chosen(m);
  CHECK(std::abs(std::remainder(aside.azimuth - at_post.azimuth, 2 * pi)) > 4 * deg);
  CHECK(seen(m, aside) > seen(m, at_post));
}

TEST_CASE("a base that hides the limbs from a side is told to be in front there, and one that does not is not") {
  const auto in_front = [](int wall, double azimuth, double elevation) {
    const mechanics::Machine& m = booth(wall);
    return scene::base_is_in_front(m, {m.home_pose()}, bounds_of(m), {azimuth, elevation});
  };
  CHECK_FALSE(in_front(0, 45 * deg, 35 * deg));
  CHECK(in_front(1, 45 * deg, 20 * deg));
  CHECK_FALSE(in_front(1, -135 * deg, 20 * deg));
  CHECK(in_front(2, 45 * deg, 20 * deg));
  CHECK_FALSE(in_front(2, 0, 90 * deg));
  CHECK(in_front(0, 0, -90 * deg));  // from below
}

TEST_CASE("an overlay has every pose asked for, the first and the last solid, on one base") {
  const mechanics::Machine& m = booth(0);
  scene::Overlay overlay{{at_height(m, 0.42), at_height(m, 0.46), at_height(m, 0.5), at_height(m, 0.58)}, false, {{{0, 0, 0.5}, "1 s"}}};
  const auto platforms = [&](const scene::Scene& s) {
    std::vector<std::pair<double, float>> out;  // height, opacity
    for (const Solid& x : s.solids)
      if (x.kind == Solid::Kind::plate && x.body % static_cast<int>(m.topology().bodies.size()) == m.topology().platform)
        out.emplace_back(x.outline.front().z(), x.color.a);
    return out;
  };
  const auto all = platforms(scene::build(m, overlay, {}));
  REQUIRE(all.size() == 4);
  CHECK(all[1].first - all[0].first == Approx(0.04));
  CHECK(all[3].first - all[0].first == Approx(0.16));
  CHECK(all[0].second == 1);
  CHECK(all[1].second < 0.5);
  CHECK(all[2].second < 0.5);
  CHECK(all[3].second == 1);
  const scene::Scene s = scene::build(m, overlay, {});
  CHECK(std::ranges::count_if(s.solids, [](const Solid& x) { return x.body == 0 && x.kind == Solid::Kind::box; }) == 1);
  CHECK(std::ranges::count_if(s.labels, [](const scene::Label& l) { return l.text == "1 s"; }) == 1);
  CHECK(std::ranges::none_of(s.labels, [](const scene::Label& l) { return l.text == "A1"; }));
  overlay.returns = true;
  CHECK(platforms(scene::build(m, overlay, {}))[3].second < 0.5);
}

TEST_CASE("poses are spread as far as they go: the first, the last, and no two that look alike") {
  const mechanics::Machine& m = booth(0);
  const auto heights = [&](const std::vector<double>& z) {
    std::vector<mechanics::Pose> out;
    for (const double h : z) out.push_back(at_height(m, h));
    return out;
  };
  using Indices = std::vector<std::size_t>;
  CHECK((scene::spread(m, heights({0.40, 0.41, 0.42, 0.50, 0.60}), 3) == Indices{0, 3, 4}));
  CHECK((scene::spread(m, heights({0.50, 0.60, 0.50, 0.40, 0.50}), 5) == Indices{0, 1, 3}));  // it returns
  CHECK((scene::spread(m, heights({0.50, 0.50, 0.50}), 5) == Indices{0}));
  CHECK(scene::spread(m, {}, 5).empty());
}
