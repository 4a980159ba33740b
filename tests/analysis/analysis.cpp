// The run of a scenario: limits, reach, singular surfaces, and what is said of them. The mechanism is a slide with a turntable, whose
// numbers can be worked out by hand.
#include <catch2/catch.hpp>

#include <reports/section/common/words.hpp>
#include <tests/scenario/trial.hpp>

#include <cmath>

using namespace pmreport;

namespace {

struct Run {
  explicit Run(const std::string& text)
      : loaded(scenario::load_text(text, "a.toml", stage::source(), section::kinds())), analysis(loaded.scenario, *loaded.machine, {}) {}
  scenario::Loaded loaded;
  section::Analysis analysis;
};

const std::string feeler_too_far = R"toml(title = "Stage"
[mechanism]
use = "stage"
parameters = { arm = "200 mm", dependent = "phi" }
[motion]
duration = "2 s"
samples = 21
x = "0 mm"
y = "150 mm * t / 1 s"
[[section]]
kind = "displacement"
)toml";

}  // namespace

TEST_CASE("a broken stroke keeps its values and is told with time, value and limit") {
  const Run r(trial::with("20 mm * sin(2*pi*t/10 s)", "300 mm * t / 1 s"));  // passes 500 mm after 1.667 s, samples every 0.1 s
  REQUIRE(r.analysis.breaches().size() == 1);
  CHECK(section::sentence(r.analysis, r.analysis.breaches()[0]) ==
        "t = 1.7 s to 2 s: q (slide) needs 600 mm, its stroke ends at 500 mm (worst at t = 2 s, 4 samples).");
  CHECK(r.analysis.column("q").back() == Approx(0.6));
  CHECK(r.analysis.broken().size() == 1);
  CHECK(r.analysis.count(section::Condition::good) == 21);
}

TEST_CASE("a limit that is met exactly is kept") {
  CHECK(Run(trial::with("20 mm * sin(2*pi*t/10 s)", "250 mm * t / 1 s")).analysis.breaches().empty());
}

TEST_CASE("an unreachable sample has no value in any column and is told with the mechanism's own reason") {
  const Run r(feeler_too_far);  // the feeler ends at 200 mm: from 1.4 s on it is too short
  CHECK(r.analysis.count(section::Condition::unreachable) == 7);
  CHECK(std::isnan(r.analysis.column("phi").back()));
  CHECK(std::isnan(r.analysis.column("x_rate").back()));
  CHECK(std::isfinite(r.analysis.column("phi")[13]));
  const auto told = section::reach_sentences(r.analysis);
  REQUIRE(told.size() == 1);
  CHECK(told[0] == "t = 1.4 s to 2 s: the mechanism cannot be assembled (7 samples): the feeler is too short.");
}

TEST_CASE("every residual of a sound mechanism is rounding") {
  const Run r(trial::with_more("[[section]]\nkind = \"statics\"\n"));
  for (std::size_t m = 0; m < static_cast<std::size_t>(section::Measure::count); ++m) {
    CAPTURE(m);
    const section::Worst w = r.analysis.worst(static_cast<section::Measure>(m));
    CHECK(w.value < 1e-9);
    const bool stated = static_cast<section::Measure>(m) != section::Measure::source;  // this mechanism's source states no matrices
    const bool in_motion = static_cast<section::Measure>(m) >= section::Measure::newton_euler;  // nothing asks for forces in motion
    CHECK(w.compared == (stated && !in_motion ? 21 : 0));
  }
}

TEST_CASE("static forces oppose the load: the slide the force along it, the table the moment about it") {
  const Run r(trial::with_more(
      "[load]\nforce = [\"5 N\", \"7 N\", \"0 N\"]\nmoment = [\"0 N*m\", \"0 N*m\", \"3 N*m\"]\n[[section]]\nkind = \"statics\"\n"));
  CHECK(r.analysis.column("q_force")[4] == Approx(-5));
  CHECK(r.analysis.column("psi_force")[4] == Approx(-3));
  CHECK(r.analysis.column("c1")[4] == Approx(-7));
}

TEST_CASE("the nearest sample stands for a time between two") {
  const Run r{std::string(trial::sound)};
  CHECK(r.analysis.sample_at(0.14) == 1);
  CHECK(r.analysis.sample_at(0.16) == 2);
  CHECK(r.analysis.sample_at(99) == 20);
}

TEST_CASE("names of the program become symbols of the field") {
  CHECK(section::symbol("l1") == "l₁");
  CHECK(section::symbol("alpha") == "α");
  CHECK(section::symbol("rho12") == "ρ₁₂");
  CHECK(section::symbol("det_G") == "det G");
  CHECK(section::typographic("kg*m^2") == "kg·m²");
  CHECK(section::typeset("-1.2e-4") == "−1.2e−4");
}
