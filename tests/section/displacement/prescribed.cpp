// A motion by actuators in a report: the proof that they move as prescribed, and what is said where the motion cannot go on. The mechanism
// is a slider-crank, whose slider turns back at a dead centre.
#include <catch2/catch.hpp>

#include <reports/section/checks.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/displacement/prescribed.hpp>
#include <tests/given/slider_crank.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using analysis::ColumnId;
using Catch::Contains;

namespace {

struct Run {
  explicit Run(const std::string& motion)
      : loaded(scenario::load_text(
            "title = \"Crank\"\n[mechanism]\nuse = \"crank\"\n[[section]]\nkind = \"displacement\"\n[motion]\nduration = "
            "\"1 s\"\nsamples = 21\n" +
                motion,
            "a.toml", {[](const std::string&) { return &test::slider_crank(); }, {"crank"}}, section::kinds())),
        analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}) {}
  scenario::Loaded loaded;
  section::Analysis analysis;
};

// The dead centre is 35 mm from home: the slider stays before it, or is driven far beyond.
const std::string near = "s_rate = \"30 mm/s * cos(t/1 s)\"\n", far = "s_rate = \"0.2 m/s\"\n";

}  // namespace

TEST_CASE("driven actuators are proved by inverse displacement: values, rates and accelerations as prescribed") {
  const Run r(near);
  REQUIRE(r.analysis.count(section::Outcome::good) == 21);
  const auto evidence = section::prescribed_evidence(r.analysis);
  REQUIRE(evidence.size() == 3);
  for (const document::Evidence& e : evidence) {
    CAPTURE(e.claim);
    CHECK(e.verdict() == document::Verdict::passed);
  }
  CHECK(r.analysis.column(ColumnId::named("s_rate"))[7] == Approx(0.03 * std::cos(0.35)));
  CHECK(section::prescribed_evidence(Run("theta = \"1 rad\"\n").analysis).empty());
}

TEST_CASE("the proof of driven actuators can fail") {
  Run r(near);
  const auto follow = r.loaded.scenario.motion->prescribed;
  // what is prescribed is now a thousandth faster than what was followed
  r.loaded.scenario.motion->prescribed = [follow](double t, double* value, double* rate, double* acceleration) {
    const bool there = follow(t, value, rate, acceleration);
    *rate *= 1.001;
    return there;
  };
  const auto evidence = section::prescribed_evidence(r.analysis);
  CHECK(evidence[0].verdict() == document::Verdict::passed);
  CHECK(evidence[1].failed());
  CHECK(evidence[2].verdict() == document::Verdict::passed);
}

TEST_CASE("samples beyond a singular surface have no pose, and the demand of reach fails with the time") {
  const Run r(far);
  const int lost = r.analysis.count(section::Outcome::unreachable);
  CHECK(lost > 10);
  CHECK(std::isnan(r.analysis.column(ColumnId::named("s")).back()));
  CHECK(std::isfinite(r.analysis.column(ColumnId::named("s")).front()));
  const auto told = section::reach_sentences(r.analysis);
  REQUIRE(told.size() == 1);
  CHECK_THAT(told[0], Contains("The motion meets a singular surface at t = 0.") && Contains(std::to_string(lost) + " samples from t = ") &&
                          Contains(" to 1 s have no pose."));
  const auto demands = section::evaluate_checks(r.analysis, {});
  REQUIRE(demands.size() == 3);
  CHECK_FALSE(demands[0].passed);
  CHECK(demands[0].message == told[0]);
}

TEST_CASE("a motion that may end at a singular surface keeps the demand of reach") {
  const Run r("s_rate = \"0.1 m/s\"\nuntil = \"singularity\"\n");
  CHECK(r.analysis.samples() < 21);
  CHECK(section::reach_sentences(r.analysis).empty());
  for (const document::Check& c : section::evaluate_checks(r.analysis, {})) {
    CAPTURE(c.name, c.message);
    CHECK(c.passed);
  }
}
