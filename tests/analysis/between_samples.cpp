// What moves between the samples of a run, and a run at one time between them. The stage's slide has 5 kg.
#include <catch2/catch.hpp>

#include <core/analysis/samples/stretch.hpp>
#include <core/analysis/study/between_samples.hpp>
#include <core/analysis/study/instant.hpp>
#include <core/numbers.hpp>
#include <tests/analysis/run.hpp>
#include <tests/scenario/trial.hpp>

#include <cmath>

using namespace pmreport;
using analysis::ColumnId;
using trial::Run;

namespace {

// Two seconds of a motion, so many samples, these kinds of section.
Run moving(const std::string& motion, int samples, const std::vector<std::string>& kinds = {"displacement"}) {
  std::string text = "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n";
  for (const std::string& kind : kinds) text += "[[section]]\nkind = \"" + kind + "\"\n";
  return Run(text + "[motion]\nduration = \"2 s\"\nsamples = " + std::to_string(samples) + "\n" + motion);
}
std::vector<analysis::Unseen> unseen(const std::string& motion, int samples, const std::vector<std::string>& kinds = {"displacement"}) {
  return unseen_between_samples(moving(motion, samples, kinds).analysis);
}

const std::string shaking = "x = \"1 mm * sin(2*pi*10 Hz*t)\"\n";

}  // namespace

TEST_CASE("an oscillation whose samples all stand at its zeros is seen between them") {
  const auto found = unseen(shaking, 21);
  REQUIRE(found.size() == 1);
  CHECK(found[0].what == "x");
  CHECK(found[0].unit == "m");
  CHECK(found[0].of == analysis::OfMotion::value);
  CHECK(found[0].moves == Approx(0.002).epsilon(0.01));  // it is looked at every third of a radian: 1 - cos(1/6)
  CHECK(found[0].beyond == Approx(0.001).epsilon(0.015));
  CHECK(found[0].samples_move < 1e-15);
}

TEST_CASE("as many samples as are asked for show it, and a number that cannot is told whatever it hits") {
  const double enough = unseen(shaking, 21)[0].enough;
  CHECK(unseen(shaking, static_cast<int>(enough)).empty());
  // Of the largest, the samples then miss less than a hundredth of 2 mm.
  const Run r = moving(shaking, static_cast<int>(enough));
  CHECK(r.analysis.largest({ColumnId::named("x")}) > 0.98e-3);
  for (const int samples : {2, 3, 5, 11, 37, 41, 42, 61, 97}) {  // at most five a period
    CAPTURE(samples);
    CHECK_FALSE(unseen(shaking, samples).empty());
  }
  CHECK(unseen(shaking, 201).empty());
}

TEST_CASE("a tremor that moves nothing counts where accelerations are asked for") {
  // 0.05 um at 500 Hz beside 20 mm at 0.5 Hz: 0.5 m/s^2 beside 0.2 m/s^2.
  const std::string tremor = "x = \"20 mm * sin(2*pi*t/2 s) + 0.05 um * sin(2*pi*500 Hz*t)\"\n";
  CHECK(unseen(tremor, 101).empty());
  CHECK(unseen(tremor, 101, {"velocity"}).empty());  // 0.16 mm/s of 63 mm/s
  const auto found = unseen(tremor, 101, {"displacement", "acceleration"});
  REQUIRE(found.size() == 1);
  CHECK(found[0].of == analysis::OfMotion::acceleration);
  CHECK(found[0].unit == "m/s^2");
  CHECK(unseen(tremor, 101, {"dynamics"}).size() == 1);
}

TEST_CASE("what samples show is not told: slow motions, jumps of acceleration, coordinates at rest, noise") {
  CHECK(unseen("x = \"20 mm * sin(2*pi*t/2 s)\"\n", 15, {"acceleration"}).empty());
  CHECK(unseen("x = \"1 mm/s^2 * max(t - 1.01 s, 0 s)^2\"\n", 21, {"acceleration"}).empty());
  CHECK(unseen("x = \"10 mm * (sin(7*t/1 s)^2 + cos(7*t/1 s)^2)\"\n", 21, {"acceleration"}).empty());
  CHECK(unseen("x_rate = \"1 mm/s * (sin(2*pi*20*t/1 s))^2\"\n", 21).empty());  // it rises steadily: its samples show that
  CHECK(unseen("x_rate = \"1 mm/s * (sin(2*pi*20*t/1 s))^2\"\n", 21, {"velocity"}).size() == 1);
}

TEST_CASE("points that tremble are shown by samples at the points, and not by fewer") {
  const trial::Folder folder;
  std::string table = "t [s],x [mm]\n";
  for (int i = 0; i <= 200; ++i)
    table += std::to_string(0.01 * i) + "," + std::to_string(0.1 * i + 0.01 * ((i * i * 7919) % 13 - 6)) + "\n";
  folder.write("motion.csv", table);
  const auto of = [&](const std::string& samples) {
    const std::string text =
        "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n[[section]]\nkind = \"dynamics\"\n[motion]\nfile = \"motion.csv\"\n";
    const scenario::Loaded l = scenario::load_text(text + samples, folder.path() / "a.toml", stage::source(), section::kinds());
    return analysis::unseen_between_samples({l.scenario, l.trajectory, *l.machine, analysis::asked_by(l.scenario), {}});
  };
  CHECK(of("").empty());
  CHECK_FALSE(of("samples = 21\n").empty());
}

TEST_CASE("actuators and motions from forces are looked at too") {
  const auto driven = unseen("q = \"1 mm * sin(2*pi*10 Hz*t)\"\n", 21);
  REQUIRE(driven.size() == 1);
  CHECK(driven[0].what == "q");
  // A spring of 5 kg (20 pi)^2 from 1 mm off: 10 Hz.
  const auto sprung = unseen("from = \"forces\"\nstart = { x = \"1 mm\" }\n[motion.forces]\nq = \"-19739.2 N/m * q\"\n", 21, {"dynamics"});
  REQUIRE(sprung.size() == 1);
  CHECK(sprung[0].what == "x");
}

TEST_CASE("a load that the samples do not show is told where forces are asked for") {
  const std::string motion = "x = \"20 mm * sin(2*pi*t/2 s)\"\n",
                    load = "[load]\nmoment = [\"0 N*m\", \"0 N*m\", \"3 N*m * sin(2*pi*10 Hz*t)\"]\n";
  CHECK(unseen(motion + load, 21).empty());
  for (const char* kind : {"statics", "dynamics"}) {
    const auto found = unseen(motion + load, 21, {kind});
    REQUIRE(found.size() == 1);
    CHECK(found[0].what == "the load's moment about z");
    CHECK(found[0].unit == "N*m");
    CHECK(found[0].moves == Approx(6).epsilon(0.01));
    CHECK(unseen(motion + load, static_cast<int>(found[0].enough), {kind}).empty());
  }
}

TEST_CASE("at a time between two samples everything is as at a sample there") {
  const Run r = moving("x = \"20 mm * sin(2*pi*t/2 s)\"\n", 6, {"displacement", "velocity", "statics", "dynamics"});
  const analysis::Instant i(r.analysis, 0.7);
  const auto at = [&](const char* column) { return i.value(ColumnId::named(column)); };
  CHECK(at("x") == Approx(0.02 * std::sin(0.7 * pi)));
  CHECK(at("x_rate") == Approx(0.02 * pi * std::cos(0.7 * pi)));
  CHECK(at("q_dynamic_force") == Approx(-5 * 0.02 * pi * pi * std::sin(0.7 * pi)));
  CHECK(at("kinetic_energy") == Approx(2.5 * std::pow(0.02 * pi * std::cos(0.7 * pi), 2)));
  CHECK(std::isfinite(at("q_force")));
  CHECK(std::isnan(at("nothing")));
}

TEST_CASE("the load counts as it is at that time, and where there is no pose there is no value") {
  const Run loaded = moving("x = \"0 mm\"\n[load]\nforce = [\"-1 N * (t/1 s)^2\", \"0 N\", \"0 N\"]\n", 3, {"statics"});
  CHECK(analysis::Instant(loaded.analysis, 1.5).value(ColumnId::named("q_force")) == Approx(2.25));
  const Run r(trial::feeler_too_far);
  CHECK(std::isnan(analysis::Instant(r.analysis, 1.55).value(ColumnId::named("y"))));
  CHECK(analysis::Instant(r.analysis, 1.25).value(ColumnId::named("phi")) == Approx(std::asin(1.25 * 0.75)));
}

TEST_CASE("a stretch ends at the knots around a time") {
  mechanics::Trajectory m;
  m.knots = {1, 3};
  scenario::Load load;
  load.knots = {2};
  const std::vector<double> knots = analysis::knots_along(m, load);
  CHECK(knots == std::vector<double>{1, 2, 3});
  const auto at = [&](double t) {
    const analysis::Stretch s = analysis::stretch_at(knots, t, 0, 4);
    return std::pair{s.begin, s.end};
  };
  CHECK(at(0.5) == std::pair{0.0, 1.0});
  CHECK(at(1) == std::pair{1.0, 2.0});
  CHECK(at(3.5) == std::pair{3.0, 4.0});
  CHECK(at(4) == std::pair{3.0, 4.0});
}
