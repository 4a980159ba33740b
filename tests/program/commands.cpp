// The commands beside the report, and what is printed where.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <nlohmann/json.hpp>
#include <sstream>

using namespace program_test;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("the option --check validates and writes nothing") {
  const Workshop here;
  const Result sound = here.report(small, {"--check"});
  CHECK(sound.status == 0);
  CHECK_THAT(sound.out, StartsWith("scenario.toml: valid, 21 samples, 4 sections, at most about "));
  CHECK(here.report(with(small, {{"samples", "sampels"}}), {"--check"}).status == 2);
  CHECK(contents(here.path()).size() == 1);
}

TEST_CASE("a report that passes says so in one line, and in another what is proved of all of its motion") {
  const Workshop here;
  const Result result = here.report(small);
  CHECK(result.status == 0);
  CHECK_THAT(result.out, StartsWith("passed: 6 checks, ") && Contains("; scenario-report/report.html\n"));
  CHECK_THAT(result.out, Contains("hold at every instant from 0 s to 2 s (proved, "));
  CHECK(std::count(result.out.begin(), result.out.end(), '\n') == 2);
  CHECK(result.err.empty());
}

TEST_CASE("the option --quiet prints nothing when all is well") {
  const Workshop here;
  const Result result = here.report(small, {"--quiet"}, {.terminal = true});
  CHECK(result.status == 0);
  CHECK(result.out.empty());
  CHECK(result.err.empty());
  CHECK(here.report(small, {"--check", "-q"}).out.empty());
}

TEST_CASE("progress is for a terminal alone, leaves no trace there and has no colours") {
  const Workshop here;
  const Result seen = here.report(small, {}, {.terminal = true});
  CHECK(seen.status == 0);
  CHECK_THAT(seen.err, Contains("21 samples of 4sps-spr") && Contains("writing scenario-report"));
  CHECK(seen.err.ends_with("\r\x1b[K"));
  CHECK(seen.err.find('\n') == std::string::npos);
  for (std::size_t at = 0; (at = seen.err.find('\x1b', at)) != std::string::npos; ++at) CHECK(seen.err.substr(at, 3) == "\x1b[K");

  CHECK(here.report(small, {}, {.environment = {{"CI", "true"}}, .terminal = true}).err.empty());
  CHECK(here.report(small, {}, {.environment = {{"TERM", "dumb"}}, .terminal = true}).err.empty());
  const Result plain = here.report(small, {}, {.environment = {{"NO_COLOR", "1"}}, .terminal = true});
  CHECK(plain.status == 0);
  CHECK(plain.err.find("\x1b[3") == std::string::npos);
}

TEST_CASE("list names every mechanism and its file") {
  const Result result = run_pmreport({"list"});
  CHECK(result.status == 0);
  CHECK_THAT(result.out, Contains("4sps-spr ") && Contains(PLUGINS "/4sps-spr.so\n"));
}

TEST_CASE("a program without plugins says where it has looked") {
  const Workshop here;
  std::filesystem::create_directories(here / "bin");
  std::filesystem::create_directories(here / "empty");
  std::filesystem::copy_file(PROGRAM, here / "bin/pmreport");
  const std::string program = (here / "bin/pmreport").string();
  const Result list = run({program, "list", "--plugin-path", (here / "empty").string()});
  CHECK(list.status == 3);
  CHECK_THAT(list.err, Contains("no mechanism found; searched:\n  " + (here / "empty").string() + "\n") &&
                           Contains((here / "lib/pmreport/plugins").string()));
  here.write("a.toml", small);
  const Result report = run({program, "a.toml"}, {.folder = here.path()});
  CHECK(report.status == 2);
  CHECK_THAT(report.err, Contains("a.toml:4:7: error: no mechanism is called \"4sps-spr\"") &&
                             Contains("hint: no mechanism was found at all; look at the plugin path"));
  for (const char* command : {"describe", "check"}) {
    const Result result = run({program, command, "4sps-spr"});
    CHECK(result.status == 3);
    CHECK_THAT(result.err, Contains("no mechanism is called '4sps-spr'; known: none"));
  }
}

TEST_CASE("plugins are found by --plugin-path, by PMREPORT_PLUGIN_PATH and in the user's folder") {
  const Workshop here;
  std::filesystem::create_directories(here / "pmreport/plugins");
  std::filesystem::copy_file(FIXTURES "/plain.so", here / "pmreport/plugins/plain.so");
  const std::string folder = (here / "pmreport/plugins").string();
  CHECK(run_pmreport({"list"}).out.find("plain-slider") == std::string::npos);
  CHECK_THAT(run_pmreport({"list", "--plugin-path", folder}).out, Contains("plain-slider"));
  CHECK_THAT(run_pmreport({"list"}, {.environment = {{"PMREPORT_PLUGIN_PATH", "/nonexistent:" + folder}}}).out, Contains("plain-slider"));
  CHECK_THAT(run_pmreport({"list"}, {.environment = {{"XDG_DATA_HOME", here.path().string()}}}).out, Contains("plain-slider"));
}

TEST_CASE("two plugins of one name are an error that names both files") {
  const Workshop here;
  std::filesystem::copy_file(PLUGINS "/4sps-spr.so", here / "twin.so");
  const Result result = here.report(small, {"--plugin-path", here.path().string()});
  CHECK(result.status == 3);
  CHECK_THAT(result.err, Contains((here / "twin.so").string()) && Contains(PLUGINS "/4sps-spr.so"));
}

TEST_CASE("a plugin that cannot be loaded is told and stops no other") {
  const Workshop here;
  here.write("broken.so", "not a library");
  const Result result = here.report(small, {"--plugin-path", here.path().string()});
  CHECK(result.status == 0);
  CHECK_THAT(result.err, StartsWith("warning: ") && Contains((here / "broken.so").string()));
}

TEST_CASE("describe tells a reader what a mechanism is") {
  const Result result = run_pmreport({"describe", "4sps-spr"});
  CHECK(result.status == 0);
  CHECK_THAT(result.out, StartsWith("4sps-spr\n") && Contains("\nindependent coordinates\n") &&
                             Contains("dependent: follows from the others") && Contains("stroke 450 mm to 850 mm") &&
                             Contains("default 400 mm") && Contains("A1   spherical"));
  CHECK(result.out.find("nan") == std::string::npos);
}

TEST_CASE("describe keeps what holds the platform apart from what drives it, and says what a drive gives") {
  const std::string arms = run_pmreport({"describe", "delta"}).out, legs = run_pmreport({"describe", "4sps-spr"}).out;
  const auto actuators = arms.find("\nactuators\n"), constraints = arms.find("\nconstraints: "), parameters = arms.find("\nparameters\n");
  REQUIRE(actuators < constraints);
  REQUIRE(constraints < parameters);
  const std::string driving = arms.substr(actuators, constraints - actuators), holding = arms.substr(constraints, parameters - constraints);
  CHECK_THAT(driving, Contains("theta2") && Contains("gives a torque [N*m]") && !Contains("couple") && !Contains("force"));
  CHECK_THAT(holding, Contains("couple2") && !Contains("theta"));
  CHECK_THAT(legs, Contains("gives a force [N]") && !Contains("torque"));
  const auto json = nlohmann::json::parse(run_pmreport({"describe", "delta", "--json"}).out);
  CHECK(json["actuators"][0]["effort"] == "torque");
  CHECK(json["actuators"][0]["effort_unit"] == "N*m");
}

TEST_CASE("check remarks on data that look odd, and passes") {
  const Result result = run_pmreport({"check", "delta", "--poses", "5"});
  CHECK(result.status == 0);
  CHECK_THAT(result.out, Contains("\ndata: nothing looks odd\n"));
}

TEST_CASE("describe --json tells a program the same") {
  const Result result = run_pmreport({"describe", "4sps-spr", "--json"});
  CHECK(result.status == 0);
  const auto json = nlohmann::json::parse(result.out);
  CHECK(json["schema_version"] == 1);
  CHECK(json["name"] == "4sps-spr");
  CHECK(json["dof"] == 5);
  CHECK(json["coordinates"].size() == 5);
  CHECK(json["derived"][0]["name"] == "y");
  CHECK(json["actuators"].size() == 5);
  CHECK(json["actuators"][0]["stroke_max"] == Approx(0.850));
  CHECK(json["joints"].size() == 15);
  CHECK(json["bodies"].size() == 12);
  CHECK(json["parameters"][0] == nlohmann::json::parse(R"({"name": "base_radius", "title": "radius r_a of the circle of A2 to A5",
    "unit": "m", "default": 0.4, "min": 0.0, "max": 100.0})"));
}

TEST_CASE("describe lists the parts that give way") {
  CHECK_THAT(run_pmreport({"describe", "p2prpu-prps"}).out,
             Contains("parts that give way, for stiffness\n  limb1        beam R11 to S1\n") &&
                 Contains("  rail2        rail along PX, loaded by R21\n"));
  const auto json = nlohmann::json::parse(run_pmreport({"describe", "gough", "--json"}).out);
  REQUIRE(json["elements"].size() == 12);
  CHECK(json["elements"][1]["name"] == "drive1");
  CHECK(json["elements"][1]["what"] == "drive of rho1");
}

TEST_CASE("describe and check of an unknown name tell the known ones") {
  for (const char* command : {"describe", "check"}) {
    CAPTURE(command);
    const Result result = run_pmreport({command, "gouhg"});
    CHECK(result.status == 3);
    CHECK_THAT(result.err, Contains("no mechanism is called 'gouhg'; known: ") && Contains("4sps-spr"));
  }
}

TEST_CASE("check passes sound mechanisms, by name and by file") {
  for (const char* name : {"4sps-spr", PLUGINS "/4sps-spr.so", FIXTURES "/plain.so"}) {
    const Result result = run_pmreport({"check", name, "--poses", "100"});
    CAPTURE(name, result.out, result.err);
    CHECK(result.status == 0);
    CHECK_THAT(result.out, Contains("home and 100 random poses") && Contains("joints close") && Contains("pass") && !Contains("FAIL"));
  }
}

TEST_CASE("check fails a mechanism whose Jacobian lies") {
  const Result result = run_pmreport({"check", FIXTURES "/lying.so", "--poses", "20"});
  CAPTURE(result.out);
  CHECK(result.status == 1);
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("jacobian gives the actuator rates ")) CHECK(line.ends_with("FAIL"));
    if (line.starts_with("joints close ")) CHECK(line.ends_with("pass"));
  }
  CHECK_THAT(result.out, Contains("jacobian gives the actuator rates ") && Contains("joints close "));
}

TEST_CASE("check of a plugin that breaks is a plugin's failure") {
  const Result result = run_pmreport({"check", FIXTURES "/faulty.so"});
  CHECK(result.status == 3);
  CHECK_THAT(result.err, Contains("the cylinder has no oil"));
  const Result none = run_pmreport({"check", FIXTURES "/no_symbol.so"});
  CHECK(none.status == 3);
  CHECK_THAT(none.err, Contains("expected the exported data symbol 'pm_plugin'"));
  const Result missing = run_pmreport({"check", "nowhere.so"});
  CHECK(missing.status == 3);
  CHECK_THAT(missing.err, Contains("nowhere.so"));
}

TEST_CASE("the version is told") {
  const Result result = run_pmreport({"--version"});
  CHECK(result.status == 0);
  CHECK_THAT(result.out, StartsWith("pmreport 1."));
}
