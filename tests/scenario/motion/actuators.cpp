// Motions that prescribe the actuators, and rates. The stage's actuators are its slide, q = x, and its turn psi, which is phi or follows
// from the feeler's height, y = r sin psi: every pose can be worked out by hand.
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <core/numbers.hpp>
#include <core/scenario/expression/integral.hpp>
#include <random>
#include <tests/given/slider_crank.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;

namespace {

std::string moving(std::string_view motion, std::string_view parameters = "dependent = \"phi\"") {
  return "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\nparameters = { " + std::string(parameters) +
         " }\n[[section]]\nkind = \"displacement\"\n[motion]\n" + std::string(motion);
}
Loaded loaded(const std::string& text, const std::filesystem::path& file = "a.toml") {
  INFO(told(text, file));
  return load_text(text, file, stage::source(), section::kinds());
}

}  // namespace

TEST_CASE("an integral is exact for polynomials and for waves, at and between its knots") {
  const Integral cube([](double t) { return 3 * t * t; }, 5, {0, 0.5, 2, 3});
  const Integral wave([](double t) { return std::cos(3 * t); }, 0, {0, 1, 2, 3});
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> times(0, 3);
  for (int i = 0; i < 100; ++i) {
    const double t = times(generator);
    CAPTURE(t);
    CHECK(cube.at(t) == Approx(5 + t * t * t).epsilon(1e-14));  // a dozen roundings
    CHECK(wave.at(t) == Approx(std::sin(3 * t) / 3).margin(1e-14));
  }
}

TEST_CASE("a kink costs an integral no accuracy worth naming") {
  const Integral kink([](double t) { return std::abs(t - 0.3); }, 0, {0, 1});
  CHECK(kink.at(1) == Approx(0.5 * (0.09 + 0.49)).epsilon(1e-12));
  CHECK_FALSE(std::isfinite(Integral([](double t) { return std::log(t - 2); }, 0, {0, 1}).at(1)));
}

TEST_CASE("an integral knows what it leaves open") {
  CHECK(Integral([](double t) { return 3 * t * t; }, 5, {0, 0.5, 3}).error() == 0);
  const Integral jump([](double t) { return t < 0.3 ? 0.0 : 1.0; }, 0, {0, 1});
  CHECK(jump.at(1) == Approx(0.7));
  CHECK(jump.error() > 0);     // a jump is never enclosed
  CHECK(jump.error() < 1e-8);  // but to a billionth of the panel
  CHECK(jump.magnitude() == Approx(0.7));
}

TEST_CASE("a rate that wavers twelve thousand times is integrated to its end, and between") {
  // sin^2 w t = (1 - cos 2 w t) / 2, w = 2 pi 20 / s
  const Loaded l = loaded(moving("duration = \"600 s\"\nsamples = 121\nx_rate = \"0.5 mm/s * (sin(2*pi*20*t/1 s))^2\"\n", ""));
  const double w = 2 * pi * 20;
  const auto place = [&](double t) { return 0.5e-3 * (t / 2 - std::sin(2 * w * t) / (4 * w)); };
  CHECK(l.trajectory.value(120, 0) == Approx(0.15).epsilon(1e-12));
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> times(0, 600);
  for (int i = 0; i < 50; ++i) {
    const double t = times(generator);
    double q[2], rate[2], acceleration[2];
    REQUIRE(l.trajectory.at(t, q, rate, acceleration));
    CHECK(q[0] == Approx(place(t)).epsilon(1e-12));  // of a phase of 75,000 radians eleven digits of rounding are left
  }
}

TEST_CASE("a rate is integrated from home, and its derivative is exact") {
  const Loaded l = loaded(moving("duration = \"2 s\"\nsamples = 9\nx_rate = \"3 mm/s^3 * t^2\"\n", ""));
  const mechanics::Trajectory& m = l.trajectory;
  const MotionRequest& asked = l.scenario.motion.value();
  for (Eigen::Index i = 0; i < 9; ++i) {
    const double t = m.time[static_cast<std::size_t>(i)];
    CHECK(m.value(i, 0) == Approx(1e-3 * t * t * t).margin(1e-18));
    CHECK(m.rate(i, 0) == Approx(3e-3 * t * t).margin(1e-18));
    CHECK(m.acceleration(i, 0) == Approx(6e-3 * t).margin(1e-18));
  }
  CHECK_FALSE(asked.by_actuators());
  CHECK(asked.description == "x_rate = 3 mm/s^3 * t^2\nphi = 0° (home)");
  double x[2], rate[2], acceleration[2];
  REQUIRE(m.at(1.33, x, rate, acceleration));
  CHECK(x[0] == Approx(1e-3 * 1.33 * 1.33 * 1.33));
}

TEST_CASE("coordinates follow the actuators with their exact rates and accelerations") {
  // y = r sin psi, psi = 0.2 rad/s^2 t^2 / 2
  const Loaded l = loaded(moving("duration = \"2 s\"\nsamples = 21\npsi_rate = \"0.2 rad/s^2 * t\"\nq = \"5 mm + 1 mm/s * t\"\n"));
  const mechanics::Trajectory& m = l.trajectory;
  const MotionRequest& asked = l.scenario.motion.value();
  CHECK(asked.by_actuators());
  CHECK(m.ending.empty());
  CHECK(asked.end == 2);
  CHECK(asked.description == "q = 5 mm + 1 mm/s * t\npsi_rate = 0.2 rad/s^2 * t");
  const auto check = [&](double t, double x, double y, double rate, double acceleration) {
    CAPTURE(t);
    const double psi = 0.1 * t * t, v = 0.2 * t, a = 0.2, r = 0.2;
    CHECK(x == Approx(0.005 + 0.001 * t));  // starts off home
    // forward displacement solves to 1e-14 of the size; conditions here are about 1
    CHECK(y == Approx(r * std::sin(psi)).margin(1e-13));
    CHECK(rate == Approx(r * std::cos(psi) * v).margin(1e-13));
    CHECK(acceleration == Approx(r * (std::cos(psi) * a - std::sin(psi) * v * v)).margin(1e-12));
  };
  for (Eigen::Index i = 0; i < 21; ++i)
    check(m.time[static_cast<std::size_t>(i)], m.value(i, 0), m.value(i, 1), m.rate(i, 1), m.acceleration(i, 1));
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> times(0, 2);
  for (int i = 0; i < 50; ++i) {  // at any time between samples, and what is prescribed beside it
    const double t = times(generator);
    double q[2], rate[2], acceleration[2];
    REQUIRE(m.at(t, q, rate, acceleration));
    check(t, q[0], q[1], rate[1], acceleration[1]);
    REQUIRE(asked.prescribed(t, q, rate, acceleration));
    CHECK(q[1] == Approx(0.1 * t * t).margin(1e-15));
    CHECK(rate[1] == Approx(0.2 * t));
  }
  double q[2], rate[2], acceleration[2];
  CHECK_FALSE(m.at(-1, q, rate, acceleration));
}

TEST_CASE("actuators that leave the reach end the motion there, and say when and why") {
  // psi = 80 deg/s t is beyond 90 deg, where the feeler stands upright, from t = 1.125 s on.
  const std::string keys = "duration = \"2 s\"\nsamples = 21\npsi = \"80 deg/s * t\"\n";
  const Loaded l = loaded(moving(keys));
  const mechanics::Trajectory& m = l.trajectory;
  CHECK_THAT(m.ending,
             Contains("runs out of reach at t = 1.125 s: beyond it no pose of this assembly and working mode has the actuator values"));
  CHECK(m.time.size() == 21);
  CHECK(m.value.topRows(12).allFinite());
  CHECK_FALSE(m.value.bottomRows(9).array().isFinite().any());
  double q[2], rate[2], acceleration[2];
  CHECK(m.at(1.12, q, rate, acceleration));
  CHECK_FALSE(m.at(1.13, q, rate, acceleration));
  // The edge of reach is no singular surface: until = "singularity" does not excuse it.
  const Loaded until = loaded(moving(keys + "until = \"singularity\"\n"));
  CHECK(until.trajectory.time.size() == 21);
  CHECK_THAT(
      told(moving("duration = \"2 s\"\nsamples = 21\npsi = \"100 deg\"\n")),
      Contains("a.toml:10:7: error: the actuators cannot be brought from home to their first values: 90 % of the way there is the edge of "
               "reach") &&
          Contains("start nearer to home, where q = 0 mm, psi = 0 °"));
}

TEST_CASE("waypoints and files may name actuators") {
  const Folder folder;
  folder.write("motion.csv", "t [s], psi [deg]\n0,0\n1,10\n2,40\n3,90\n");
  const std::filesystem::path file = folder.path() / "a.toml";
  const Loaded from_file = loaded(moving("file = \"motion.csv\"\n", ""), file);
  CHECK(from_file.scenario.motion->by_actuators());
  CHECK(from_file.trajectory.value(2, 1) == Approx(40 * pi / 180));
  const Loaded points =
      loaded(moving("profile = \"quintic\"\nsamples = 5\n[[motion.waypoint]]\ntime = \"0 s\"\n[[motion.waypoint]]\ntime = \"4 "
                    "s\"\npsi = \"30 deg\"\n"));
  CHECK(points.scenario.motion->by_actuators());
  CHECK(points.trajectory.value(4, 1) == Approx(0.1).epsilon(1e-12));  // r sin 30 deg
  folder.write("mixed.csv", "t [s], x [mm], psi [deg]\n0,0,0\n1,10,1\n");
  CHECK_THAT(told(moving("file = \"mixed.csv\"\n", ""), file),
             Contains("mixed.csv:1:16: error: psi is an actuator, and x before it a coordinate"));
}

TEST_CASE("a motion prescribes coordinates or actuators, by value or by rate") {
  const auto tell = [](const std::string& lines) { return told(moving("duration = \"2 s\"\nsamples = 21\n" + lines, "")); };
  CHECK(
      tell("psi = \"3 deg\"\nx = \"1 mm\"\n") ==
      "a.toml:11:1: error: x is a coordinate, and psi before it an actuator: a motion prescribes coordinates or actuators, and the others "
      "follow\n  x = \"1 mm\"\n  ^\n  hint: keep to the coordinates x and phi, or to the actuators q and psi");
  CHECK_THAT(tell("q = \"1 mm\"\nq_rate = \"1 mm/s\"\n"), Contains("a.toml:11:1: error: q is given twice: by its value and by its rate"));
  CHECK_THAT(tell("q_rate = \"1 mm\"\n"), Contains("a.toml:10:10: error: expected a velocity") && Contains("seen a length"));
  CHECK_THAT(tell("psi_rat = \"1 deg/s\"\n"), Contains("unknown key \"psi_rat\" in [motion]; did you mean \"psi_rate\"?"));
  CHECK_THAT(tell("y_rate = \"1 mm/s\"\n"), Contains("y is a dependent coordinate of stage"));
  CHECK_THAT(tell("q_rate = \"1 mm / (t - 1 s)\"\n"), Contains("q has no finite"));
  CHECK_THAT(tell("until = \"never\"\n"), Contains("expected \"singularity\", seen \"never\""));
  CHECK_THAT(told(moving("file = \"a.csv\"\nq_rate = \"1 mm/s\"\n", "")), Contains("q is given twice: here and by the file"));
}

namespace {

// A slider-crank; its slider turns back at a dead centre. `theta` is the crank's angle, 0.8 rad at home, `s` the slider's travel.
scenario::MechanismSource crank() {
  return {[](const std::string& name) { return name == "crank" ? &test::slider_crank() : nullptr; }, {"crank"}};
}
Loaded cranked(const std::string& motion) {
  return load_text("title = \"Crank\"\n[mechanism]\nuse = \"crank\"\n[[section]]\nkind = \"velocity\"\n[motion]\n" + motion, "a.toml",
                   crank(), section::kinds());
}

}  // namespace

TEST_CASE("a motion that may last until a singular surface ends at the last sample before it, and names the time") {
  // Coordinates say when the dead centre is met; the slider driven along the same path has to find it there again.
  const Loaded by_angle = cranked("duration = \"2 s\"\nsamples = 41\nuntil = \"singularity\"\ntheta_rate = \"-1 rad/s\"\n");
  const mechanics::Trajectory& turned = by_angle.trajectory;
  REQUIRE_THAT(turned.ending, Contains("meets a singular surface at t = ") && Contains("there the actuators do not hold the platform"));
  CHECK(by_angle.scenario.motion->end == 2);
  CHECK(turned.value.allFinite());
  const double ending = std::stod(turned.ending.substr(turned.ending.find("t = ") + 4));
  CHECK(turned.time.back() < ending);
  CHECK(turned.time.back() + 0.05 > ending);
  CHECK(turned.rate.rows() == static_cast<Eigen::Index>(turned.time.size()));

  const mechanics::Machine& machine = *by_angle.machine;
  const auto slide = [&](double theta) { return machine.pose({&theta, 1}).numbers[machine.layout().actuator(0)]; };
  const double home = slide(0.8), dead = slide(0.8 - ending);
  // At the dead centre the slider stands still.
  CHECK(std::abs(slide(0.8 - ending + 1e-3) - slide(0.8 - ending - 1e-3)) < 1e-7);
  const std::string drive =
      fmt::format("duration = \"2 s\"\nsamples = 41\ns = \"{:.17g} m + {:.17g} m/s * t\"\n", home, (dead - home) / 1.02);
  const Loaded by_slide = cranked(drive + "until = \"singularity\"\n");
  const mechanics::Trajectory& pushed = by_slide.trajectory;
  CHECK_THAT(pushed.ending, Contains("meets a singular surface at t = 1.02 s: there the actuators no longer determine the pose"));
  CHECK(pushed.time.size() == 21);  // the last at 1 s
  CHECK(pushed.value.allFinite());
  CHECK(pushed.value(20, 0) > 0.8 - ending);
  double theta, rate, acceleration;
  CHECK(pushed.at(1.0199, &theta, &rate, &acceleration));
  CHECK_FALSE(pushed.at(1.0201, &theta, &rate, &acceleration));

  const Loaded beyond = cranked(drive);
  CHECK(beyond.trajectory.time.size() == 41);
  CHECK(beyond.trajectory.ending == pushed.ending);
  CHECK_FALSE(beyond.trajectory.value.bottomRows(20).array().isFinite().any());
}

TEST_CASE("a motion that meets a singular surface before its second sample is refused") {
  try {
    (void)cranked("duration = \"4 s\"\nsamples = 3\nuntil = \"singularity\"\ntheta_rate = \"-1 rad/s\"\n");
    FAIL("accepted");
  } catch (const ScenarioError& e) {
    CHECK_THAT(e.what(), Contains("a.toml:9:1: error: the motion has no second sample: it meets a singular surface at t = "));
  }
}
