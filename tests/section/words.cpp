// Sentences and symbols of a report. The mechanism is a slide with a turntable, whose numbers can be worked out by hand.
#include <catch2/catch.hpp>

#include <reports/section/common/words.hpp>
#include <tests/analysis/run.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;

TEST_CASE("a broken stroke is told with time, value and limit") {
  const trial::Run run(trial::with("20 mm * sin(2*pi*t/10 s)", "300 mm * t / 1 s"));
  const section::Analysis& a = run.analysis;
  REQUIRE(a.breaches().size() == 1);
  CHECK(section::sentence(a, a.breaches()[0]) ==
        "t = 1.7 s to 2 s: q (slide) needs 600 mm, its stroke ends at 500 mm (worst at t = 2 s, 4 samples).");
}

TEST_CASE("samples out of reach are told with the mechanism's own reason") {
  const auto told = section::reach_sentences(trial::Run(trial::feeler_too_far).analysis);
  REQUIRE(told.size() == 1);
  CHECK(told[0] == "t = 1.4 s to 2 s: the mechanism cannot be assembled (7 samples): the feeler is too short.");
}

TEST_CASE("names of the program become symbols of the field") {
  CHECK(section::symbol("l1") == "l₁");
  CHECK(section::symbol("alpha") == "α");
  CHECK(section::symbol("rho12") == "ρ₁₂");
  CHECK(section::symbol("det_G") == "det G");
  CHECK(section::typographic("kg*m^2") == "kg·m²");
  CHECK(section::typeset("-1.2e-4") == "−1.2e−4");
}
