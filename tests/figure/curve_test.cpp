#include "reports/figure/curve.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <tests/figure/samples.hpp>

using namespace pmreport::figure;
using samples::gap;
using samples::infinite;

namespace {

const Frame frame{100, 50, {0, 10}, {-1, 1}};

std::pair<double, double> extremes(const std::vector<Stroke>& strokes) {
  double low = infinite, high = -infinite;
  for (const Stroke& stroke : strokes) {
    for (const Point p : stroke) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
  }
  return {low, high};
}

}  // namespace

TEST_CASE("a gap in the data is a gap in the curve") {
  const Trace result = trace({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, {0, 0.5, gap, 0.5, 0, infinite, 0.25, -infinite, gap, 0.5, 0}, frame);
  REQUIRE(result.strokes.size() == 3);
  CHECK(result.strokes[0].front().x == Approx(0));
  CHECK(result.strokes[0].back().x == Approx(10));
  CHECK(result.strokes[1].front().x == Approx(30));
  CHECK(result.strokes[1].back().x == Approx(40));
  CHECK(result.strokes[2].back().x == Approx(100));
  REQUIRE(result.dots.size() == 1);
  CHECK(result.dots[0].x == Approx(60));
  CHECK(result.dots[0].y == Approx(50 * (1 - 1.25 / 2)));
}

TEST_CASE("a sample without a finite abscissa is a gap too") {
  CHECK(trace({0, 1, gap, 3, 4}, {0, 0, 0, 0, 0}, frame).strokes.size() == 2);
}

TEST_CASE("a curve that leaves the frame is cut at its edge and marked") {
  const Trace result = trace({0, 4, 5, 6, 10}, {0, 0, 3, 0, 0}, frame);
  REQUIRE(result.strokes.size() == 2);
  // The curve rises from 0 to 3 within x = 4 to 5 and passes y = 1 after a third of it.
  CHECK(result.strokes[0].back().x == Approx(10 * (4 + 1.0 / 3)));
  CHECK(result.strokes[0].back().y == Approx(0).margin(1e-12));
  CHECK(result.strokes[1].front().x == Approx(10 * (5 + 2.0 / 3)));
  REQUIRE(result.exits.size() == 1);
  CHECK(result.exits[0].above);
  CHECK(result.exits[0].x == Approx(50));
}

TEST_CASE("no value, however large, puts a point outside the frame") {
  std::mt19937_64 random(77);
  std::uniform_real_distribution<double> exponent(-300, 308), sign(-1, 1);
  std::vector<double> x, y;
  for (int i = 0; i < 5000; ++i) {
    x.push_back(10.0 * i / 4999);
    y.push_back(std::copysign(std::pow(10, exponent(random)), sign(random)));
  }
  const Box box{0, 0, frame.width, frame.height};
  const Trace result = trace(x, y, frame);
  CHECK(!result.strokes.empty());
  for (const Stroke& stroke : result.strokes) {
    CHECK(stroke.size() >= 2);
    CHECK(std::all_of(stroke.begin(), stroke.end(), [&](Point p) { return box.contains(p); }));
  }
  for (const Exit& exit : result.exits) CHECK((exit.x >= 0 && exit.x <= frame.width));
}

TEST_CASE("twenty thousand samples become few points and keep every extreme") {
  const Series noisy = samples::curve("", 20000, 10, [](double t) { return std::sin(1e4 * t * t) * (0.1 + 0.08 * t); });
  const Trace result = trace(noisy.x, noisy.y, frame);
  std::size_t points = 0;
  for (const Stroke& stroke : result.strokes) points += stroke.size();
  CHECK(points <= 4 * 401);  // 100 pt in columns of a quarter of a point, four points each
  const auto [low, high] = std::minmax_element(noisy.y.begin(), noisy.y.end());
  const auto [top, bottom] = extremes(result.strokes);
  // 0.03 pt is the tolerance to which a curve is simplified.
  CHECK(top == Approx(25 * (1 - *high)).margin(0.03));
  CHECK(bottom == Approx(25 * (1 - *low)).margin(0.03));
}

TEST_CASE("a single spike among many samples is still drawn") {
  Series quiet = samples::curve("", 20000, 10, [](double) { return 0.0; });
  quiet.y[12345] = 0.9;
  const auto [top, bottom] = extremes(trace(quiet.x, quiet.y, frame).strokes);
  CHECK(top == Approx(2.5));
  CHECK(bottom == Approx(25));
}

TEST_CASE("a simplified curve passes every sample within its tolerance") {
  const Series wave = samples::curve("", 1000, 10, [](double t) { return std::sin(3 * t); });
  Stroke samples_on_page;
  for (std::size_t i = 0; i < wave.x.size(); ++i) samples_on_page.push_back(to_page(frame, wave.x[i], wave.y[i]));
  const Stroke drawn = simplify(samples_on_page, 0.03);
  CHECK(drawn.size() < 300);
  for (const Point p : samples_on_page) {
    const auto next = std::upper_bound(drawn.begin(), drawn.end() - 1, p.x, [](double x, Point q) { return x < q.x; });
    const Point a = *(next - 1), b = *next;
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double miss = std::abs((b.x - a.x) * (a.y - p.y) - (a.x - p.x) * (b.y - a.y)) / length;
    REQUIRE(miss <= 0.03 + 1e-9);
  }
}

TEST_CASE("a curve may run back in x") {
  std::vector<double> x, y;
  for (int i = 0; i <= 360; ++i) {
    x.push_back(5 + 4 * std::cos(i * 3.14159265358979 / 180));
    y.push_back(0.8 * std::sin(i * 3.14159265358979 / 180));
  }
  const Trace circle = trace(x, y, frame);
  REQUIRE(circle.strokes.size() == 1);
  const auto [top, bottom] = extremes(circle.strokes);
  CHECK(top == Approx(5).margin(0.03));
  CHECK(bottom == Approx(45).margin(0.03));
}

TEST_CASE("a curve of very many samples is thinned out to what looks the same, and its gaps and extremes stay") {
  constexpr std::size_t n = 200'000;
  std::mt19937 random(7);
  std::vector<double> x(n), y(n);
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = 10 * static_cast<double>(i) / (n - 1);
    y[i] = 0.8 * std::sin(5 * x[i]) + 1e-4 * std::generate_canonical<double, 53>(random);
  }
  for (std::size_t i = 70'000; i < 80'000; ++i) y[i] = gap;
  y[123'456] = 0.95;
  std::vector<double> few_x = x, few_y = y;
  thin_out(few_x, few_y);
  REQUIRE(few_x.size() == few_y.size());
  CHECK(few_x.size() < few_samples + 8);
  CHECK(few_x.front() == x.front());
  CHECK(few_x.back() == x.back());
  CHECK(std::is_sorted(few_x.begin(), few_x.end()));
  const std::vector<Stroke> whole = trace(x, y, frame).strokes, thin = trace(few_x, few_y, frame).strokes;
  REQUIRE(thin.size() == 2);
  CHECK(extremes(thin) == extremes(whole));
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(thin[k].front().x == whole[k].front().x);
    CHECK(thin[k].back().x == whole[k].back().x);
  }
  // But for the spike the pen keeps to the sine, and to the rounding that it bears.
  const double spike = to_page(frame, x[123'456], 0).x;
  for (const Stroke& stroke : thin)
    for (const Point p : stroke)
      if (std::abs(p.x - spike) > 1) CHECK(p.y == Approx(to_page(frame, 0, 0.8 * std::sin(p.x / 2)).y).margin(0.01));
  std::vector<double> short_x(x.begin(), x.begin() + 5000), short_y(y.begin(), y.begin() + 5000);
  const std::vector<double> before = short_y;
  thin_out(short_x, short_y);
  CHECK(short_y == before);
}
