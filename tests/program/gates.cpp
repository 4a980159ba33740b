// The gates of a report: what they measure is what the data say, and exit status, junit.xml and results.json agree.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace program_test;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

std::string checked(const std::string& checks) { return std::string(small.substr(0, small.find("[[check]]"))) + checks; }
std::string check(const std::string& that, const std::string& bound) { return "[[check]]\nthat = \"" + that + "\"\n" + bound + "\n\n"; }

Json gate_results(const Workshop& here) { return Json::parse(bytes_of(here.report_folder() / "results.json")); }

// junit.xml is sound XML, counts what it holds, and agrees with the exit status and with gate_results.json.
void check_consistent(const Workshop& here, int status) {
  const Json json = gate_results(here);
  int failed = 0, errors = 0, all = 0;
  for (const Json& c : json["checks"]) ++all, failed += c["passed"] ? 0 : 1;
  for (const Json& s : json["sections"])
    for (const Json& e : s["evidence"]) ++all, failed += e["state"] == "failed", errors += e["state"] == "error";
  CHECK(json["verdict"]["passed"] == (status == 0));
  CHECK((failed + errors > 0) == (status == 1));

  const std::string file = (here.report_folder() / "junit.xml").string(), junit = bytes_of(file);
  const Result lint = run({"xmllint", "--noout", file});
  INFO(lint.err);
  CHECK(lint.status == 0);
  CHECK(count_of(junit, "<testcase ") == all);
  CHECK(count_of(junit, "<failure ") == failed);
  CHECK(count_of(junit, "<error ") == errors);
  CHECK_THAT(junit, Contains("tests=\"" + std::to_string(all) + "\" failures=\"" + std::to_string(failed) + "\""));
}

}  // namespace

TEST_CASE("gates measure what the data say: largest, smallest, mean square, at a time, absolute, over a group") {
  const Workshop here;
  // Each bound can be met; what is measured is compared with the data below.
  REQUIRE(here.report(checked(check("max(l1)", "below = \"10 m\"") + check("min(l1)", "above = \"1 mm\"") +
                              check("rms(l1_rate)", "below = \"10 m/s\"") + check("at(l1, 0.75 s)", "below = \"10 m\"\nabove = \"1 mm\"") +
                              check("max(abs(actuator_force))", "below = \"1 MPa*m^2\"") + check("max(condition)", "below = \"1e6\"")))
              .status == 0);
  check_consistent(here, 0);
  const auto displacement = columns(here.report_folder() / "data/displacement.csv"),
             velocity = columns(here.report_folder() / "data/velocity.csv"), statics = columns(here.report_folder() / "data/statics.csv");
  const std::vector<double>&l = displacement.at("l1"), &rate = velocity.at("l1_rate"), &condition = velocity.at("condition");
  double squares = 0, force = 0;
  for (const double x : rate) squares += x * x;
  for (const char* f : {"l1_force", "l2_force", "l3_force", "l4_force", "l5_force"})
    for (const double x : statics.at(f)) force = std::max(force, std::abs(x));
  const double expected[] = {*std::max_element(l.begin(), l.end()),
                             *std::min_element(l.begin(), l.end()),
                             std::sqrt(squares / 21),
                             (9 * (l[7] + l[8]) - l[6] - l[9]) / 16,  // 0.75 s lies halfway between two samples: the cubic through four
                             force,
                             *std::max_element(condition.begin(), condition.end())};
  const Json checks = gate_results(here)["checks"];
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    INFO(checks[i]["name"]);
    // The data have all digits. The cubic misses 3 h^4 / 128 times a fourth derivative, of 20 mm pi^4 / s^4 or so; a line 0.1 mm.
    CHECK(checks[i]["value"].get<double>() == Approx(expected[i]).epsilon(1e-12).margin(i == 3 ? 1e-5 : 0));
  }
}

TEST_CASE("a broken gate fails the run, with the sample, the column, the value and the bound") {
  const Workshop here;
  const Result result = here.report(checked(check("max(abs(actuator_force))", "below = \"1 N\"") + check("min(z)", "above = \"551 mm\"") +
                                            check("max(z)", "below = \"551 mm\"")));
  CHECK(result.status == 1);
  CHECK_THAT(result.out, Contains("FAILED  max(abs(actuator_force)) < 1 N: t = ") && Contains("_force is ") &&
                             Contains("which is not below 1 N") && Contains("min(z): z is 550 mm, which is not above 551 mm") &&
                             !Contains("max(z)") && Contains("FAILED: 8 checks, ") &&
                             Contains(", 2 failed; scenario-report/report.html\n"));
  check_consistent(here, 1);
  CHECK_THAT(bytes_of(here.report_folder() / "junit.xml"), Contains("file=\"scenario.toml\" line=\"28\""));
}

TEST_CASE("the option --quiet keeps the exit status of a broken gate") {
  const Workshop here;
  const Result result = here.report(with(small, {{"400 N", "1 N"}}), {"--quiet"});
  CHECK(result.status == 1);
  CHECK(result.out.empty());
}

TEST_CASE("results.json says what made it and what it holds") {
  const Workshop here;
  REQUIRE(here.report(small).status == 0);
  const Json json = gate_results(here);
  CHECK(json["schema_version"] == 2);
  CHECK(json["title"] == "Small");
  CHECK(json["mechanism"]["name"] == "4sps-spr");
  const Json& from = json["provenance"];
  CHECK(from["program"] == "pmreport");
  CHECK("pmreport " + from["version"].get<std::string>() + "\n" == run_pmreport({"--version"}).out);
  CHECK(from["scenario"] == "scenario.toml");
  CHECK(run({"sha256sum", (here / "scenario.toml").string()}).out.substr(0, 64) == from["scenario_sha256"]);
  CHECK_FALSE(from["plugin_build"].get<std::string>().empty());
  // Every file of the folder is listed, and every listed file is there.
  std::map<std::string, std::string> files = contents(here.report_folder());
  for (const Json& name : json["files"]) {
    INFO(name);
    CHECK(files.erase(name.get<std::string>()) == 1);
  }
  CHECK(files.empty());
  CHECK(bytes_of(here.report_folder() / "results.json").find(here.path().string()) == std::string::npos);
}

TEST_CASE("the travel of a slide that no drive moves is told, judged at every sample, and proved between them") {
  const auto with_travel = [](const std::string& travel) {
    return "title = \"Slide\"\n[mechanism]\nuse = \"5pus-upu\"\nparameters = { leg_travel = \"" + travel +
           "\" }\n[motion]\nduration = \"2 s\"\nsamples = 5\nz = \"8 mm * step5(t, 0 s, 1 s)\"\n"
           "[[section]]\nkind = \"displacement\"\n"
           "[[check]]\nthat = \"max(abs(joint_travel))\"\nabove = \"7 mm\"\n";
  };
  const Workshop here;
  const Result within = here.report(with_travel("20 mm"));
  INFO(within.out << within.err);
  CHECK(within.status == 0);
  CHECK_THAT(bytes_of(here.report_folder() / "data/displacement.csv"), Contains("P6_travel [m]"));
  const Result beyond = here.report(with_travel("5 mm"));
  CHECK(beyond.status == 1);
  const std::string html = bytes_of(here.report_folder() / "report.html");
  INFO(beyond.out << beyond.err);
  CHECK_THAT(html, Contains("joint P6"));
  CHECK_THAT(html, Contains("its limit is 5 mm"));
}
