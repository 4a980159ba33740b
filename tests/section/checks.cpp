// The gates: reductions worked out by hand, verdicts and their sentences.
#include <catch2/catch.hpp>

#include <reports/section/checks.hpp>
#include <tests/analysis/run.hpp>
#include <tests/scenario/trial.hpp>

#include <cmath>

using namespace pmreport;

namespace {

// x runs from 0 to 20 mm in 20 equal steps.
std::vector<document::Check> checks(const std::string& more) {
  const std::string text = trial::with("20 mm * sin(2*pi*t/10 s)", "10 mm * t / 1 s") + more;
  const scenario::Loaded loaded = scenario::load_text(text, "a.toml", stage::source(), section::kinds());
  return section::evaluate_checks(
      section::Analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}), {});
}

document::Check check(const std::string& that, const std::string& bound) {
  return checks("[[check]]\nthat = \"" + that + "\"\n" + bound + "\n")[0];
}

}  // namespace

TEST_CASE("min, max, rms and at reduce a column as their names say") {
  CHECK(check("max(x)", "below = \"1 m\"").value == Approx(0.020));
  CHECK(check("min(x)", "below = \"1 m\"").value == Approx(0.0).margin(1e-15));
  CHECK(check("rms(x)", "below = \"1 m\"").value == Approx(0.001 * std::sqrt(20.0 * 21 * 41 / 6 / 21)));  // sum of squares
  CHECK(check("at(x, 0.55 s)", "below = \"1 m\"").value == Approx(0.0055));                               // between two samples
}

TEST_CASE("a bound that is only met is broken: below and above are strict") {
  CHECK_FALSE(check("max(x)", "below = \"20 mm\"").passed);
  CHECK(check("max(x)", "below = \"20.001 mm\"").passed);
  CHECK_FALSE(check("max(x)", "above = \"20 mm\"").passed);
}

TEST_CASE("a broken gate says where, what was measured and what was demanded") {
  const document::Check c = check("max(x)", "below = \"15 mm\"");
  CHECK_FALSE(c.passed);
  CHECK(c.name == "max(x) < 15 mm");
  CHECK(c.measured == "20 mm");
  CHECK(c.message == "t = 2 s: max(x): x is 20 mm, which is not below 15 mm");
  CHECK(c.line > 0);
}

TEST_CASE("a gate is told in the unit of its author") {
  const document::Check broken = check("max(x)", "below = \"1.5 cm\"");
  CHECK(broken.name == "max(x) < 1.5 cm");
  CHECK(broken.measured == "2 cm");
  CHECK(broken.limit == "< 1.5 cm");
  CHECK(broken.message == "t = 2 s: max(x): x is 2 cm, which is not below 1.5 cm");
  CHECK(broken.value == Approx(0.02));
  CHECK(broken.bound == Approx(0.015));
  CHECK(broken.unit == "m");
  // The slide q goes at 10 mm/s.
  const auto of = [](const std::string& bound) {
    return checks("[[section]]\nkind = \"velocity\"\n[[check]]\nthat = \"max(velocity_x)\"\n" + bound + "\n")[0];
  };
  CHECK(of("below = \"36 m/min\"").name == "max(velocity_x) < 36 m/min");
  CHECK(of("below = \"36 m/min\"").measured == "0.6 m/min");
  CHECK(of("equals = \"(5 + 5) * mm/s\"\nwithin = \"1 cm/s\"").name == "max(velocity_x) = 10 mm/s ± 10 mm/s");
  CHECK(of("below = \"2 m / 4 s\"").name == "max(velocity_x) < 500 mm/s");  // of no unit alone
  CHECK(check("max(abs(psi))", "below = \"1 rad\"").name == "max(abs(psi)) < 1 rad");
  CHECK(check("max(abs(psi))", "below = \"1 rad\"").measured.ends_with(" rad"));
  CHECK(check("max(abs(psi))", "below = \"57 deg\"").limit == "< 57°");
}

TEST_CASE("both bounds of a gate are judged") {
  CHECK(check("max(x)", "below = \"30 mm\"\nabove = \"10 mm\"").passed);
  CHECK_FALSE(check("max(x)", "below = \"30 mm\"\nabove = \"25 mm\"").passed);
}

TEST_CASE("a gate broken by little shows by how much") {
  const document::Check c = check("max(x)", "below = \"19.9999999 mm\"");
  CHECK(c.measured == "20.0000000 mm");
  CHECK(c.message == "t = 2 s: max(x): x is 20.0000000 mm, which is not below 19.9999999 mm");
  CHECK(c.name == "max(x) < 19.9999999 mm");
}

TEST_CASE("equals holds within its distance, on both sides") {
  CHECK(check("max(x)", "equals = \"20.5 mm\"\nwithin = \"1 mm\"").passed);
  CHECK(check("max(x)", "equals = \"19.5 mm\"\nwithin = \"1 mm\"").passed);
  CHECK_FALSE(check("max(x)", "equals = \"21.5 mm\"\nwithin = \"1 mm\"").passed);
  CHECK_FALSE(check("max(x)", "equals = \"18.5 mm\"\nwithin = \"1 mm\"").passed);
  const document::Check c = check("max(x)", "equals = \"15 mm\"\nwithin = \"1 mm\"");
  CHECK(c.name == "max(x) = 15 mm ± 1 mm");
  CHECK(c.message == "t = 2 s: max(x): x is 20 mm, which is not within 1 mm of 15 mm");
  CHECK(c.measured == "20 mm");
  CHECK(c.bound == Approx(0.015));
}

TEST_CASE("a count equals a number exactly") {
  const scenario::Loaded loaded = scenario::load_text(
      trial::with("10 s", "10 s") + "[[section]]\nkind = \"mobility\"\n[[check]]\nthat = \"mobility.freedoms\"\nequals = 2\n", "a.toml",
      stage::source(), section::kinds());
  const section::Analysis a(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {});
  CHECK(section::evaluate_checks(a, {{"mobility", "freedoms", "", 2}})[0].passed);
  const document::Check broken = section::evaluate_checks(a, {{"mobility", "freedoms", "", 3}})[0];
  CHECK_FALSE(broken.passed);
  CHECK(broken.name == "mobility.freedoms = 2");
  CHECK(broken.message == "mobility.freedoms: it is 3, which is not 2");
}

TEST_CASE("of a group every column must equal, and the farthest is told") {
  // The carriage runs along X at 10 mm/s: along Y and Z it does not move.
  const auto of_group = [](const char* equals) {
    return checks("[[section]]\nkind = \"velocity\"\n[[check]]\nthat = \"max(velocity)\"\nequals = \"" + std::string(equals) +
                  "\"\nwithin = \"6 mm/s\"\n")[0];
  };
  CHECK(of_group("5 mm/s").passed);
  CHECK_THAT(of_group("10 mm/s").message, Catch::Contains("velocity_y is 0 mm/s, which is not within 6 mm/s of 10 mm/s") ||
                                              Catch::Contains("velocity_z is 0 mm/s, which is not within 6 mm/s of 10 mm/s"));
  CHECK_THAT(of_group("1 mm/s").message, Catch::Contains("velocity_x is 10 mm/s, which is not within 6 mm/s of 1 mm/s"));
}

TEST_CASE("a gate without a value says why, and nothing is compared with it") {
  const std::string text = trial::feeler_too_far + "[[check]]\nthat = \"at(phi, 1.9 s)\"\nbelow = \"1 rad\"\n";
  const scenario::Loaded loaded = scenario::load_text(text, "a.toml", stage::source(), section::kinds());
  const auto all = section::evaluate_checks(
      section::Analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}), {});
  CHECK_FALSE(all[0].passed);
  CHECK(all[0].measured == "no value");
  CHECK(all[0].message == "at(phi, 1.9 s) has no value: phi has none at that time: the feeler is too short");
}

TEST_CASE("of limits that are broken the worst is told first") {
  // The slide leaves its 500 mm by 10 mm from 2 s on; the turn leaves its 63 degrees by 37, from 1.3 s on.
  std::string text = trial::with("20 mm * sin(2*pi*t/10 s)", "255 mm * t / 1 s");
  text.replace(text.find("\"5 deg\""), 7, "\"50 deg * t / 1 s\"");
  const scenario::Loaded broken = scenario::load_text(text, "a.toml", stage::source(), section::kinds());
  const section::Analysis a(broken.scenario, broken.trajectory, *broken.machine, analysis::asked_by(broken.scenario), {});
  REQUIRE(a.breaches().front().subject == "q (slide)");  // the first, and by far not the worst
  const auto demands = section::evaluate_checks(a, {});
  CHECK(demands[1].measured == "at 13 of 21 samples");
  CHECK_THAT(demands[1].message, Catch::StartsWith("psi leaves its stroke from t = 1.2") &&
                                     Catch::Contains(" s to 2 s, at most by 37° (100° at t = 2 s, its stroke ends at 63.03°)"));
}

TEST_CASE("every report demands reach, limits and regular poses of its motion") {
  const auto sound = checks("");
  REQUIRE(sound.size() == 3);
  for (const auto& c : sound) CHECK(c.passed);

  const scenario::Loaded broken =
      scenario::load_text(trial::with("20 mm * sin(2*pi*t/10 s)", "300 mm * t / 1 s"), "a.toml", stage::source(), section::kinds());
  const auto demands = section::evaluate_checks(
      section::Analysis(broken.scenario, broken.trajectory, *broken.machine, analysis::asked_by(broken.scenario), {}), {});
  CHECK(demands[0].passed);
  CHECK_FALSE(demands[1].passed);
  CHECK(demands[1].measured == "at 17 of 21 samples");
  CHECK(demands[1].message.find("its stroke ends at 500 mm") != std::string::npos);
}
