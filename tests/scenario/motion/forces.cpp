// Motions that follow from forces. The stage's carriage and table have 5 kg along the slide and the table 0.02 kg m^2 about its axis; the
// two move by themselves, so every motion can be worked out by hand.
#include <catch2/catch.hpp>
#include <core/scenario/expression/expression.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;

namespace {

std::string forced(std::string_view motion, std::string_view forces, std::string_view more = {}, std::string_view parameters = {}) {
  return "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\nparameters = { " + std::string(parameters) +
         " }\n[[section]]\nkind = \"displacement\"\n[motion]\nfrom = \"forces\"\nduration = \"2 s\"\nsamples = 21\n" + std::string(motion) +
         "[motion.forces]\n" + std::string(forces) + std::string(more);
}
Loaded loaded_text(const std::string& text) { return load_text(text, "a.toml", stage::source(), section::kinds()); }

// Steps err by 1e-10 of what they advance, and a few hundred add up.
constexpr double integrated = 1e-8;

}  // namespace

TEST_CASE("the forces of the actuators move the coordinates from where they start") {
  // x'' = -100/s^2 (x - 10 mm), phi'' = -phi'/s
  const Loaded l = loaded_text(forced("start = { x = \"30 mm\" }\nstart_rate = { phi = \"0.5 rad/s\" }\n",
                                      "q = \"-500 N/m * (q - 10 mm)\"\npsi = \"-0.02 N*m*s/rad * psi_rate\"\n"));
  const mechanics::Trajectory& m = l.trajectory;
  const MotionRequest& asked = l.scenario.motion.value();
  CHECK(asked.by_forces());
  CHECK_FALSE(asked.by_actuators());
  CHECK(m.ending.empty());
  CHECK(asked.end == 2);
  CHECK(asked.description ==
        "force of q = -500 N/m * (q - 10 mm)\nforce of psi = -0.02 N*m*s/rad * psi_rate\nstart: x = 30 mm, phi_rate = 0.5 rad/s");
  REQUIRE(m.time.size() == 21);
  const auto check = [](double t, const double* value, const double* rate, const double* acceleration) {
    CAPTURE(t);
    CHECK(value[0] == Approx(0.01 + 0.02 * std::cos(10 * t)).margin(integrated));
    CHECK(rate[0] == Approx(-0.2 * std::sin(10 * t)).margin(integrated));
    CHECK(acceleration[0] == Approx(-2 * std::cos(10 * t)).margin(100 * integrated));
    CHECK(value[1] == Approx(0.5 * (1 - std::exp(-t))).margin(integrated));
    CHECK(rate[1] == Approx(0.5 * std::exp(-t)).margin(integrated));
  };
  for (Eigen::Index i = 0; i < 21; ++i) {
    const Eigen::Vector2d value = m.value.row(i), rate = m.rate.row(i), acceleration = m.acceleration.row(i);
    check(m.time[static_cast<std::size_t>(i)], value.data(), rate.data(), acceleration.data());
  }
  for (const double t : {0.0333, 0.777, 1.951}) {
    double value[2], rate[2], acceleration[2];
    REQUIRE(m.at(t, value, rate, acceleration));
    check(t, value, rate, acceleration);
  }
  // What is stored in the end less what was in the beginning.
  const double swing = 0.2 * std::sin(20), turn = 0.5 * std::exp(-2.0);
  CHECK(m.work == Approx(0.5 * 5 * swing * swing + 0.5 * 0.02 * (turn * turn - 0.25)).margin(integrated));
  CHECK(m.energy_drift_share < integrated);
  CHECK(m.energy_drift >= 0);
}

TEST_CASE("one force may stand for all, with the actuator's own value, rate and home: a name beside it overrides") {
  const Loaded l = loaded_text(
      forced("start = { phi = \"0.1 rad\" }\n", "all = \"-2 N*m/rad * (value - home) - 0.04 N*m*s/rad * rate\"\nq = \"1 N\"\n"));
  const mechanics::Trajectory& m = l.trajectory;
  const MotionRequest& asked = l.scenario.motion.value();
  // phi'' = -100 phi - 2 phi'
  const double w = std::sqrt(99.0);
  for (Eigen::Index i = 0; i < 21; ++i) {
    const double t = m.time[static_cast<std::size_t>(i)];
    CHECK(m.value(i, 0) == Approx(0.1 * t * t).margin(integrated));
    CHECK(m.value(i, 1) == Approx(0.1 * std::exp(-t) * (std::cos(w * t) + std::sin(w * t) / w)).margin(integrated));
  }
  CHECK(asked.description ==
        "force of each actuator = -2 N*m/rad * (value - home) - 0.04 N*m*s/rad * rate\nforce of q = 1 N\nstart: phi = 0.1 "
        "rad, at rest");
}

TEST_CASE("a force may name the other actuators and the time: who is not named exerts none") {
  // phi = 0.3 rad/s t drives the slide: x'' = 0.06 t + 0.1 t^2.
  const Loaded l = loaded_text(forced("start_rate = { phi = \"0.3 rad/s\" }\n", "q = \"1 N/rad * psi + 0.5 N/s^2 * t^2\"\n"));
  const mechanics::Trajectory& m = l.trajectory;
  const MotionRequest& asked = l.scenario.motion.value();
  for (Eigen::Index i = 0; i < 21; ++i) {
    const double t = m.time[static_cast<std::size_t>(i)];
    CHECK(m.value(i, 1) == Approx(0.3 * t).margin(integrated));
    CHECK(m.value(i, 0) == Approx(0.01 * t * t * t + t * t * t * t / 120).margin(integrated));
  }
  CHECK_THAT(asked.description, Contains("\nno force of psi\nstart: home, phi_rate = 0.3 rad/s"));
}

TEST_CASE("load and gravity act on a motion from forces, and the load is known at any time") {
  const Loaded l =
      loaded_text(forced("", "",
                         "[load]\nforce = [\"1 N\", \"0 N\", \"0 N\"]\nmoment = [\"0 N*m\", \"0 N*m\", \"10 N*mm * sin(t/1 s)\"]\n"
                         "gravity = [\"-0.3 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n"));
  const Scenario& s = l.scenario;
  const mechanics::Trajectory& m = l.trajectory;
  for (Eigen::Index i = 0; i < 21; ++i) {
    const double t = m.time[static_cast<std::size_t>(i)];
    CHECK(m.value(i, 0) == Approx(0.5 * (1.0 / 5 - 0.3) * t * t).margin(integrated));
    CHECK(m.value(i, 1) == Approx(0.5 * (t - std::sin(t))).margin(integrated));
  }
  const Eigen::Matrix<double, 6, 1> wrench = s.load.at(0.7);
  CHECK(wrench(0) == 1);
  CHECK(wrench(5) == Approx(0.01 * std::sin(0.7)));
  CHECK(s.load.moment[7].z() == Approx(0.01 * std::sin(0.7)));
  CHECK(s.motion->description == "no force of q and psi\nstart: home, at rest");
}

TEST_CASE("what ends a motion from forces is told, and allowed when the scenario says so") {
  // x = 0.6 m/s^2 t^2 reaches 500 mm at t = sqrt(5/6) s.
  const Loaded l = loaded_text(forced("", "q = \"6 N\"\n"));
  const mechanics::Trajectory& m = l.trajectory;
  CHECK(m.ending == "ends at t = 0.912871 s: q (slide) reaches the upper end of its stroke, 500 mm");
  CHECK(m.time.size() == 21);
  CHECK(m.value.topRows(10).allFinite());
  CHECK_FALSE(m.value.bottomRows(11).array().isFinite().any());
  double q[2], rate[2], acceleration[2];
  CHECK(m.at(0.9128, q, rate, acceleration));
  CHECK_FALSE(m.at(0.9129, q, rate, acceleration));
  CHECK(m.work == Approx(6 * 0.6 * 0.81).epsilon(integrated));  // to the last sample with a pose, 0.9 s

  const Loaded shortened = loaded_text(forced("until = \"limit\"\n", "q = \"6 N\"\n"));
  const mechanics::Trajectory& cut = shortened.trajectory;
  CHECK(cut.ending == m.ending);
  CHECK(cut.time.size() == 10);
  CHECK(cut.value.allFinite());
  CHECK(shortened.scenario.motion->end == 2);
  CHECK(shortened.scenario.motion->until_singularity);
  const mechanics::Trajectory not_excused = loaded_text(forced("until = \"singularity\"\n", "q = \"6 N\"\n")).trajectory;
  CHECK(not_excused.time.size() == 21);
  CHECK_THAT(told(forced("until = \"limit\"\n", "q = \"6 kN\"\n")),
             Contains("a.toml:7:2: error: the motion has no second sample: it ends at t = 0.02"));

  const mechanics::Trajectory edge = loaded_text(forced("start_rate = { y = \"300 mm/s\" }\n", "", "", "dependent = \"phi\"")).trajectory;
  CHECK_THAT(edge.ending, Contains("psi (turn) reaches the upper end of its stroke, 63.0254°"));
}

TEST_CASE("a check may look no farther than a motion that was cut off") {
  const std::string late = "[[check]]\nthat = \"at(q, 1.5 s)\"\nbelow = \"1 m\"\n";
  CHECK_THAT(told(forced("until = \"limit\"\n", "q = \"6 N\"\n", late)),
             Contains("expected a time within the motion, 0 s to 0.9 s, seen 1.5 s"));
  CHECK(told(forced("", "q = \"1 N\"\n", late)).empty());
}

TEST_CASE("mistakes in the forces are told where they stand") {
  const auto tell = [](const std::string& line) { return told(forced("", line + "\n")); };
  CHECK(tell("q = \"3 mm\"") == "a.toml:12:5: error: expected a force (e.g. \"10 N\"), seen a length\n  q = \"3 mm\"\n      ^");
  CHECK_THAT(tell("psi = \"3 N\""), Contains("a.toml:12:7: error: expected a moment (e.g. \"10 N*m\"), seen a force"));
  CHECK_THAT(tell("q = 3"), Contains("a.toml:12:5: error: expected a force") && Contains("without a unit"));
  CHECK_THAT(tell("q = \"-500 N/m * q_rate + 1 N\""), Contains("error: cannot add m*kg/s^3 and a force"));
  CHECK_THAT(tell("q = \"-500 N/m * psi_rat\""),
             Contains("a.toml:12:17: error: unknown unit or name \"psi_rat\"; did you mean \"psi_rate\"?") &&
                 Contains("hint: the quantities are t, value, rate, home, q, q_rate, psi and psi_rate; the units are"));
  CHECK_THAT(tell("q = \"1 N * 2^(q/1 m)\""), Contains("expected a constant exponent, seen one that depends on q"));
  CHECK_THAT(tell("r = \"1 N\""),
             Contains("a.toml:12:1: error: unknown key \"r\" in [motion.forces]") && Contains("the keys are all, q and psi"));
  CHECK_THAT(tell("all = \"1 N\""),
             Contains("a.toml:12:1: error: expected forces by name, seen one for all: q is linear, and psi is rotary"));
  CHECK_THAT(tell("q = \"1 N / (q/1 mm)\""), Contains("a.toml:12:5: error: the force of q has no finite value at t = 0 s"));
  CHECK_THAT(tell("q = nan"), Contains("expected a finite number") && Contains("seen nan"));
  CHECK(tell("q = \"1 N * sqrt(1 - t/1 s)\"").empty());
  CHECK_THAT(loaded_text(forced("", "q = \"1 N * sqrt(1 - t/1 s)\"\n")).trajectory.ending,
             Contains("ends at t = 1 s: the force of q has no finite value"));
}

TEST_CASE("mistakes in what surrounds the forces are told where they stand") {
  const auto tell = [](const std::string& line) { return told(forced(line + "\n", "q = \"1 N\"\n")); };
  CHECK_THAT(tell("x = \"1 mm\""), Contains("a.toml:11:1: error: x is prescribed, and the motion follows from forces") &&
                                       Contains("hint: say where it begins, start = { x = ... }, or remove from = \"forces\""));
  CHECK_THAT(tell("psi_rate = \"1 rad/s\""), Contains("psi_rate is prescribed") && Contains("give its force in [motion.forces]"));
  CHECK_THAT(tell("file = \"a.csv\""), Contains("a.toml:11:1: error: file is of a prescribed motion, and this one follows from forces"));
  CHECK_THAT(tell("until = \"never\""), Contains("expected \"singularity\" or \"limit\", seen \"never\""));
  CHECK_THAT(tell("strat = { x = \"1 mm\" }"), Contains("unknown key \"strat\" in [motion]; did you mean \"start\"?") &&
                                                   Contains("the keys are from, duration, samples, until, start, start_rate and forces"));
  CHECK_THAT(tell("start = \"home\""), Contains("a.toml:11:1: error: expected a table [motion.start], seen the text \"home\""));
  CHECK_THAT(tell("start = { x = \"5 deg\" }"), Contains("a.toml:11:15: error: expected a length") && Contains("seen an angle"));
  CHECK_THAT(tell("start = { z = \"5 mm\" }"), Contains("a.toml:11:11: error: unknown key \"z\" in motion.start"));
  CHECK_THAT(tell("start = { y = \"5 mm\" }"), Contains("y is a dependent coordinate of stage"));
  CHECK_THAT(tell("start = { x = nan }"), Contains("seen nan"));
  CHECK_THAT(tell("start_rate = { x = \"5 mm\" }"), Contains("expected a velocity") && Contains("seen a length"));
  CHECK(tell("start = { x = \"600 mm\" }") ==
        "a.toml:11:1: error: the motion cannot begin: q (slide) is 100 mm beyond the upper end of its stroke, 500 mm\n"
        "  start = { x = \"600 mm\" }\n  ^");
  CHECK_THAT(told(forced("start = { y = \"250 mm\" }\n", "", "", "dependent = \"phi\"")),
             Contains("the motion cannot begin: the mechanism cannot be assembled there: the feeler is too short"));
  std::string text = forced("", "");
  CHECK_THAT(told(text.replace(text.find("[motion.forces]"), 15, "")),
             Contains("a.toml:7:2: error: expected the key \"forces\" in [motion], which is not there") &&
                 Contains("add a line: [motion.forces], and below it a line for each actuator that pushes or pulls: q = \"10 N\""));
  text = forced("", "q = \"1 N\"\n");
  CHECK_THAT(told(text.replace(text.find("\"forces\""), 8, "\"force\"")),
             Contains("a.toml:8:8: error: expected \"forces\", seen \"force\""));
  text = forced("", "q = \"1 N\"\n");
  CHECK_THAT(told(text.replace(text.find("from = \"forces\"\n"), 16, "")),
             Contains("a.toml:10:9: error: forces is of a motion that follows from forces, and this one is prescribed") &&
                 Contains("add from = \"forces\", or remove it"));
}

TEST_CASE("variables of an expression have their dimensions, and units keep their names") {
  const Variable variables[] = {{"q1", {1, 0, 0, 0}}, {"q1_rate", {1, 0, -1, 0}}};
  const Expression e = Expression::parse("3 N/mm*q1 + 2 N*s/m * q1_rate", Time::allowed, variables);
  CHECK(e.dimension() == Dimension{1, 1, -2, 0});
  const Jet<double> values[] = {{0.5, 2, 0}, {2, 0, 0}};
  CHECK(e.at(0, values).value == Approx(1504));
  CHECK(e.at(0, values).rate == Approx(6000));
  CHECK(Expression::parse("max(q1, 20 mm)", Time::allowed, variables).at(0, values).value == 0.5);
  CHECK_THROWS_WITH(Expression::parse("2 q1", Time::allowed, variables), Contains("expected an operator"));
  CHECK_THROWS_WITH(Expression::parse("q1 + q1_rate", Time::allowed, variables), Contains("cannot add a length and a velocity"));
  CHECK_THROWS_WITH(Expression::parse("q1", Time::allowed), Contains("unknown unit or name \"q1\""));
  const Variable second[] = {{"s", {1, 0, 0, 0}}};  // whoever offers it gets the unit all the same
  CHECK(Expression::parse("s", Time::allowed, second).dimension() == Dimension{0, 0, 1, 0});
}
