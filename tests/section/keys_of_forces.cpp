// Options of the sections on forces in motion, and what checks may name of them.
#include <catch2/catch.hpp>
#include <reports/section/dynamics/dynamics.hpp>
#include <reports/section/reactions/reactions.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;

namespace {

std::string section_of(std::string_view kind, std::string_view lines = {}) {
  return with_more("[[section]]\nkind = \"" + std::string(kind) + "\"\n" + std::string(lines));
}
Scenario loaded(const std::string& text) {
  INFO(told(text));
  return load_text(text, "a.toml", stage::source(), section::kinds()).scenario;
}

}  // namespace

TEST_CASE("the equations of motion are asked for by times of the motion") {
  CHECK(options_of<section::DynamicsOptions>(loaded(section_of("dynamics")).sections.at(1)).equations.empty());
  const Scenario given = loaded(section_of("dynamics", "equations = [\"0 s\", \"2000 ms\", \"0.5 s\"]\n"));
  CHECK(options_of<section::DynamicsOptions>(given.sections.at(1)).equations == std::vector{0.0, 2.0, 0.5});
  const auto tell = [](const char* list) { return told(section_of("dynamics", "equations = " + std::string(list) + "\n")); };
  CHECK_THAT(tell("[\"3 s\"]"), Contains("a.toml:14:14: error: expected a time within the motion, 0 s to 2 s, seen 3 s"));
  CHECK_THAT(tell("[\"-1 ms\"]"), Contains("seen -0.001 s"));
  CHECK_THAT(tell("[1]"), Contains("expected a time (e.g. \"2.5 s\"), seen the number 1 without a unit"));
  CHECK_THAT(tell("[\"1 m\"]"), Contains("expected a time (e.g. \"2.5 s\"), seen a length"));
  CHECK_THAT(tell("[nan]"), Contains("expected a finite number"));
  CHECK_THAT(tell("[]"), Contains("expected a list of 1 to 12 equations, seen 0"));
  CHECK_THAT(tell("\"1 s\""), Contains("expected a list of 1 to 12 equations, seen the text \"1 s\""));
  CHECK_THAT(tell("[\"1 s\", \"1000 ms\"]"), Contains("a.toml:14:21: error: \"1000 ms\" is given twice"));
}

TEST_CASE("the joints whose reactions are drawn are named") {
  const auto joints = [](const std::string& lines) {
    return options_of<section::ReactionsOptions>(loaded(section_of("reactions", lines)).sections.at(1)).joints;
  };
  CHECK(joints("").empty());
  CHECK(joints("joints = [\"R\", \"P\"]\n") == std::vector{1, 0});
  const auto tell = [](const char* list) { return told(section_of("reactions", "joints = " + std::string(list) + "\n")); };
  CHECK_THAT(tell("[\"S\"]"), Contains("a.toml:14:11: error: expected \"P\" or \"R\", seen \"S\""));
  CHECK_THAT(tell("[]"), Contains("expected a list of 1 to 2 joints, seen 0"));
  CHECK_THAT(tell("[3]"), Contains("expected a text in quotes, seen the number 3"));
  CHECK_THAT(tell("[\"R\", \"R\"]"), Contains("a.toml:14:16: error: \"R\" is given twice"));
  CHECK_THAT(tell("\"R\""), Contains("expected a list of 1 to 2 joints, seen the text \"R\""));
}

TEST_CASE("an option of one section is not one of another") {
  CHECK_THAT(told(section_of("dynamics", "joints = [\"R\"]\n")), Contains("unknown key \"joints\" in a section of kind \"dynamics\""));
  CHECK_THAT(told(section_of("reactions", "equations = [\"1 s\"]\n")), Contains("unknown key \"equations\""));
  CHECK_THAT(told(section_of("dynamics", "[[section]]\nkind = \"dynamics\"\n")), Contains("a report has one section \"dynamics\""));
}

TEST_CASE("columns and quantities of forces in motion can be checked where their section is") {
  struct Case {
    const char *kind, *that, *below, *first;  // first: of the columns; empty: a quantity
    std::size_t count;
  };
  const Case cases[] = {
      {"dynamics", "max(abs(q_dynamic_force))", "\"1 N\"", "q_dynamic_force", 1},
      {"dynamics", "max(psi_gravity_force)", "\"1 N*m\"", "psi_gravity_force", 1},
      {"dynamics", "rms(power)", "\"1 W\"", "q_power", 2},
      {"dynamics", "at(kinetic_energy, 1 s)", "\"1 J\"", "kinetic_energy", 1},
      {"dynamics", "dynamics.peak_torque", "\"1 N*m\"", "", 0},
      {"reactions", "max(joint_force)", "\"1 N\"", "P_force", 2},
      {"reactions", "max(abs(R_moment_2))", "\"1 N*m\"", "R_moment_2", 1},
      {"reactions", "reactions.indeterminate", "1", "", 0},
      {"drives", "max(abs(drive_power))", "\"1 W\"", "q_drive_power", 2},
      {"drives", "max(q_motor_speed)", "\"1 rpm\"", "q_motor_speed", 1},
  };
  for (const Case& c : cases) {
    CAPTURE(c.that);
    const std::string check = "[[check]]\nthat = \"" + std::string(c.that) + "\"\nbelow = " + c.below + "\n";
    const std::string drive = c.kind == std::string("drives") ? "[drive]\nlead = \"5 mm\"\n" : "";
    const Scenario s = loaded(section_of(c.kind, drive + check));
    REQUIRE(s.checks.size() == 1);
    CHECK(s.checks[0].columns.size() == c.count);
    CHECK((c.count > 0 ? s.checks[0].columns[0] : s.checks[0].quantity) == (c.count > 0 ? c.first : c.that));
    CHECK_THAT(told(with_more(check)),
               Contains(std::string("belongs to the section \"") + c.kind + "\", which this scenario does not have"));
  }
  CHECK_THAT(told(section_of("dynamics", "[[check]]\nthat = \"max(dynamic_force)\"\nbelow = \"1 N\"\n")),
             Contains("the columns of \"dynamic_force\" have different units") && Contains("q_dynamic_force or psi_dynamic_force"));
}
