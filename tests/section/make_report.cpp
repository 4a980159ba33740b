// The whole report: which sections, in which order, with which values, checks and sentences before them.
#include <catch2/catch.hpp>

#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;
using report_words::row_of, report_words::value;

namespace {

std::string check_text(const std::string& that, const std::string& below) {
  return "[[check]]\nthat = \"" + that + "\"\nbelow = \"" + below + "\"\n";
}

}  // namespace

TEST_CASE("sections stand in the order of the scenario, the overview before the first of curves, what is proved of all at the end") {
  const auto r = of_gantry(asking_for({"mobility", "velocity", "displacement", "classification", "acceleration"}));
  CHECK(ids(r) ==
        std::vector<std::string>{"mobility", "overview", "velocity", "displacement", "classification", "acceleration", "every-instant"});
}

TEST_CASE("a section bears the title that the scenario gives it, any other its own") {
  const auto r = of_gantry("[[section]]\nkind = \"velocity\"\ntitle = \"How fast\"\n" + asking_for({"acceleration"}));
  CHECK(section_of(r, "velocity").title == "How fast");
  CHECK(section_of(r, "acceleration").title == "Acceleration");
}

TEST_CASE("every kind of curves has one data file, with a column for the time and one for each quantity with its unit") {
  const auto r = of_gantry(asking_for({"displacement", "classification"}));
  REQUIRE(r.data.size() == 2);
  CHECK(r.data[1].name == "every_instant");
  CHECK(r.data[0].name == "displacement");
  REQUIRE(r.data[0].headings.size() >= 3);
  CHECK(r.data[0].headings[0] == "t [s]");
  CHECK(column_of(r, "displacement", "x [m]").size() == 21);
  const auto& x = column_of(r, "displacement", "x [m]");
  const auto& q = column_of(r, "displacement", "q [m]");
  for (std::size_t k = 0; k < 21; ++k) {
    CHECK(r.data[0].columns[0][k] == Approx(0.1 * double(k)));
    CHECK(x[k] == Approx(0.05 * std::sin(std::numbers::pi * 0.1 * double(k))).margin(1e-15));
    CHECK(q[k] == x[k]);
  }
}

TEST_CASE("the values of a report are the smallest and the largest of every column") {
  const auto r = of_gantry(asking_for({"displacement", "velocity"}));
  CHECK(value(r, "min(x)") == Approx(-0.05));
  CHECK(value(r, "max(x)") == Approx(0.05));
  CHECK(value(r, "max(q_rate)") == Approx(0.05 * std::numbers::pi));
  for (const document::Value& v : r.values)
    if (v.name == "max(q_rate)") {
      CHECK(v.section == "velocity");
      CHECK(v.unit == "m/s");
    }
}

TEST_CASE("checks of the scenario come first, then what every report demands") {
  const auto r = of_gantry(asking_for({"displacement"}) + check_text("max(x)", "60 mm") + check_text("max(q)", "40 mm"));
  REQUIRE(r.checks.size() == 6);
  CHECK(r.checks[0].name == "max(x) < 60 mm");
  CHECK(r.checks[0].passed);
  CHECK(r.checks[1].name == "max(q) < 40 mm");
  CHECK_FALSE(r.checks[1].passed);
  CHECK(r.checks[2].name == "the mechanism can be assembled");
  CHECK(r.checks[3].name == "strokes and joint limits are kept");
  CHECK(r.checks[4].name == "no singular surface is met");
  CHECK(r.checks[5].name == "the samples show the motion");
  for (std::size_t i = 2; i < 6; ++i) CHECK(r.checks[i].passed);
  CHECK_FALSE(r.passed());
}

TEST_CASE("a report without a failure has passed, and finds no fault") {
  const auto r =
      of_gantry("[load]\nforce = [\"0 N\", \"7 N\", \"0 N\"]\n" + asking_for({"displacement", "velocity", "acceleration", "statics"}));
  CHECK(r.passed());
  for (const document::Finding& f : r.findings) CHECK(f.kind != document::Finding::Kind::fault);
  REQUIRE(r.findings.size() == 1);
  CHECK_THAT(r.findings[0].text, Contains("hold at every instant from 0 s to 2 s (proved, "));
  CHECK(r.findings[0].section == "every-instant");
  REQUIRE(r.summary.size() == 3);
  for (const document::Paragraph& p : r.summary) CHECK(p.tone == document::Paragraph::Tone::plain);
  CHECK(r.summary[0].text == "21 samples over 2 s, 1 degrees of freedom.");
  CHECK_THAT(r.summary[1].text, Contains("Motion: ") && Contains("50 mm * sin(2*pi*t/2 s)"));
  CHECK_THAT(r.summary[2].text, Contains("Load on the platform: ") && Contains("7 N"));
}

TEST_CASE("findings tell what failed before they tell what was found") {
  const auto r = of_stage("", "x = \"300 mm * t / 1 s\"\nphi = \"0 deg\"\n", asking_for({"displacement"}) + check_text("max(x)", "0.5 m"));
  using Kind = document::Finding::Kind;
  REQUIRE(r.findings.size() >= 2);
  CHECK(r.findings[0].kind == Kind::fault);
  CHECK(r.findings[0].section == "displacement");
  // 500 mm at 5/3 s, 600 mm at 2 s.
  CHECK_THAT(r.findings[0].text, Contains("q leaves its stroke from t = 1.6") &&
                                     Contains("s to 2 s, at most by 100 mm (600 mm at t = 2 s, ") && Contains("its stroke ends at 500 mm"));
  CHECK(r.findings[1].kind != Kind::fault);
  CHECK_FALSE(r.passed());
}

TEST_CASE("a comparison may name a quantity of a section after it, and stands where the scenario has it") {
  const auto r = of_gantry(
      "[[section]]\nkind = \"comparison\"\n[[section.row]]\nwhat = \"schemes\"\nhere = \"classification.base_schemes\"\n"
      "paper = \"118\"\n" +
      asking_for({"classification"}));
  CHECK(ids(r) == std::vector<std::string>{"comparison", "classification", "every-instant"});
  CHECK(row_of(section_of(r, "comparison"), "", "schemes").back() == "reproduces");
}

TEST_CASE("a report says what made it, of what, and from which scenario") {
  const auto r = of_gantry(asking_for({"displacement"}));
  CHECK(r.title == "Gantry");
  CHECK(r.provenance.version == "1.2.3");
  CHECK(r.provenance.plugin_build == "a build for the tests");
  CHECK(r.provenance.mechanism == "gantry");
  CHECK(r.provenance.scenario_name == "a.toml");
  CHECK_THAT(r.scenario_text, Contains("use = \"gantry\""));
  // By sha256sum of coreutils.
  CHECK(r.provenance.scenario_sha256 == "a4bf885444240a64775aeb8ac10a97760246ffb52d15637a0ace647c43c98547");
}

TEST_CASE("an overview has a row an actuator with its worst points, where there are three columns or more") {
  const auto r = of_gantry("[limits]\nactuator_speed = \"0.2 m/s\"\n" + asking_for({"displacement", "velocity", "dynamics"}));
  const auto& f = *report_words::pointers<figure::Figure>(section_of(r, "overview")).at(0);
  REQUIRE(f.multiples);
  CHECK(f.multiples->rows == std::vector<std::string>{"q"});
  CHECK(f.multiples->columns == std::vector<std::string>{"length", "speed", "force", "power"});
  REQUIRE(f.panels.size() == 4);
  const figure::Panel& speed = f.panels[1];
  CHECK(speed.y.unit == "mm/s");
  for (std::size_t k = 0; k < 21; ++k)
    CHECK(speed.series.at(0).y[k] == Approx(50 * std::numbers::pi * std::cos(std::numbers::pi * 0.1 * double(k))).margin(1e-9));
  // 50 mm of a stroke of 1 m either way; 157 mm/s at the start; 3 kg by 0.05 pi^2 m/s^2 at 0.5 s.
  const auto mark = [&](std::size_t panel) { return f.panels[panel].marks.at(0); };
  CHECK(mark(0).label == "50.0");
  CHECK(mark(0).x == Approx(0.5));
  CHECK(mark(1).label == "157");
  CHECK(mark(1).x == 0);
  CHECK(std::abs(mark(2).y) == Approx(3 * 0.05 * std::numbers::pi * std::numbers::pi));
  REQUIRE(speed.lines.size() == 2);
  CHECK(speed.lines[0].y == Approx(200));
  CHECK(speed.lines[0].forbids == figure::Line::Forbids::above);
  CHECK(f.caption ==
        "Every actuator at a glance: length, speed, force, power. A column has one scale. Dots: the worst of each actuator, in bold of "
        "all; of "
        "a length the nearest to an end of its stroke, else the largest. Hatched: beyond a limit. Off the scale: strokes ±1000 mm.");

  for (const document::Section& other : of_gantry(asking_for({"displacement", "velocity"})).sections) CHECK(other.id != "overview");
}

TEST_CASE("no panel stands twice in a report") {
  const auto r = of_gantry("[load]\nforce = [\"7 N * t / 1 s\", \"4 N * t / 1 s\", \"5 N\"]\n" +
                           asking_for({"displacement", "velocity", "acceleration", "statics", "dynamics"}));
  std::set<std::string> seen;
  std::size_t panels = 0;
  for (const document::Section& s : r.sections)
    for (const auto* f : report_words::pointers<figure::Figure>(s))
      if (!f->multiples)
        for (const figure::Panel& p : f->panels) {
          ++panels;
          std::string what = p.title + p.y.unit;
          for (const figure::Series& c : p.series) {
            what += c.label;
            for (const double y : c.y) what += std::to_string(y);
          }
          CHECK(seen.insert(what).second);
        }
  CHECK(panels > 5);
}
