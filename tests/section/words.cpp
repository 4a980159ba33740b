// Sentences and symbols of a report. The mechanism is a slide with a turntable, whose numbers can be worked out by hand.
#include <catch2/catch.hpp>

#include <reports/section/common/words.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/make_report.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;

namespace {

std::vector<std::string> reach_sentences(const std::string& text) {
  const scenario::Loaded loaded = scenario::load_text(text, "a.toml", stage::source(), section::kinds());
  return section::reach_sentences({loaded.scenario, loaded.trajectory, *loaded.machine, {}, {}});
}

}  // namespace

TEST_CASE("a broken stroke is told with time, value and limit") {
  const scenario::Loaded loaded =
      scenario::load_text(trial::with("20 mm * sin(2*pi*t/10 s)", "300 mm * t / 1 s"), "a.toml", stage::source(), section::kinds());
  const section::Analysis a(loaded.scenario, loaded.trajectory, *loaded.machine, {}, {});
  REQUIRE(a.breaches().size() == 1);
  CHECK(section::sentence(a, a.breaches()[0]) ==
        "t = 1.7 s to 2 s: q (slide) needs 600 mm, its stroke ends at 500 mm (worst at t = 2 s, 4 samples).");
}

TEST_CASE("samples out of reach are told with the mechanism's own reason") {
  const auto told = reach_sentences(R"toml(title = "Stage"
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
)toml");
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
