// Sentences and symbols of a report. The mechanism is a slide with a turntable, whose numbers can be worked out by hand.
#include <catch2/catch.hpp>

#include <reports/section/common/words/limits.hpp>
#include <reports/section/common/words/words.hpp>
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

TEST_CASE("a stroke that is broken by little is told with the digits that show it") {
  const trial::Run run(trial::with("20 mm * sin(2*pi*t/10 s)", "250.015 mm * t / 1 s"));
  REQUIRE(run.analysis.breaches().size() == 1);
  CHECK(section::sentence(run.analysis, run.analysis.breaches()[0]) == "t = 2 s: q (slide) needs 500.03 mm, its stroke ends at 500.00 mm.");
}

TEST_CASE("two values beside each other share their unit, and differ where they do") {
  const auto told = [](double value, double beside, const char* unit) {
    const section::Apart a = section::show_apart(value, beside, unit);
    return a.value + " | " + a.beside;
  };
  CHECK(told(1.20006, 1.2, "m") == "1200.06 mm | 1200.00 mm");
  CHECK(told(0.6, 0.5, "m") == "600 mm | 500 mm");
  CHECK(told(10.0001, 9.9999, "m") == "10.0001 m | 9.9999 m");
  CHECK(told(-0.0100001, -0.01, "m") == "−10.0001 mm | −10.0000 mm");
  CHECK(told(0.5, 0.5 * (1 + 1e-15), "m") == "500 mm | 500 mm");
  CHECK(told(1000.5, 1000, "m") == "1000.5 m | 1000.0 m");
}

TEST_CASE("names that count on are told by their ends") {
  CHECK(section::names_of({"l1", "l2", "l3", "l4"}) == "l1 to l4");
  CHECK(section::names_of({"l3", "l1", "l2"}) == "l1 to l3");
  CHECK(section::names_of({"A1", "A2", "B1", "B2", "B3", "B5"}) == "A1, A2, B1 to B3 and B5");
  CHECK(section::names_of({"l9", "l10", "l11"}) == "l9 to l11");
  CHECK(section::names_of({"q", "psi"}) == "psi and q");
  CHECK(section::names_of({"q"}) == "q");
}

TEST_CASE("many runs out of reach are one sentence") {
  std::string text = trial::feeler_too_far;  // 250 mm are too far for it, twice in each wave
  text.replace(text.find("150 mm * t / 1 s"), 16, "250 mm * sin(2*pi*t/0.4 s + 0.1)");
  text.replace(text.find("samples = 21"), 12, "samples = 401");
  const trial::Run run(text);
  REQUIRE(run.analysis.unreachable().size() == 10);
  const auto told = section::reach_sentences(run.analysis);
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0], Catch::Matches("The mechanism cannot be assembled at [0-9]+ of 401 samples, in 10 intervals between t = 0\\.[0-9]+ s "
                                     "and t = [0-9.]+ s; at the first: the feeler is too short\\."));
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
  CHECK(section::typographic("um/N") == "\u00b5m/N");
  CHECK(section::typographic("urad") == "\u00b5rad");
  CHECK(section::typeset("-1.2e-4") == "−1.2e−4");
}
