// Where a prescribed motion is not smooth: its knots and its breaks, on the stage, whose x is prescribed.
#include <catch2/catch.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;
using mechanics::Break;

namespace {

std::string moving_until(const std::string& line, const std::string& duration, int samples) {
  return "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n[[section]]\nkind = \"displacement\"\n[motion]\nduration = \"" + duration +
         "\"\nsamples = " + std::to_string(samples) + "\n" + line + "\n";
}
mechanics::Trajectory trajectory_of(const std::string& line, const std::string& duration = "4 s", int samples = 20) {
  const std::string text = moving_until(line, duration, samples);
  INFO(told(text));
  return load_text(text, "a.toml", stage::source(), section::kinds()).trajectory;
}

void check_break(const std::string& line, Break::Of of, double time, double jump, double margin = 1e-12) {
  CAPTURE(line);
  const mechanics::Trajectory m = trajectory_of(line);
  REQUIRE(m.breaks.size() == 1);
  CHECK(m.breaks[0].of == of);
  CHECK(m.breaks[0].what == "x");
  CHECK(m.breaks[0].unit == "m");
  CHECK(m.breaks[0].time == Approx(time).margin(margin));
  CHECK(m.breaks[0].jump == Approx(jump));
}

}  // namespace

TEST_CASE("the lowest derivative that jumps is found with its time and its size") {
  check_break("x = \"50 mm - 100 mm * abs(t/2 s - 1)\"", Break::Of::rate, 2, 0.1);
  check_break("x = \"10 mm * abs(t - 1.1 s)/(t - 1.1 s)\"", Break::Of::value, 1.1, 0.02);
  check_break("x = \"1 mm/s^2 * max(t - 1.1 s, 0 s)^2\"", Break::Of::acceleration, 1.1, 0.002);
  check_break("x = \"1 mm * max(t/1 s, 3.3 - t/1 s)\"", Break::Of::rate, 1.65, 0.002);
  check_break("x = \"1 mm * asin(sin(2*t/3 s))/1 rad\"", Break::Of::rate, 0.75 * 3.14159265358979323846, 0.004 / 3, 1e-6);
  check_break("x = \"1 mm * (t/1 s)*abs(t/1 s - 1.1) * (t/1 s - 1.1)\"", Break::Of::acceleration, 1.1, 4 * 1.1e-3);
}

TEST_CASE("a value that jumps is told with its time, by whichever function it does") {
  constexpr double pi = 3.14159265358979323846;
  check_break("x = \"1 mm * atan2(sin(t/1 s), cos(t/1 s))/1 rad\"", Break::Of::value, pi, 2e-3 * pi);
  check_break("x = \"1 mm * atan2(0, cos(t/1 s))/1 rad\"", Break::Of::value, pi / 2, 1e-3 * pi);
  check_break("x = \"1 mm * atan(1 s/(t - 1.1 s))/1 rad\"", Break::Of::value, 1.1, 1e-3 * pi);
  check_break("x = \"1 mm * tanh(1 s/(t - 1.1 s))\"", Break::Of::value, 1.1, 2e-3);
  check_break("x = \"1 mm * max(0, abs(t - 1.1 s)/(t - 1.1 s))\"", Break::Of::value, 1.1, 1e-3);
  check_break("x_rate = \"1 mm/s * atan2(sin(t/1 s), cos(t/1 s))/1 rad\"", Break::Of::rate, pi, 2e-3 * pi);
}

TEST_CASE("two kinks between two samples are told both") {
  const mechanics::Trajectory m = trajectory_of("x = \"1 mm * max(0, 1 - ((t - 1.7 s)/1 ms)^2)\"");
  REQUIRE(m.breaks.size() == 2);
  CHECK(m.breaks[0].of == Break::Of::rate);
  CHECK(m.breaks[0].time == Approx(1.699));
  CHECK(m.breaks[1].time == Approx(1.701));
  CHECK(m.breaks[1].jump == Approx(2));
}

TEST_CASE("of a rate that is integrated the break is one derivative higher") {
  check_break("x_rate = \"1 mm/s * abs(t/1 s - 1.1)\"", Break::Of::acceleration, 1.1, 0.002);
  check_break("x_rate = \"1 mm/s * abs(t - 1.1 s)/(t - 1.1 s)\"", Break::Of::rate, 1.1, 0.002);
}

TEST_CASE("what is smooth to its acceleration has no breaks, though it has knots") {
  for (const char* line :
       {"x = \"10 mm * step5(t, 1 s, 3 s)\"", "x = \"1 mm * max(t/1 s - 1.1, 0)^3\"", "x = \"1 mm * abs(t/1 s - 1.1)^3\""}) {
    CAPTURE(line);
    const mechanics::Trajectory m = trajectory_of(line);
    CHECK(m.breaks.empty());
    CHECK_FALSE(m.knots.empty());
  }
  CHECK(trajectory_of("x = \"20 mm * sin(2*pi*t/4 s)\"").knots.empty());
}

TEST_CASE("a thousand turns away from zero rounding is still told from a jump") {
  // |sin|^3 is smooth to its acceleration at all its 2399 zeros; |sin| is not to its rate.
  CHECK(trajectory_of("x = \"1 mm * (abs(sin(2*pi*2*t/1 s)))^3\"", "600 s").breaks.empty());
  const mechanics::Trajectory m = trajectory_of("x = \"1 mm * abs(sin(2*pi*2*t/1 s))\"", "600 s");
  REQUIRE(m.breaks.size() == 2399);
  CHECK(m.breaks.back().of == Break::Of::rate);
  CHECK(m.breaks.back().time == Approx(599.75));
  CHECK(m.breaks.back().jump == Approx(2e-3 * 4 * 3.14159265358979323846));
}

TEST_CASE("knots and breaks of several coordinates stand together, by time, and end with the motion") {
  mechanics::Trajectory m = trajectory_of("x = \"1 mm * abs(t/1 s - 3)\"\nphi = \"1 deg * abs(t/1 s - 1.5)\"");
  REQUIRE(m.breaks.size() == 2);
  CHECK(m.breaks[0].what == "phi");
  CHECK(m.breaks[0].unit == "rad");
  CHECK(m.breaks[1].what == "x");
  CHECK(m.knots.size() == 2);
  mechanics::cut_off(m, 11);  // to 2.1 s
  CHECK(m.knots.size() == 1);
  CHECK(m.breaks.size() == 1);
}

TEST_CASE("a motion without a bound between its samples is refused with the time") {
  const auto tell = [](const std::string& law) { return told(moving_until("x = \"" + law + "\"", "2 s", 21)); };
  CHECK_THAT(tell("1 mm * sqrt(abs(t/1 s - 1.05))"), Contains("a.toml:9:5: error: x has no finite rate at t = 1.05 s"));
  CHECK_THAT(tell("1 mm/(t/1 s - 1.05)^2"), Contains("x has no finite value at t = 1.05 s"));
  CHECK_THAT(tell("1 mm * (abs(t/1 s - 1.05))^1.5"), Contains("x has no finite acceleration at t = 1.05 s"));
  CHECK_THAT(tell("1e300 m"), Contains("a.toml:9:5: error: x is 1e300 m at t = 0 s, out of all proportion to a machine"));
  CHECK_THAT(told(moving_until("x_rate = \"1 mm/s * tan(t/1 s)\"", "2 s", 20)), Contains("x has no finite rate at t = 1.57"));
  CHECK_THAT(tell("1 mm * sin(1 s/(t - 1.05 s))"), Contains("x wavers or switches more often over 2 s than can be looked at"));
}

TEST_CASE("points are knots, and a curve through them has no breaks") {
  const mechanics::Trajectory m = trajectory_of(
      "profile = \"cubic-spline\"\n[[motion.waypoint]]\ntime = \"0 s\"\n[[motion.waypoint]]\ntime = \"1 s\"\nx = \"10 "
      "mm\"\n[[motion.waypoint]]\ntime = \"3 s\"\nx = \"-5 mm\"\n[[motion.waypoint]]\ntime = \"4 s\"");
  CHECK(m.knots == std::vector<double>{1, 3});
  CHECK(m.breaks.empty());
}
