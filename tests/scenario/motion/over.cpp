// A prescribed motion over spans of time, on the stage: its bounds hold what it is at any instant of them, whatever it is prescribed by.
#include <catch2/catch.hpp>
#include <core/scenario/motion/request.hpp>
#include <random>
#include <tests/scenario/trial.hpp>
#include <thread>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using mechanics::Bounded;
using program::Bounds;

namespace {

std::string moving_lines(const std::string& lines) {
  return "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n[[section]]\nkind = \"displacement\"\n[motion]\n" + lines + "\n";
}
Loaded loaded_lines(const std::string& lines, const std::filesystem::path& file = "a.toml") {
  const std::string text = moving_lines(lines);
  INFO(told(text, file));
  return load_text(text, file, stage::source(), section::kinds());
}

// What `at` says in plain numbers is right to a few roundings of what it is made of: 1e-14 of the largest number of its kind.
bool inside(const Bounds& b, double x) {
  const double slack = 1e-14 * std::max({1e-3, std::abs(b.low), std::abs(b.high)});
  return b.low - slack <= x && x <= b.high + slack;
}
void check_spans(const mechanics::Enclosure& over, const mechanics::Path& at, double begin, double end) {
  constexpr unsigned seed = 31;
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> time(begin, end), share(0, 1);
  REQUIRE(over);
  for (int i = 0; i < 300; ++i) {
    double a = time(generator), b = a + (end - a) * std::pow(share(generator), 4);
    if (i == 0) a = begin, b = end;
    CAPTURE(seed, i, a, b);
    std::vector<Bounded> bounds(2);
    REQUIRE(over({a, b}, bounds.data()));
    for (const double t : {a, b, a + share(generator) * (b - a)}) {
      double value[2], rate[2], acceleration[2];
      REQUIRE(at(t, value, rate, acceleration));
      for (std::size_t j = 0; j < 2; ++j) {
        CAPTURE(t, j, value[j], bounds[j].value.low, bounds[j].value.high, rate[j], acceleration[j]);
        CHECK(inside(bounds[j].value, value[j]));
        CHECK(inside(bounds[j].rate, rate[j]));
        CHECK(inside(bounds[j].acceleration, acceleration[j]));
      }
    }
  }
}

const std::string ten_seconds = "duration = \"10 s\"\nsamples = 21\n";
const std::string points =
    "[[motion.waypoint]]\ntime = \"0 s\"\nx = \"0 mm\"\n[[motion.waypoint]]\ntime = \"2 s\"\nx = \"20 mm\"\nphi = \"3 deg\"\n"
    "[[motion.waypoint]]\ntime = \"5 s\"\nx = \"-10 mm\"\n[[motion.waypoint]]\ntime = \"9 s\"\nx = \"5 mm\"\nphi = \"-2 deg\"\n";

}  // namespace

TEST_CASE("a prescribed motion is within its bounds over any span, by whatever it is prescribed") {
  const std::vector<std::string> motions{
      ten_seconds + "x = \"20 mm * sin(2*pi*t/10 s)\"\nphi = \"5 deg * abs(cos(2*pi*t/3 s))\"",
      ten_seconds + "x_rate = \"20 mm/s * sin(2*pi*t/3 s)\"\nphi_rate = \"1 deg/s * max(0, t/1 s - 4)\"",
      ten_seconds + "x = \"20 mm\"",
      "samples = 21\nprofile = \"quintic\"\n" + points,
      "samples = 21\nprofile = \"cubic-spline\"\n" + points,
  };
  for (const std::string& lines : motions) {
    CAPTURE(lines);
    const Loaded l = loaded_lines(lines);
    check_spans(l.trajectory.over, l.trajectory.at, l.trajectory.time.front(), l.trajectory.time.back());
    check_spans(l.scenario.motion->over, l.scenario.motion->prescribed, l.trajectory.time.front(), l.trajectory.time.back());
  }
  const Folder folder;
  folder.write("motion.csv", "t [s],x [mm]\n1,0\n2,5\n4,-3\n4.5,0\n7,1\n");
  const Loaded l = loaded_lines("file = \"motion.csv\"", folder.path() / "a.toml");
  check_spans(l.trajectory.over, l.trajectory.at, 1, 7);
}

TEST_CASE("a coordinate that stays at home has bounds without width") {
  Bounded bounds[2];
  REQUIRE(loaded_lines(ten_seconds + "x = \"20 mm\"").trajectory.over({1, 3}, bounds));
  CHECK(bounds[0].value == Bounds::exactly(0.02));
  CHECK(bounds[1].value == Bounds::exactly(0));
  CHECK(bounds[1].rate == Bounds::exactly(0));
  CHECK(bounds[1].acceleration == Bounds::exactly(0));
}

TEST_CASE("a motion that was cut off keeps the bounds of what remains") {
  mechanics::Trajectory m = loaded_lines(ten_seconds + "x = \"20 mm * sin(2*pi*t/10 s)\"").trajectory;
  mechanics::cut_off(m, 11);
  check_spans(m.over, m.at, 0, m.time.back());
}

TEST_CASE("of prescribed actuators the request has bounds, and the coordinates that follow have none") {
  const Loaded l = loaded_lines(ten_seconds + "q = \"20 mm * sin(2*pi*t/10 s)\"\npsi = \"5 deg * t/10 s\"");
  check_spans(l.scenario.motion->over, l.scenario.motion->prescribed, 0, 10);
  CHECK_FALSE(l.trajectory.over);
}

TEST_CASE("where nothing is known of any coordinate a motion says so, and elsewhere of which") {
  const Loaded l = loaded_lines(ten_seconds + "x = \"1 mm * abs(t - 1.1 s)/(t - 1.1 s)\"");
  std::vector<Bounded> bounds(2);
  REQUIRE(l.trajectory.over({1, 2}, bounds.data()));
  CHECK_FALSE(bounds[0].value.bounded());
  CHECK(bounds[1].value.bounded());
  REQUIRE(l.trajectory.over({2, 2.01}, bounds.data()));
  CHECK(bounds[0].value.has(0.001));
  CHECK(bounds[0].value.width() < 1e-6);  // of one that is divided by another no more is known than the first order of both
  const Loaded both = loaded_lines(ten_seconds + "x = \"1 mm * abs(t - 1.1 s)/(t - 1.1 s)\"\nphi = \"1 deg * abs(t - 1.2 s)/(t - 1.2 s)\"");
  CHECK_FALSE(both.trajectory.over({1, 2}, bounds.data()));
}

TEST_CASE("the bounds of a motion are the same in all threads, from the first on") {
  const Loaded l = loaded_lines(ten_seconds + "x_rate = \"20 mm/s * sin(2*pi*t/3 s)\"\nphi = \"1 deg\"");
  std::vector<double> highs(4);
  std::vector<std::thread> threads;
  for (double& high : highs)
    threads.emplace_back([&high, &l] {
      Bounded bounds[2];
      l.trajectory.over({3, 7}, bounds);
      high = bounds[0].value.high;
    });
  for (std::thread& t : threads) t.join();
  for (const double high : highs) CHECK(high == highs[0]);
  CHECK(highs[0] == Approx(2 * 0.02 * 3 / (2 * 3.14159265358979323846)));
}
