// Scenarios without [motion]: what may leave it out, and what may not.
#include <catch2/catch.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/snapshots/snapshots.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;

namespace {

std::string still(std::string_view section, std::string_view more = {}) {
  return "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n[[section]]\n" + std::string(section) + std::string(more);
}

}  // namespace

TEST_CASE("sections of what is no motion need none") {
  for (const char* section :
       {"kind = \"mechanism\"\n", "kind = \"mobility\"\n", "kind = \"classification\"\n", "kind = \"snapshots\"\n", "kind = \"assembly\"\n",
        "kind = \"assembly\"\nactuators = { q = \"10 mm\" }\n", "kind = \"singularity\"\nposes = [{ x = \"10 mm\" }]\n",
        "kind = \"singularity\"\nmap = { x = [\"-1 mm\", \"1 mm\"], phi = [\"-1 deg\", \"1 deg\"] }\n"}) {
    const std::string text = still(section);
    INFO(section << told(text));
    const Loaded l = load_text(text, "a.toml", stage::source(), section::kinds());
    CHECK_FALSE(l.scenario.motion);
    CHECK(l.trajectory.samples() == 0);
    CHECK(l.scenario.load.force.empty());
  }
  const Loaded home = load_text(still("kind = \"snapshots\"\n"), "a.toml", stage::source(), section::kinds());
  CHECK(options_of<section::SnapshotsOptions>(home.scenario.sections[0]).times.empty());
}

TEST_CASE("a section that shows the motion needs one") {
  for (const char* kind : {"displacement", "velocity", "acceleration", "statics", "dynamics", "reactions"}) {
    CAPTURE(kind);
    CHECK(told(still("kind = \"" + std::string(kind) + "\"\n")) ==
          "a.toml: error: expected the table [motion], which is not there\n"
          "  hint: write [motion], duration = \"10 s\" and samples = 501");
  }
}

TEST_CASE("what is for a motion has no place without one") {
  CHECK_THAT(told(still("kind = \"mobility\"\n", "[load]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n")),
             Contains("a.toml:6:2: error: [load] is for a motion, and this scenario has none"));
  CHECK_THAT(told(still("kind = \"mobility\"\n", "[limits]\nactuator_power = \"1 W\"\n")),
             Contains("[limits] is for a motion, and this scenario has none"));
  for (const char* section : {"kind = \"snapshots\"\ntimes = [\"0 s\"]\n", "kind = \"assembly\"\ntime = \"1 s\"\n"})
    CHECK_THAT(told(still(section)), Contains("expected no time, for the scenario has no motion, seen one"));
  CHECK_THAT(told(still("kind = \"singularity\"\n")), Contains("has nothing to look at: there is no motion, no pose and no map"));
  CHECK_THAT(told(still("kind = \"mobility\"\n", "[[check]]\nthat = \"max(x)\"\nbelow = \"1 m\"\n")),
             Contains("\"x\" belongs to the section \"displacement\", which this scenario does not have"));
  CHECK_THAT(
      told(still("kind = \"singularity\"\nposes = [{ x = \"10 mm\" }]\n", "[[check]]\nthat = \"singularity.crossings\"\nbelow = 1\n")),
      Contains("\"singularity.crossings\" is of a motion, and this scenario has none"));
  // A column is of the samples of a motion, also where its section needs none.
  for (const char* that : {"min(local_transmission)", "at(local_transmission, 1 s)"})
    CHECK_THAT(told(still("kind = \"transmission\"\nposes = [{ x = \"10 mm\" }]\n",
                          "[[check]]\nthat = \"" + std::string(that) + "\"\nabove = 0.1\n")),
               Contains("\"local_transmission\" is of a motion, and this scenario has none"));
  CHECK(told(still("kind = \"mobility\"\n", "[[check]]\nthat = \"mobility.freedoms\"\nbelow = 3\n")).empty());
}
