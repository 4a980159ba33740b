// The run of a scenario: limits, reach, and what is computed. The mechanism is a slide with a turntable, whose
// numbers can be worked out by hand.
#include <catch2/catch.hpp>

#include <core/analysis/analysis.hpp>
#include <reports/section/kinds.hpp>
#include <tests/analysis/run.hpp>
#include <tests/scenario/trial.hpp>

#include <cmath>

using namespace pmreport;
using analysis::ColumnId;
using trial::feeler_too_far;
using trial::Run;

TEST_CASE("a broken stroke keeps its values and is told with time, value and limit") {
  const Run r(trial::with("20 mm * sin(2*pi*t/10 s)", "300 mm * t / 1 s"));  // passes 500 mm after 1.667 s, samples every 0.1 s
  REQUIRE(r.analysis.breaches().size() == 1);
  const analysis::LimitBreach& b = r.analysis.breaches()[0];
  CHECK(b.subject == "q (slide)");
  CHECK(b.samples == std::vector<int>{17, 18, 19, 20});
  CHECK(b.worst == 20);
  CHECK(b.value == Approx(0.6));
  CHECK(b.limit == 0.5);
  CHECK(b.above);
  CHECK(b.stroke);
  CHECK(r.analysis.column(ColumnId::named("q")).back() == Approx(0.6));
  CHECK(r.analysis.broken().size() == 1);
  CHECK(r.analysis.count(analysis::Outcome::good) == 21);
}

TEST_CASE("a limit that is met exactly is kept") {
  CHECK(Run(trial::with("20 mm * sin(2*pi*t/10 s)", "250 mm * t / 1 s")).analysis.breaches().empty());
}

TEST_CASE("an unreachable sample has no value in any column and is told with the mechanism's own reason") {
  const Run r(feeler_too_far);  // the feeler ends at 200 mm: from 1.4 s on it is too short
  CHECK(r.analysis.count(analysis::Outcome::unreachable) == 7);
  CHECK(std::isnan(r.analysis.column(ColumnId::named("phi")).back()));
  CHECK(std::isnan(r.analysis.column(ColumnId::named("x_rate")).back()));
  CHECK(std::isfinite(r.analysis.column(ColumnId::named("phi"))[13]));
  REQUIRE(r.analysis.unreachable().size() == 1);
  CHECK(r.analysis.unreachable()[0].first == 14);
  CHECK(r.analysis.unreachable()[0].last == 20);
  CHECK(r.analysis.why(14) == "the feeler is too short");
}

TEST_CASE("every residual of a sound mechanism is rounding") {
  const Run r(
      trial::with_more("[[section]]\nkind = \"velocity\"\n[[section]]\nkind = \"acceleration\"\n[[section]]\nkind = \"statics\"\n"));
  for (std::size_t m = 0; m < static_cast<std::size_t>(analysis::Measure::count); ++m) {
    CAPTURE(m);
    const analysis::Worst w = r.analysis.worst(static_cast<analysis::Measure>(m));
    CHECK(w.value < 1e-9);
    const bool stated = static_cast<analysis::Measure>(m) != analysis::Measure::source;  // this mechanism's source states no matrices
    const bool in_motion = static_cast<analysis::Measure>(m) >= analysis::Measure::newton_euler;  // nothing asks for forces in motion
    CHECK(w.compared == (stated && !in_motion ? 21 : 0));
  }
}

TEST_CASE("static forces oppose the load: the slide the force along it, the table the moment about it") {
  const Run r(trial::with_more(
      "[load]\nforce = [\"5 N\", \"7 N\", \"0 N\"]\nmoment = [\"0 N*m\", \"0 N*m\", \"3 N*m\"]\n[[section]]\nkind = \"statics\"\n"));
  CHECK(r.analysis.column(ColumnId::named("q_force"))[4] == Approx(-5));
  CHECK(r.analysis.column(ColumnId::named("psi_force"))[4] == Approx(-3));
  CHECK(r.analysis.column(ColumnId::named("c1"))[4] == Approx(-7));
}

TEST_CASE("the nearest sample stands for a time between two") {
  const Run r{std::string(trial::sound)};
  CHECK(r.analysis.sample_at(0.14) == 1);
  CHECK(r.analysis.sample_at(0.16) == 2);
  CHECK(r.analysis.sample_at(99) == 20);
}

TEST_CASE("what no section shows is not computed") {
  const Run r{std::string(trial::sound)};  // displacement alone
  using analysis::Measure;
  CHECK(r.analysis.worst(Measure::gap).compared == 21);
  for (const Measure m : {Measure::velocity, Measure::difference_rate, Measure::difference_acceleration, Measure::statics, Measure::judge})
    CHECK(r.analysis.worst(m).compared == 0);
  CHECK(std::isnan(r.analysis.column(ColumnId::named("q_force"))[4]));
  CHECK_FALSE(r.analysis.has_dynamics());
}

TEST_CASE("limits ask for forces in motion, and for no evidence of them") {
  const Run r(trial::with_more("[limits]\nactuator_force = { q = \"1 kN\" }\n"));
  CHECK(r.analysis.has_dynamics());
  CHECK(std::isfinite(r.analysis.column(ColumnId::named("q_dynamic_force"))[4]));
  CHECK(r.analysis.worst(analysis::Measure::newton_euler).compared == 0);
  CHECK_FALSE(r.analysis.has(ColumnId::named("P_force")));
}

TEST_CASE("without a motion a run knows the machine at home and no sample") {
  const Run r("title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n[[section]]\nkind = \"mobility\"\n");
  CHECK(r.analysis.samples() == 0);
  CHECK(r.analysis.breaches().empty());
  CHECK(r.analysis.crossings().empty());
  CHECK(r.analysis.unreachable().empty());
  CHECK(r.analysis.length() > 0);
}
