// [limits]. The stage has a linear actuator q and a rotary one psi, a slide P and a bearing R; the slider-crank one linear actuator and
// balls B and C.
#include <catch2/catch.hpp>
#include <core/scenario/sizing_part.hpp>
#include <tests/given/slider_crank.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;
using mechanics::MotionLimits;

namespace {

constexpr double none = MotionLimits::none;

std::string limited(std::string_view lines) { return with_more("[limits]\n" + std::string(lines)); }
MotionLimits limits_of(std::string_view lines) {
  const std::string text = limited(lines);
  INFO(told(text));
  return load_text(text, "a.toml", stage::source(), section::kinds()).scenario.limits;
}
std::string limits_told(std::string_view lines) { return told(limited(lines)); }

MechanismSource crank() {
  return {[](const std::string& name) { return name == "crank" ? &test::slider_crank() : nullptr; }, {"crank"}};
}
Loaded cranked(const std::string& lines) {
  return load_text(
      "title = \"Crank\"\n[mechanism]\nuse = \"crank\"\n[[section]]\nkind = \"velocity\"\n[motion]\nduration = \"1 s\"\nsamples = "
      "3\n[limits]\n" +
          lines,
      "a.toml", crank(), section::kinds());
}

}  // namespace

TEST_CASE("a scenario without [limits] has none") {
  const MotionLimits l = load_text(std::string(sound), "a.toml", stage::source(), section::kinds()).scenario.limits;
  CHECK_FALSE(l.any());
  for (const auto* list : {&l.force, &l.speed, &l.power, &l.joint_force, &l.joint_moment}) CHECK(*list == std::vector{none, none});
}

TEST_CASE("a limit may hold for all that have the same unit") {
  const MotionLimits l = limits_of("actuator_power = \"0.2 kW\"\njoint_force = \"2 kN\"\njoint_moment = \"40 N*m\"\n");
  CHECK(l.any());
  CHECK(l.power == std::vector{200.0, 200.0});
  CHECK(l.joint_force == std::vector{2000.0, 2000.0});
  CHECK(l.joint_moment == std::vector{40.0, 40.0});
  CHECK(l.force == std::vector{none, none});
  CHECK(l.speed == std::vector{none, none});
}

TEST_CASE("a limit by name is in the unit of what it is on, and leaves the others alone") {
  const MotionLimits l = limits_of(
      "actuator_force = { q = \"500 N\", psi = \"4000 N*mm\" }\nactuator_speed = { psi = \"60 rpm\" }\n"
      "[limits.joint_moment]\nR = \"7 N*m\"\n");
  CHECK(l.force == std::vector{500.0, 4.0});
  CHECK(l.speed[0] == none);
  CHECK(l.speed[1] == Approx(6.283185307179586));
  CHECK(l.joint_moment == std::vector{none, 7.0});
  CHECK(l.joint_force == std::vector{none, none});
}

TEST_CASE("one value for linear and rotary actuators is refused") {
  CHECK(limits_told("actuator_force = \"500 N\"\n") ==
        "a.toml:13:18: error: expected a table by name, seen one value for all: q is linear, and psi is rotary\n"
        "  actuator_force = \"500 N\"\n                   ^\n"
        "  hint: write actuator_force = { q = \"10 N\", psi = \"10 N*m\" }");
  CHECK_THAT(limits_told("actuator_speed = \"1 m/s\"\n"), Contains("write actuator_speed = { q = \"20 mm/s\", psi = \"30 deg/s\" }"));
}

TEST_CASE("a ball transmits no moment that could be limited") {
  const MotionLimits all = cranked("joint_moment = \"3 N*m\"\nactuator_force = \"5 N\"\n").scenario.limits;
  CHECK(all.joint_moment == std::vector{3.0, none, none, 3.0});
  CHECK(all.force == std::vector{5.0});
  CHECK_THROWS_WITH(
      cranked("joint_moment = { B = \"3 N*m\" }"),
      Contains("a.toml:10:18: error: B is a spherical joint and transmits no moment about its centre: there is nothing to limit"));
  const std::string text = "limits = { joint_moment = \"1 N*m\" }";
  MechanismPart balls;
  balls.topology.emplace();
  balls.topology->joints = {Joint{"A", JointKind::spherical, 0, 1, {}}};
  Diagnostics diagnostics("a.toml", text);
  const Value document = parse_document(text, "a.toml", diagnostics);
  CHECK_FALSE(read_limits(&document.entries.at(0), balls, Reader(diagnostics)).any());
  CHECK_THROWS_WITH(diagnostics.throw_if_any(), Contains("a.toml:1:12: error: no joint of this mechanism transmits"));
}

TEST_CASE("a limit that is none is refused") {
  const std::pair<const char*, const char*> cases[] = {
      {"actuator_power = \"0 W\"",
       "a.toml:13:18: error: expected 1e-6 W to 1e12 W for actuator_power, seen 0 W\n  actuator_power = \"0 W\"\n                   ^\n"
       "  hint: leave out what has no limit"},
      {"actuator_power = \"-5 W\"", "seen -5 W"},
      {"actuator_power = \"1e300 W\"", "seen 1e300 W"},
      {"actuator_power = inf", "expected a finite number for \"limits.actuator_power\", seen inf"},
      {"actuator_power = nan", "seen nan"},
      {"actuator_power = \"1 W / 0\"", "expected a finite number, but"},
      {"actuator_power = \"5 N\"", "expected a power (e.g. \"50 W\"), seen a force"},
      {"actuator_power = 5", "expected a power (e.g. \"50 W\"), seen the number 5 without a unit"},
      {"actuator_power = [\"5 W\"]", "expected a power (e.g. \"50 W\"), seen a list"},
      {"actuator_power = \"5 W * t/1 s\"", "error: "},
      {"joint_force = \"5 N*m\"", "expected a force (e.g. \"10 N\"), seen a moment"},
      {"joint_force = { R = \"5 mm\" }", "a.toml:13:21: error: expected a force (e.g. \"10 N\"), seen a length"},
      {"actuator_force = { q = \"5 N*m\" }", "expected a force (e.g. \"10 N\"), seen a moment"},
      {"actuator_force = { psi = \"5 N\" }", "expected a moment (e.g. \"10 N*m\"), seen a force"},
      {"actuator_force = { q = \"0 N\" }", "expected 1e-6 N to 1e12 N for q, seen 0 N"},
      {"actuator_force = { x = \"5 N\" }", "unknown key \"x\" in limits.actuator_force"},
      {"joint_force = { RR = \"5 N\" }", "unknown key \"RR\" in limits.joint_force; did you mean \"R\"?\n"},
      {"actuator_forces = \"5 N\"", "unknown key \"actuator_forces\" in [limits]; did you mean \"actuator_force\"?"},
      {"joint_force = {}", "a.toml:13:1: error: expected limits by name in limits.joint_force, seen an empty table"},
      {"", "a.toml:12:2: error: expected at least one limit in [limits], seen an empty table"},
  };
  for (const auto& [lines, message] : cases) {
    CAPTURE(lines);
    CHECK_THAT(limits_told(lines), Contains(message));
  }
  CHECK_THAT(told("limits = \"5 N\"\n" + std::string(sound)), Contains("expected a table [limits], seen the text \"5 N\""));
}

TEST_CASE("a section speed needs a limit") {
  const std::string section = "[[section]]\nkind = \"speed\"\n";
  CHECK(told(with_more(section)) ==
        "a.toml:13:8: error: a section \"speed\" needs at least one limit, and there is none\n  kind = \"speed\"\n         ^\n"
        "  hint: add [limits] and at least one of actuator_force, actuator_speed, actuator_power, joint_force and joint_moment");
  CHECK(told(with_more(section + "[limits]\nactuator_power = \"5 W\"\n")).empty());
  // A limit that is wrong is told once, and not missed on top.
  CHECK_THAT(told(with_more(section + "[limits]\nactuator_power = \"5 N\"\n")), Contains("seen a force") && !Contains("needs"));
  CHECK_THAT(told(with_more(section + "[limits]\n")), Contains("an empty table") && !Contains("needs"));
}

TEST_CASE("the feasible speed can be checked where its section is") {
  const std::string check = "[[check]]\nthat = \"speed.scale\"\nabove = 1\n";
  const std::string text = limited("actuator_power = \"5 W\"\n[[section]]\nkind = \"speed\"\n" + check);
  INFO(told(text));
  const Scenario s = load_text(text, "a.toml", stage::source(), section::kinds()).scenario;
  CHECK(s.checks.at(0).quantity == "speed.scale");
  CHECK_FALSE(s.checks.at(0).count);
  CHECK(s.checks.at(0).above == 1.0);
  CHECK_THAT(told(limited("actuator_power = \"5 W\"\n" + check)),
             Contains("\"speed.scale\" belongs to the section \"speed\", which this scenario does not have") &&
                 Contains("hint: add [[section]] and kind = \"speed\""));
  CHECK_THAT(
      told(limited("actuator_power = \"5 W\"\n[[section]]\nkind = \"speed\"\n[[check]]\nthat = \"speed.duration\"\nabove = \"1 m\"\n")),
      Contains("expected a time"));
}
