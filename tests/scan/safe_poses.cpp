// Boxes and balls that are claimed to lie within a set, attacked with random poses in extended precision.
#include <catch2/catch.hpp>
#include <core/scan/safe_poses.hpp>
#include <tests/scan/legs.hpp>

#include <random>

using namespace pmreport;
using namespace pmreport::scan;
using program::Bounds;

namespace {

// What extended precision leaves of a margin that is zero.
constexpr long double of_the_attack = 1e-17L;

std::size_t violations(const std::vector<Bounds>& sides, std::size_t poses, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<long double> share(0, 1);
  std::size_t found = 0;
  std::vector<long double> x(sides.size());
  for (std::size_t k = 0; k < poses; ++k) {
    for (std::size_t a = 0; a < x.size(); ++a) {
      // Half of the poses on faces, edges and corners, where limits are met.
      const long double s = random() % 2 == 0 ? share(random) : static_cast<long double>(random() % 2);
      x[a] = sides[a].low + s * (static_cast<long double>(sides[a].high) - sides[a].low);
    }
    found += least_margin(x).first < -of_the_attack;
  }
  return found;
}

// Of a ball, most of them near its surface.
std::size_t violations(const std::vector<double>& centre, const std::vector<double>& proportions, double radius, std::size_t poses,
                       std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> any;
  std::size_t found = 0;
  std::vector<long double> x(centre.size());
  for (std::size_t k = 0; k < poses; ++k) {
    long double square = 0;
    for (long double& c : x) c = any(random), square += c * c;
    const long double r = radius * (k % 8 == 0 ? std::generate_canonical<double, 53>(random) : 1 - 1e-15L) / std::sqrt(square);
    for (std::size_t a = 0; a < x.size(); ++a) x[a] = centre[a] + r * proportions[a] * x[a];
    found += least_margin(x).first < -of_the_attack;
  }
  return found;
}

}  // namespace

TEST_CASE("No random pose of a safe box breaks a limit, and just beyond each sharp face one does") {
  for (const int inputs : {3, 4}) {
    CAPTURE(inputs);
    const Scan scan = leg_scan(inputs);
    const SafeOptions options{{}, 2e-3, 200'000};
    const SafeBox box = safe_box(leg_set(inputs), scan, scan.at, options);
    CAPTURE(box.why, box.boxes);
    REQUIRE(box.found);
    CHECK(violations(box.sides, 20'000, 7) == 0);
    for (std::size_t a = 0; a < box.sides.size(); ++a) {
      CAPTURE(a, box.sides[a].low, box.sides[a].high, box.low_margin[a], box.high_margin[a]);
      CHECK(box.sides[a].width() > 0);
      for (const bool upper : {false, true}) {
        if (!(upper ? box.high_sharp : box.low_sharp)[a]) continue;
        std::vector<Bounds> beyond = box.sides;
        const double from = upper ? beyond[a].high : beyond[a].low, step = 4 * options.accuracy * std::abs(from - scan.at[a]);
        beyond[a] = upper ? Bounds{from, from + step} : Bounds{from - step, from};
        CHECK(violations(beyond, 20'000, 8) > 0);
      }
    }
  }
}

TEST_CASE("The safe box of a slab and a corner is known: what binds each face is told") {
  // x <= 0.3, y >= -0.2, x + y <= 0.4; in z the range ends.
  const PoseSet set = recorded_set(3, [](program::Recorder& r, std::vector<Recorded>& m) {
    m.push_back(Recorded(0.3) - r.input(0));
    m.push_back(r.input(1) + Recorded(0.2));
    m.push_back(Recorded(0.4) - r.input(0) - r.input(1));
  });
  Scan scan;
  scan.at = {0, 0, 0};
  for (int a = 0; a < 3; ++a) scan.points.push_back({a, -1, 1, 1});
  const SafeOptions options{{1, 1, 1}, 1e-4, 100'000};
  const SafeBox box = safe_box(set, scan, {0, 0, 0}, options);
  REQUIRE(box.found);
  // Grown as a whole until x + y binds or y: y >= -0.2 comes first, at a scale of 0.2. Then x down to -1, z down to -1, x up until
  // x + 0.2 = 0.4, and y not any more.
  const auto near = [](double x, double truth) { return std::abs(x - truth) < 1e-3; };
  CHECK(box.sides[0].high <= 0.3);
  CHECK(box.sides[1].low >= -0.2);
  CHECK(box.sides[0].high + box.sides[1].high <= 0.4);
  CHECK(box.sides[0].low == -1);
  CHECK(near(box.sides[0].high, 0.2));
  CHECK(near(box.sides[1].low, -0.2));
  CHECK(near(box.sides[1].high, 0.2));
  CHECK(box.sides[2] == Bounds{-1, 1});
  CHECK(box.low_margin == std::vector<int>{-1, 2, -1});
  CHECK(box.high_margin == std::vector<int>{3, 3, -1});
  CHECK(box.low_sharp == std::vector<bool>{false, true, false});
  CHECK(box.high_sharp == std::vector<bool>{true, true, false});
}

TEST_CASE("A safe ball in a ball has the radius that is left") {
  const PoseSet set = recorded_set(3, [](program::Recorder& r, std::vector<Recorded>& m) {
    m.push_back(Recorded(1.0) - square_distance(r, {0, 0, 0}));
  });
  Scan scan;
  scan.at = {0, 0, 0};
  for (int a = 0; a < 3; ++a) scan.points.push_back({a, -2, 2, 1});
  const SafeBall ball = safe_ball(set, scan, {0.2, -0.1, 0.2}, {{1, 1, 1}, 1e-3, 400'000});
  CAPTURE(ball.why, ball.radius, ball.boxes);
  REQUIRE(ball.found);
  CHECK(ball.radius <= 0.7);
  CHECK(ball.radius > 0.7 * (1 - 1e-3));
  CHECK(ball.margin == 1);
  CHECK(ball.sharp);
}

TEST_CASE("No random pose of a safe ball breaks a limit, and a little beyond one does") {
  for (const int inputs : {3, 4}) {
    CAPTURE(inputs);
    const Scan scan = leg_scan(inputs);
    std::vector<double> proportions{0.4, 0.6, 0.5, 0.7};
    proportions.resize(static_cast<std::size_t>(inputs));
    const SafeBall ball = safe_ball(leg_set(inputs), scan, scan.at, {proportions, 2e-3, 200'000});
    CAPTURE(ball.why, ball.radius, ball.boxes, ball.margin);
    REQUIRE(ball.found);
    CHECK(ball.sharp);
    CHECK(ball.radius > 0);
    CHECK(violations(scan.at, proportions, ball.radius, 20'000, 10) == 0);
    CHECK(violations(scan.at, proportions, 1.04 * ball.radius, 20'000, 11) > 0);
  }
}

TEST_CASE("About a pose outside the set nothing is grown, and the margin is told by its number") {
  const Scan scan = leg_scan(3);
  std::vector<double> centre{0.5, 0.5, 1.2};
  const auto [least, margin] = least_margin({0.5L, 0.5L, 1.2L});
  REQUIRE(least < 0);
  const SafeBox box = safe_box(leg_set(3), scan, centre, {});
  CHECK_FALSE(box.found);
  CHECK(box.why.find("is negative there") != std::string::npos);
  const SafeBall ball = safe_ball(leg_set(3), scan, centre, {});
  CHECK_FALSE(ball.found);
  centre[0] = 5;
  CHECK(safe_box(leg_set(3), scan, centre, {}).why == "the centre lies outside the scanned range of coordinate 1");
}

TEST_CASE("The attack finds what is wrong with a safe box of a set without one of its margins") {
  program::Recorder recorder(3);
  std::vector<Recorded> x;
  for (int i = 0; i < 3; ++i) x.push_back(recorder.input(i));
  std::vector<Recorded> margins = leg_margins(x);
  const Scan scan = leg_scan(3);
  const SafeBox whole = safe_box(leg_set(3), scan, scan.at, {{}, 2e-3, 200'000});
  REQUIRE(whole.found);
  // The margin that binds a face, or its opposite.
  const auto binding = static_cast<std::size_t>(*std::max_element(whole.high_margin.begin(), whole.high_margin.end()));
  REQUIRE(binding > 0);
  for (const bool dropped : {true, false}) {
    std::vector<Recorded> wrong = margins;
    wrong[binding] = dropped ? Recorded(1.0) : margins[binding] + Recorded(0.02);
    const SafeBox claimed =
        safe_box({recorder.finish(wrong), std::vector<double>(wrong.size(), 0.0), {}}, scan, scan.at, {{}, 2e-3, 200'000});
    REQUIRE(claimed.found);
    CHECK(violations(claimed.sides, 20'000, 9) > 0);
  }
}
