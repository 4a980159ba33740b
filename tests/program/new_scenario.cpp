#include <tests/program/workshop.hpp>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <regex>
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
  std::istringstream lines(run_pmreport({"list"}).out);
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
    const Result printed = run_pmreport({"new", "scenario", name});
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
  const std::string text = run_pmreport({"new", "scenario", "delta"}).out;
  CHECK_THAT(text, StartsWith("title = \"delta: a gentle motion about home\"\n") && Contains("\n# arm_length = \"524 mm\"") &&
                       Contains("length L of an arm, from the motor's axis to the elbow; 1 mm to 100000 mm\n") &&
                       Contains("\nthat = \"max(abs(actuator_force))\"\n") && Contains("kind = \"stiffness\""));
}

TEST_CASE("a parameter of a new scenario counts once its line is one") {
  const Workshop here;
  const std::string text = with(run_pmreport({"new", "scenario", "delta"}).out, {{"# arm_length = \"524 mm\"", "arm_length = \"530 mm\""}});
  CHECK(here.report(text, {"--check"}).status == 0);
  CHECK(here.report(with(text, {{"530 mm", "530 kg"}}), {"--check"}).status == 2);
}

TEST_CASE("two new scenarios of one mechanism are the same") {
  CHECK(run_pmreport({"new", "scenario", "gough"}).out == run_pmreport({"new", "scenario", "gough"}).out);
}

TEST_CASE("a new scenario is written to a file, and over none") {
  const Workshop here;
  const std::string file = here / "mine.toml";
  CHECK(run_pmreport({"new", "scenario", "delta", "--out", file}).status == 0);
  const std::string written = bytes_of(file);
  CHECK(written == run_pmreport({"new", "scenario", "delta"}).out);
  const Result again = run_pmreport({"new", "scenario", "gough", "--out", file});
  CHECK(again.status == 2);
  CHECK_THAT(again.err, Contains("mine.toml is there already; choose another name with --out"));
  CHECK(bytes_of(file) == written);
  CHECK(run_pmreport({"new", "scenario", "delta", "--out", here / "nowhere" / "mine.toml"}).status == 4);
}

TEST_CASE("a new scenario of what is no mechanism tells what is") {
  const Result unknown = run_pmreport({"new", "scenario", "gouhg"});
  CHECK(unknown.status == 3);
  CHECK_THAT(unknown.err, Contains("no mechanism is called 'gouhg'; known: "));
  const Result file = run_pmreport({"new", "scenario", PLUGINS "/delta.so"});
  CHECK(file.status == 2);
  CHECK_THAT(file.err, Contains("expected the name of a mechanism") && Contains("--plugin-path"));
}

TEST_CASE("defaults that a new scenario tells read back as the numbers that they are, and the results say where they come from") {
  for (const char* name : {"gough", "4sps-spr"}) {
    // Every parameter as a line of its own, but for those that another stands in the place of.
    std::string text;
    std::istringstream printed(run_pmreport({"new", "scenario", name}).out);
    static const std::regex told("# [a-z_0-9]+ = .*");
    for (std::string line; std::getline(printed, line);)
      text += (std::regex_match(line, told) && line.find("not beside") == std::string::npos ? line.substr(2) : line) + "\n";
    const Workshop here;
    const Result run = here.report(text);
    CAPTURE(name, text, run.err);
    REQUIRE(run.status == 0);
    const auto results = nlohmann::json::parse(bytes_of(here.report_folder() / "results.json"));
    const auto described = nlohmann::json::parse(run_pmreport({"describe", name, "--json"}).out);
    std::size_t held = 0;
    for (const auto& p : described["parameters"])
      for (const auto& input : results["inputs"]) {
        if (input["name"] != "mechanism.parameters." + p["name"].get<std::string>()) continue;
        ++held;
        CAPTURE(input.dump(), p.dump());
        CHECK((input["source"] == "scenario") == !p.contains("unless"));
        CHECK(input["line"].is_null() == p.contains("unless"));
        if (p["default"].is_number())
          CHECK(input["value"].get<double>() == Approx(p["default"].get<double>()).epsilon(1e-15).margin(0));
        else if (p["default"].is_string())
          CHECK(input["value"] == p["default"]);
        else
          CHECK(input["value"].size() == p["default"].size());
      }
    CHECK(held == described["parameters"].size());
  }
}

TEST_CASE("what a scenario leaves to the mechanism is told to be its default, and its motion and load stand with their lines") {
  const Workshop here;
  REQUIRE(here.report(small).status == 0);
  const auto results = nlohmann::json::parse(bytes_of(here.report_folder() / "results.json"));
  const auto input = [&](const std::string& name) {
    for (const auto& i : results["inputs"])
      if (i["name"] == name) return i;
    return nlohmann::json();
  };
  CHECK(input("mechanism.parameters.base_radius")["source"] == "default of the plugin");
  CHECK(input("mechanism.parameters.base_radius")["line"].is_null());
  CHECK(input("motion.x") ==
        nlohmann::json{{"name", "motion.x"}, {"value", "20 mm * sin(2*pi*t/2 s)"}, {"unit", ""}, {"source", "scenario"}, {"line", 9}});
  CHECK(input("load.force")["value"] == "[0 N, 10 N, -10 N]");
}
