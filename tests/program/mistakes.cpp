// A scenario that cannot be run: exit status 2, a sentence with its place, and nothing written or touched.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

using namespace program_test;
using Catch::Contains;

namespace {

const std::map<std::string, std::string>& earlier_report(const Workshop& here) {
  static std::map<std::string, std::string> files;
  if (here.report(small).status != 0) throw std::runtime_error("the small scenario is not sound");
  return files = contents(here.path());
}

// Refused with `told` on stderr, the earlier report and all beside it untouched, nothing on stdout.
void check_refused(const std::string& scenario, const std::string& told) {
  CAPTURE(scenario);
  const Workshop here;
  std::map<std::string, std::string> before = earlier_report(here);
  const Result result = here.report(scenario);
  CHECK(result.status == 2);
  CHECK_THAT(result.err, Contains(told));
  CHECK(result.out.empty());
  before["scenario.toml"] = scenario;
  CHECK(contents(here.path()) == before);
}

}  // namespace

TEST_CASE("an empty file is refused") {
  check_refused("", "scenario.toml: error: expected a scenario, seen an empty file\n  hint: a scenario has title");
}

TEST_CASE("a syntax error is told with its line and column, and a hint for a quantity without quotes") {
  check_refused(with(small, {{"\"550 mm\"", "550 mm"}}),
                "scenario.toml:10:9: error: Error while parsing key-value pair: expected a comment or whitespace, saw 'm'\n"
                "  z = 550 mm\n"
                "          ^\n"
                "  hint: quote it: \"550 mm\"\n");
}

TEST_CASE("an unknown key is refused with the key that was meant") {
  check_refused(with(small, {{"samples", "sampels"}}),
                "scenario.toml:8:1: error: unknown key \"sampels\" in [motion]; did you mean \"samples\"?");
}

TEST_CASE("a value of the wrong type is refused") {
  check_refused(with(small, {{"\"Small\"", "7"}}), "scenario.toml:1:9: error: expected a text in quotes, seen the number 7");
}

TEST_CASE("a length where an angle belongs is refused") {
  check_refused(with(small, {{"\"1 deg * (1 - cos(2*pi*t/2 s))\"", "\"5 mm\""}}),
                "scenario.toml:11:9: error: expected an angle (e.g. \"5 deg\"), seen a length\n"
                "  alpha = \"5 mm\"\n"
                "          ^\n");
}

TEST_CASE("numbers that are not finite are refused, as numbers and in expressions") {
  check_refused(with(small, {{"\"550 mm\"", "nan"}}), "scenario.toml:10:5: error: expected a finite number for \"motion.z\", seen nan");
  check_refused(with(small, {{"\"550 mm\"", "inf"}}), "scenario.toml:10:5: error: expected a finite number for \"motion.z\", seen inf");
  check_refused(with(small, {{"\"550 mm\"", "\"550 mm / (t/1 s)\""}}), "z has no finite value at t = 0 s");
}

TEST_CASE("a motion without samples is refused") {
  check_refused(with(small, {{"samples = 21", "samples = 0"}}), "scenario.toml:8:11: error: expected 2 to 1000000 samples, seen 0\n");
}

TEST_CASE("a thousand million samples are refused with what they would take") {
  check_refused(with(small, {{"samples = 21", "samples = 1000000000"}}),
                "scenario.toml:8:11: error: expected 2 to 1000000 samples, seen 1000000000; 1e9 samples would take about ");
}

TEST_CASE("an unknown mechanism is refused with the one that was meant") {
  check_refused(with(small, {{"4sps-spr", "4sps-srp"}}),
                "scenario.toml:4:7: error: no mechanism is called \"4sps-srp\"; did you mean \"4sps-spr\"?\n"
                "  use = \"4sps-srp\"\n"
                "        ^\n"
                "  hint: the mechanisms are ");
}

TEST_CASE("a dependent coordinate cannot be prescribed") {
  check_refused(with(small, {{"z = ", "y = \"1 mm\"\nz = "}}), "scenario.toml:10:1: error: y is a dependent coordinate of 4sps-spr");
}

TEST_CASE("parameters with which home cannot be assembled are refused with the mechanism's reason") {
  check_refused(
      with(small, {{"\"4sps-spr\"", "\"4sps-spr\"\nparameters = { revolute_axis = [1, 0, 0] }"}}),
      "scenario.toml:5:16: error: 4sps-spr refuses its parameters: home cannot be assembled: revolute_axis must be perpendicular");
}

TEST_CASE("a check of a column that the report does not have is refused") {
  check_refused(with(small, {{"kind = \"statics\"", "kind = \"mechanism\""}}),
                "\"actuator_force\" belongs to the section \"statics\", which this scenario does not have");
}

TEST_CASE("all mistakes of a file are told in one run and counted") {
  const Workshop here;
  const Result result = here.report(with(small, {{"samples = 21", "samples = 0"}, {"\"550 mm\"", "\"550 deg\""}, {"400 N", "400 mm"}}));
  CHECK(result.status == 2);
  for (const char* place : {"scenario.toml:8:11: error: ", "scenario.toml:10:5: error: ", "scenario.toml:30:9: error: ", "\n3 errors\n"})
    CHECK_THAT(result.err, Contains(place));
  CHECK(contents(here.path()).size() == 1);
}

TEST_CASE("a scenario that is not there is refused") {
  const Workshop here;
  const Result result = run_pmreport({"nowhere.toml"}, {.folder = here.path()});
  CHECK(result.status == 2);
  CHECK_THAT(result.err, Contains("nowhere.toml: error: "));
  CHECK(contents(here.path()).empty());
}

TEST_CASE("a command line that makes no sense is refused") {
  CHECK(run_pmreport({"--no-such-option"}).status == 2);
  CHECK(run_pmreport({}).status == 2);
  CHECK(run_pmreport({"describe"}).status == 2);
  CHECK(run_pmreport({"a.toml", "--threads", "0"}).status == 2);
  CHECK(run_pmreport({"a.toml", "b.toml"}).status == 2);
}
