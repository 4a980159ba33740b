// `pmreport check` beyond the defaults of a mechanism.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <regex>

using namespace program_test;
using Catch::Contains;
using Catch::StartsWith;

namespace {

// The mechanism of a scenario whose motion leaves the reach of nothing.
const std::string scenario_with_parameters =
    with(small, {{"use = \"4sps-spr\"", "use = \"4sps-spr\"\nparameters = { base_radius = \"420 mm\", dependent = \"x\" }"},
                 {"x = \"20 mm", "y = \"20 mm"}});

std::string last_line(const std::string& out) {
  const auto end = out.find_last_not_of('\n'), begin = out.rfind('\n', end);
  return out.substr(begin + 1, end - begin);
}

}  // namespace

TEST_CASE("every mechanism of the house holds with its other choices, working modes and sizes") {
  const Result result = run_pmreport({"check", "--all"});
  INFO(result.out << result.err);
  CHECK(result.status == 0);
  CHECK_THAT(result.out, !Contains("FAIL") && !Contains("not examined"));
  // Of the Delta each other word alone, for its elbows with its materials have too many combinations: three elbows, six materials of the
  // arms and six of the rods. Of 4SPS-SPR all combinations of six dependent coordinates, of which z is refused, cones that count from home
  // or from the normal, and seven materials.
  CHECK_THAT(result.out, Contains("\n15 other choices, home and 50 random poses each: pass\n"));
  CHECK_THAT(result.out, Contains("\n69 other choices, home and 50 random poses each: pass; 14 were refused, such as: z cannot be the "
                                  "dependent coordinate"));
  CHECK(std::regex_search(result.out, std::regex("\n[3-9][0-9] other sizes, home and 50 random poses each: pass")));
}

TEST_CASE("every scenario of the house holds at its parameters and along its motion") {
  int scenarios = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(SOURCE "/plugins")) {
    if (file.path().extension() != ".toml") continue;
    const Result result = run_pmreport({"check", "--scenario", file.path().string(), "--poses", "10"});
    INFO(file.path() << "\n" << result.out << result.err);
    CHECK(result.status == 0);
    CHECK_THAT(result.out, Contains(" as " + file.path().string() + " has it: home"));
    ++scenarios;
  }
  CHECK(scenarios >= 17);
}

TEST_CASE("check looks at the poses of a scenario's motion, at its parameters") {
  const Workshop here;
  here.write("a.toml", scenario_with_parameters);
  const Result result = run_pmreport({"check", "--scenario", "a.toml", "--poses", "20"}, {.folder = here.path()});
  INFO(result.out << result.err);
  CHECK(result.status == 0);
  CHECK_THAT(result.out, StartsWith("4sps-spr as a.toml has it: home, 21 poses of its motion and 20 random poses\n"));
  const Result crowded = run_pmreport({"check", "delta", "--scenario", "a.toml"}, {.folder = here.path()});
  CHECK(crowded.status == 2);
  CHECK_THAT(crowded.err, Contains("--scenario expects nothing else"));
  here.write("bad.toml", with(small, {{"samples", "sampels"}}));
  CHECK(run_pmreport({"check", "--scenario", "bad.toml"}, {.folder = here.path()}).status == 2);
}

TEST_CASE("check takes parameters as a scenario has them, and refuses them alike") {
  const Result result = run_pmreport({"check", "delta", "--poses", "20", "--parameters", "elbow1 = \"in\", rod_length = \"1.3 m\""});
  INFO(result.out << result.err);
  CHECK(result.status == 0);
  CHECK_THAT(result.out, StartsWith("delta with elbow1 = \"in\", rod_length = \"1.3 m\": home and 20 random poses\n"));
  CHECK(run_pmreport({"check", PLUGINS "/delta.so", "--poses", "20", "--parameters", "rod_length = \"1.3 m\""}).status == 0);

  const Result unknown = run_pmreport({"check", "delta", "--parameters", "rod_lenght = \"1.3 m\""});
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.err, StartsWith("--parameters:4:16: error: unknown key \"rod_lenght\"") && Contains("did you mean \"rod_length\"?"));
  const Result refused = run_pmreport({"check", "delta", "--parameters", "rod_length = \"0.1 m\""});
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Contains("delta refuses its parameters: home has level arms"));
  CHECK(run_pmreport({"check", "delta", "gough", "--parameters", "rod_length = \"1.3 m\""}).status == 2);
}

TEST_CASE("what was not looked at is told with the reason and counted apart") {
  const Result result = run_pmreport({"check", "4sps-spr", "--poses", "0"});
  INFO(result.out);
  CHECK(result.status == 0);
  CHECK(std::regex_search(result.out, std::regex("\nlanes equal doubles +not examined: no pose but home was asked for\n")));
  CHECK(std::regex_match(last_line(result.out), std::regex("[0-9]+ passed, 4 not examined")));
}

TEST_CASE("a body that cannot be is refused at the parameter that makes it, with its principal moments") {
  const Workshop here;
  // Of xx = yy = 0.03 and xy = 0.3 the principal moments are 0.03 - 0.3 and 0.03 + 0.3.
  const Result result = here.report(
      with(small, {{"use = \"4sps-spr\"",
                    "use = \"4sps-spr\"\nparameters = { platform_mass = \"0.01 kg\", platform_inertia = [\"0.03 kg*m^2\", \"0.03 kg*m^2\", "
                    "\"0.055 kg*m^2\", \"0.3 kg*m^2\", \"0 kg*m^2\", \"0 kg*m^2\"] }"}}));
  CHECK(result.status == 2);
  CHECK_THAT(result.err, StartsWith("scenario.toml:5:43: error: 4sps-spr refuses its parameters: platform_inertia gives body platform what "
                                    "no body can have: the principal moments of its inertia are -0.27, 0.055 and 0.33 kg m^2, and none can "
                                    "be negative"));
  const Result massless = here.report(
      with(small, {{"use = \"4sps-spr\"", "use = \"4sps-spr\"\nparameters = { base_radius = \"400 mm\", cylinder_mass = \"0 kg\" }"}}));
  CHECK(massless.status == 2);
  CHECK_THAT(massless.err,
             StartsWith("scenario.toml:5:40: error: 4sps-spr refuses its parameters: cylinder_mass gives body cylinder 1 what "
                        "no body can have: ") &&
                 Contains("but its mass is 0; give it a mass, or no inertia"));
}
