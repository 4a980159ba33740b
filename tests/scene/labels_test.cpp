#include <catch2/catch.hpp>
#include <random>
#include <reports/scene/labels.hpp>

using namespace pmreport::scene;

namespace {

struct Random {
  std::mt19937 engine;
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
};

// A machine-like crowd: labelled balls, some of them close together, and bars between them.
Scene crowd(unsigned seed) {
  Random random{std::mt19937(seed)};
  Scene scene;
  const int joints = 4 + static_cast<int>(random(0, 12));
  for (int k = 0; k < joints; ++k) {
    Eigen::Vector3d at(random(-0.5, 0.5), random(-0.5, 0.5), random(0, 0.7));
    if (k > 0 && random(0, 1) < 0.3) at = scene.labels.back().at + 0.04 * Eigen::Vector3d(random(-1, 1), random(-1, 1), random(-1, 1));
    Solid ball{};
    ball.kind = Solid::Kind::ball, ball.a = at, ball.radius = 0.016;
    scene.solids.push_back(ball);
    if (k > 0) {
      Solid bar{};
      bar.kind = Solid::Kind::cylinder, bar.a = scene.labels.back().at, bar.b = at, bar.radius = 0.01;
      scene.solids.push_back(bar);
    }
    scene.labels.push_back({at, (k % 2 ? "A" : "B") + std::to_string(k + 1), {0, 0, 0}});
  }
  return scene;
}

// 800 pixels for a page's width: labels of 14 pixels.
constexpr Quality page{800, 600, false, 2, 140};

bool overlap(const PlacedLabel& a, const PlacedLabel& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

}  // namespace

TEST_CASE("labels overlap neither one another nor a joint, and stay in the picture") {
  constexpr int width = 800, height = 600;
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const Scene scene = crowd(seed);
    const Camera camera{{0, 0, 0.35}, 0.1 * seed, 0.005 * seed, 1.5};
    const std::vector<PlacedLabel> placed = place_labels(scene, camera, page);
    REQUIRE(placed.size() == scene.labels.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const PlacedLabel& l = placed[i];
      CAPTURE(l.text, l.x, l.y, l.width, l.height);
      CHECK((l.x >= 0 && l.y >= 0 && l.x + l.width <= width && l.y + l.height <= height));
      for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(overlap(l, placed[k]));
      for (const Solid& s : scene.solids) {
        if (s.kind != Solid::Kind::ball) continue;
        const Eigen::Vector2d c = project(camera, s.a, width, height);
        const Eigen::Vector2d near(std::clamp(c.x(), l.x, l.x + l.width), std::clamp(c.y(), l.y, l.y + l.height));
        CHECK((near - c).norm() >= s.radius * height / camera.height);
      }
    }
  }
}

TEST_CASE("a label alone stands close to its joint, without a leader: one in a crowd that is moved away has one") {
  Scene lone;
  Solid ball{};
  ball.kind = Solid::Kind::ball, ball.radius = 0.02;
  lone.solids = {ball};
  lone.labels = {{{0, 0, 0}, "A1", {0, 0, 0}}};
  const auto spots = find_spots(lone, {}, page);
  REQUIRE(spots.size() == 1);
  CHECK_FALSE(spots[0].leader);
  const PlacedLabel& b = spots[0].box;
  const Eigen::Vector2d near(std::clamp(400.0, b.x, b.x + b.width), std::clamp(300.0, b.y, b.y + b.height));
  CHECK((near - Eigen::Vector2d(400, 300)).norm() < 12 + label_size(800, 140));

  Scene packed;  // 5 x 5 joints, so close that no label fits between them
  for (int k = 0; k < 25; ++k) {
    ball.a = {0.045 * (k % 5), 0, 0.045 * (k / 5)};
    packed.solids.push_back(ball);
    packed.labels.push_back({ball.a, "P" + std::to_string(k + 1), {0, 0, 0}});
  }
  const auto moved = find_spots(packed, {{0.09, 0, 0.09}, 0, 0, 1}, page);
  REQUIRE(moved.size() == 25);
  const auto inner = moved[12];
  CHECK(inner.leader);
}

TEST_CASE("a label is 7 points on paper, however many pixels the picture has and however large it is printed") {
  Scene lone;
  lone.labels = {{{0, 0, 0}, "H", {0, 0, 0}}};
  // DejaVu's capitals are 0.729 of the size high; the rim is 0.13 of it on either side. Pango places on whole pixels.
  constexpr double seven_points = 7 * 25.4 / 72, height = (0.729 + 2 * 0.13) * seven_points;  // [mm]
  for (const Quality q : {Quality{1600, 1200, false, 2, 85}, Quality{800, 600, false, 2, 85}, Quality{1200, 900, false, 2, 140}}) {
    CAPTURE(q.width, q.printed);
    const double millimetres_per_pixel = q.printed / q.width;
    const auto placed = place_labels(lone, {}, q);
    REQUIRE(placed.size() == 1);
    CHECK(std::abs(placed[0].height * millimetres_per_pixel - height) < 2 * millimetres_per_pixel);
  }
}

TEST_CASE("a label that names a rod stands beside it, and close") {
  Scene scene;
  Solid rod{};
  rod.kind = Solid::Kind::cylinder, rod.a = {0, 0, -0.3}, rod.b = {0, 0, 0.3}, rod.radius = 0.03;
  scene.solids = {rod};
  scene.labels = {{{0, 0, 0}, "l1", {0, 0, 0}, 0.03}};
  const auto placed = place_labels(scene, {}, page);
  REQUIRE(placed.size() == 1);
  constexpr double radius = 0.03 * 600;  // [px] of a window of 1 m
  const double left = placed[0].x, right = placed[0].x + placed[0].width;
  CHECK((right <= 400 - radius || left >= 400 + radius));
  CHECK(std::min(std::abs(right - 400), std::abs(left - 400)) < radius + label_size(800, 140));
}

TEST_CASE("labels that no picture could hold are left out rather than piled up") {
  Scene scene = crowd(5);
  const auto placed = place_labels(scene, {{0, 0, 0.35}, 0, 0, 1.5}, page);
  CHECK(placed.size() == scene.labels.size());
  scene.labels = {{{0, 0, 0.35}, std::string(400, 'W'), {0, 0, 0}}, {{100, 0, 0}, "far", {0, 0, 0}}, {{0, 0, 0}, "", {0, 0, 0}}};
  CHECK(place_labels(scene, {{0, 0, 0.35}, 0, 0, 1.5}, page).empty());
}

TEST_CASE("an optional label stands close to its point, moves no other, and is left out where there is no room") {
  int placed = 0, left_out = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    Scene scene = crowd(seed);
    const Camera camera{{0, 0, 0.35}, 0.1 * seed, 0.005 * seed, 1.5};
    const auto without = find_spots(scene, camera, page);
    for (int k = 0; k < 8; ++k)
      scene.labels.push_back({{0.08 * k - 0.3, 0, 0.35 + 0.02 * k}, std::to_string(k) + ".5 s", {1, 0, 0}, 0.004, true});
    const auto with = find_spots(scene, camera, page);
    REQUIRE(with.size() >= without.size());
    for (std::size_t i = 0; i < with.size(); ++i) {
      const PlacedLabel& l = with[i].box;
      CAPTURE(l.text);
      if (i < without.size()) {
        CHECK((l.x == without[i].box.x && l.y == without[i].box.y));
        continue;
      }
      CHECK_FALSE(with[i].leader);
      for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(overlap(l, with[k].box));
    }
    placed += static_cast<int>(with.size() - without.size());
    left_out += static_cast<int>(scene.labels.size() - with.size());
  }
  CHECK(placed > 100);
  CHECK(left_out > 20);
}

TEST_CASE("times beside one another are not read as one") {
  const double letters = label_size(800, 140);
  for (unsigned seed = 0; seed < 40; ++seed) {
    Random random{std::mt19937(seed)};
    Scene scene;
    for (int k = 0; k < 8; ++k)
      scene.labels.push_back({{random(-0.08, 0.08), 0, random(-0.05, 0.05)}, std::to_string(k) + ".5 s", {0, 0, 0}, 0.004});
    const auto boxes = place_labels(scene, {}, page);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const PlacedLabel &l = boxes[i], &m = boxes[k];
        if (std::abs(l.y - m.y) > l.height) continue;
        CAPTURE(seed, l.text, m.text);
        CHECK(std::max(m.x - l.x - l.width, l.x - m.x - m.width) > 0.79 * letters);
      }
  }
}

TEST_CASE("digits after letters are set as a subscript, and markup in a name is only text") {
  CHECK(label_markup("A12", 20).find("A<span") == 0);
  CHECK(label_markup("A12", 20).find(">12</span>") != std::string::npos);
  CHECK(label_markup("12", 20) == "12");
  CHECK(label_markup("U6p", 20).find("U′<span") == 0);
  CHECK(label_markup("U6p", 20).find(">6</span>") != std::string::npos);
  CHECK(label_markup("lamp", 20) == "lamp");
  CHECK(label_markup("<b>", 20).find('<') == std::string::npos);
}
