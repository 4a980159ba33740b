#include <tests/program/workshop.hpp>

#include <catch2/catch.hpp>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

using namespace program_test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

// As `pmreport list` has them: a line with the name, and one with the file below it.
std::vector<std::string> mechanisms_found() {
  std::vector<std::string> out;
  std::istringstream lines(pmreport({"list"}).out);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with(" ")) out.push_back(line.substr(0, line.find(' ')));
  return out;
}

}  // namespace

// What is printed has passed in memory: of the others that is enough, and a report of each would take its time again.
TEST_CASE("of every mechanism a scenario is printed that is valid, and passes where it is run as it stands") {
  const std::vector<std::string> names = mechanisms_found();
  REQUIRE(names.size() >= 4);
  for (const std::string& name : names) {
    const Result printed = pmreport({"new", "scenario", name});
    CAPTURE(name, printed.out, printed.err);
    REQUIRE(printed.status == 0);
    const Workshop here;
    if (name != "delta" && name != "gough" && name != "p2prpu-prps") {
      CHECK(here.report(printed.out, {"--check"}).status == 0);
      continue;
    }
    const Result run = here.report(printed.out);
    CAPTURE(run.out, run.err);
    CHECK(run.status == 0);
    CHECK_THAT(run.out, StartsWith("passed: ") && !Contains("not decided"));
  }
}

TEST_CASE("a new scenario tells the parameters with their defaults, and what the motion asks for") {
  const std::string text = pmreport({"new", "scenario", "delta"}).out;
  CHECK_THAT(text, StartsWith("title = \"delta: a gentle motion about home\"\n") && Contains("\n# arm_length = \"524 mm\"") &&
                       Contains("length L of an arm, from the motor's axis to the elbow; 1 mm to 100000 mm\n") &&
                       Contains("\nthat = \"max(abs(actuator_force))\"\n") && Contains("kind = \"stiffness\""));
}

TEST_CASE("a parameter of a new scenario counts once its line is one") {
  const Workshop here;
  const std::string text = with(pmreport({"new", "scenario", "delta"}).out, {{"# arm_length = \"524 mm\"", "arm_length = \"530 mm\""}});
  CHECK(here.report(text, {"--check"}).status == 0);
  CHECK(here.report(with(text, {{"530 mm", "530 kg"}}), {"--check"}).status == 2);
}

TEST_CASE("two new scenarios of one mechanism are the same") {
  CHECK(pmreport({"new", "scenario", "gough"}).out == pmreport({"new", "scenario", "gough"}).out);
}

TEST_CASE("a new scenario is written to a file, and over none") {
  const Workshop here;
  const std::string file = here / "mine.toml";
  CHECK(pmreport({"new", "scenario", "delta", "--out", file}).status == 0);
  const std::string written = bytes_of(file);
  CHECK(written == pmreport({"new", "scenario", "delta"}).out);
  const Result again = pmreport({"new", "scenario", "gough", "--out", file});
  CHECK(again.status == 2);
  CHECK_THAT(again.err, Contains("mine.toml is there already; choose another name with --out"));
  CHECK(bytes_of(file) == written);
  CHECK(pmreport({"new", "scenario", "delta", "--out", here / "nowhere" / "mine.toml"}).status == 4);
}

TEST_CASE("a new scenario of what is no mechanism tells what is") {
  const Result unknown = pmreport({"new", "scenario", "gouhg"});
  CHECK(unknown.status == 3);
  CHECK_THAT(unknown.err, Contains("no mechanism is called 'gouhg'; known: "));
  const Result file = pmreport({"new", "scenario", PLUGINS "/delta.so"});
  CHECK(file.status == 2);
  CHECK_THAT(file.err, Contains("expected the name of a mechanism") && Contains("--plugin-path"));
}
