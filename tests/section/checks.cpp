// The gates: reductions worked out by hand, verdicts and their sentences.
#include <catch2/catch.hpp>

#include <reports/section/checks.hpp>
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

TEST_CASE("both bounds of a gate are judged") {
  CHECK(check("max(x)", "below = \"30 mm\"\nabove = \"10 mm\"").passed);
  CHECK_FALSE(check("max(x)", "below = \"30 mm\"\nabove = \"25 mm\"").passed);
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
  CHECK(demands[1].measured == "4 of 21 samples");
  CHECK(demands[1].message.find("its stroke ends at 500 mm") != std::string::npos);
}
