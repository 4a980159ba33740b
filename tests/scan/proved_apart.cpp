#include <catch2/catch.hpp>
#include <core/program/evaluate.hpp>
#include <core/program/recorder.hpp>
#include <core/scan/proof/apart.hpp>
#include <core/scan/proved_volume.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace pmreport::scan {

namespace {

// A slider above the plane, held by a rod of unit length: reach 1 - x^2 - y^2, stroke z + sqrt(1 - x^2 - y^2) from 0.5 to 1.5; and a plane.
program::Program slider() {
  program::Recorder recorder(3);
  const Recorded x = recorder.input(0), y = recorder.input(1), z = recorder.input(2), under = 1.0 - x * x - y * y, plane = 0.9 - x;
  const Recorded reach = choose(under < plane, under, plane), q = z + sqrt(under);
  const std::array outputs{reach, q - 0.5, 1.5 - q};
  return recorder.finish(outputs);
}

}  // namespace

TEST_CASE("margins that are taken apart accept the same poses") {
  const program::Program whole = slider(), apart = taken_apart(whole).program;
  REQUIRE(apart.outputs().size() > whole.outputs().size());
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> number(-1.5, 1.5);
  program::Evaluator<double> of_whole(whole), of_apart(apart);
  std::vector<double> a(whole.outputs().size()), b(apart.outputs().size());
  int accepted = 0;
  for (int i = 0; i < 5000; ++i) {
    const std::array q{number(random), number(random), number(random)};
    CAPTURE(q);
    of_whole.run(q, a);
    of_apart.run(q, b);
    const auto kept = [](double m) { return m >= 0; };
    const bool is = std::ranges::all_of(a, kept);
    CHECK(is == std::ranges::all_of(b, kept));
    accepted += is;
  }
  CHECK(accepted > 100);
}

TEST_CASE("a volume that ends where a root does is bracketed as narrowly as asked for") {
  PoseSet set{slider(), std::vector<double>(3, 0.0)};
  const Scan scan{{0, 0, 0}, {{0, -1.1, 1.1, 1}, {1, -1.1, 1.1, 1}, {2, -1, 2, 1}}};
  VolumeOptions options;
  options.gap = 0.005;
  options.boxes = 2'000'000;  // which the rim of the reach alone must not use up
  const ProvedVolume v = prove_volume(set, scan, options);
  // A column over every point of the disc cut by the plane has a height of 1.
  const double a = std::acos(0.9), exact = std::numbers::pi - a + 0.9 * std::sin(a);
  CAPTURE(v.volume.low, v.volume.high, exact, v.boxes, v.why);
  CHECK(v.enough);
  CHECK(v.volume.low <= exact);
  CHECK(exact <= v.volume.high);
}

}  // namespace pmreport::scan
