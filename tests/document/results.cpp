// results.json and junit.xml, as a program reads them.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <reports/document/data/results.hpp>
#include <reports/document/write.hpp>

#include <tests/document/sample.hpp>

using namespace pmreport::document;
using nlohmann::json;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

Evidence& last_evidence(Report& r) { return std::get<Proof>(r.sections.back().blocks.back()).lines.back(); }

Report hostile() {
  Report r = sample::report();
  r.title = "<script>alert(1)</script> & \"]]>\" \x01\x1f\xff";
  r.sections[0].title = r.checks[0].name = r.checks[0].message = last_evidence(r).claim = r.title;
  r.checks[0].passed = false;
  return r;
}

}  // namespace

TEST_CASE("a report passes when every check and every line of evidence does") { CHECK(sample::report().passed()); }

TEST_CASE("a report without checks and evidence passes") { CHECK(Report{}.passed()); }

TEST_CASE("one broken promise fails the report") {
  Report r = sample::report();
  SECTION("a check") { r.checks[0].passed = false; }
  SECTION("a residual above its tolerance") { last_evidence(r).value = 1.1 * last_evidence(r).tolerance; }
  SECTION("evidence that could not be computed") { last_evidence(r).value = not_a_number; }
  CHECK_FALSE(r.passed());
  CHECK(json::parse(to_json(r))["verdict"]["passed"] == false);
}

TEST_CASE("a claim that nothing was held against neither passes nor fails, and every form of the report says why") {
  Report r = sample::report();
  Evidence& line = last_evidence(r);
  line = Evidence::not_examined(line.claim, line.how, "every sample is singular");
  CHECK(line.verdict() == Verdict::not_examined);
  CHECK_FALSE(line.failed());
  CHECK(r.passed());
  const json j = json::parse(to_json(r));
  CHECK(j["verdict"]["evidence"]["total"] == 4);
  CHECK(j["verdict"]["evidence"]["not_examined"] == 1);
  const json told = j["sections"].back()["evidence"].back();
  CHECK(told["passed"] == false);
  CHECK(told["status"] == "not examined");
  CHECK(told["reason"] == "every sample is singular");
  CHECK(told["value"].is_null());
  const std::string junit = to_junit(r);
  CHECK(junit.find("skipped=\"1\"") != std::string::npos);
  CHECK(junit.find("<skipped message=\"not examined: every sample is singular") != std::string::npos);
  const std::string html = to_html(r);
  CHECK(html.find("not examined: every sample is singular") != std::string::npos);
  CHECK(html.find("<li class=\"state not-examined\">1 not examined</li>") != std::string::npos);
}

TEST_CASE("results.json tells schema, verdict, checks, evidence and values") {
  const json j = json::parse(to_json(sample::report()));
  CHECK(j["schema"] == "pmreport-results");
  CHECK(j["schema_version"] == 2);
  CHECK(j["mechanism"]["name"] == "4sps-spr");
  CHECK(j["provenance"]["version"] == "1.0.0");
  CHECK(j["verdict"] == json::parse(R"({"passed": true, "checks": {"total": 1, "passed": 1, "failed": 0, "not_decided": 0,
      "not_examined": 0, "not_applicable": 0, "error": 0}, "evidence": {"total": 4, "passed": 4, "failed": 0, "not_decided": 0,
      "not_examined": 0, "not_applicable": 0, "error": 0}})"));
  CHECK(j["checks"][0]["value"] == 312.4);
  CHECK(j["checks"][0]["line"] == 13);
  CHECK(j["sections"][0]["evidence"].size() == 3);
  CHECK(j["sections"][0]["evidence"][0]["value"] == 2.1e-16);
  CHECK(j["sections"][1]["evidence"][0]["unit"] == "W");
  CHECK(j["values"][0]["name"] == "largest_actuator_force");
  CHECK(j["figures"][0]["data"] == "data/displacement.csv");
  CHECK(j["snapshots"][1]["png"] == "snapshots/pose-5.png");
  CHECK(j["data"][0]["columns"] == json::array({"t [s]", "x [m]"}));
  CHECK(j["data"][0]["rows"] == 3);
}

TEST_CASE("the warnings of summary and sections stand together in results.json") {
  Report r = sample::report();
  r.sections[1].blocks.push_back(Paragraph{Paragraph::Tone::warning, "t = 2 s: out of reach"});
  const json j = json::parse(to_json(r));
  REQUIRE(j["warnings"].size() == 2);
  CHECK(j["warnings"][1] == json::parse(R"({"section": "statics", "text": "t = 2 s: out of reach"})"));
}

TEST_CASE("a number that is not finite is null in results.json, and its status says so") {
  Report r = sample::report();
  r.values[0].value = std::numeric_limits<double>::infinity();
  last_evidence(r).value = not_a_number;
  const json j = json::parse(to_json(r));
  CHECK(j["values"][0]["value"].is_null());
  CHECK(j["values"][0]["status"] == "not finite");
  CHECK(j["sections"][1]["evidence"][0]["value"].is_null());
  CHECK(j["sections"][1]["evidence"][0]["status"] == "not finite");
  CHECK(j["checks"][0]["status"] == "ok");
}

TEST_CASE("a hostile title is text in results.json, without controls, broken bytes replaced") {
  const json j = json::parse(to_json(hostile()));
  CHECK(j["title"] == "<script>alert(1)</script> & \"]]>\" \uFFFD");
}

TEST_CASE("results.json is known again as a report's, other files are not") {
  const auto files = files_listed_in(to_json(sample::report()));
  REQUIRE(files);
  CHECK(files->back() == "results.json");
  CHECK_FALSE(files_listed_in(""));
  CHECK_FALSE(files_listed_in("{}"));
  CHECK_FALSE(files_listed_in("[1, 2]"));
  CHECK_FALSE(files_listed_in(R"({"schema": "another", "files": []})"));
  CHECK_FALSE(files_listed_in(R"({"schema": "pmreport-results", "files": 3})"));
}

TEST_CASE("junit.xml has a case for each check and each line of evidence") {
  Report r = sample::report();
  last_evidence(r).value = 3e-7;
  r.checks.push_back({"min(stroke_margin) > 0 mm", "-12.4 mm", "0 mm", -0.0124, 0, "m", false, "t = 3.62 s: limb 3 is too long", 14});
  const std::string xml = to_junit(r);
  CHECK(sample::count(xml, "<testcase ") == 6);
  CHECK(sample::count(xml, "<failure ") == 2);
  CHECK(sample::contains(xml, "<testsuites name=\"4SPS-SPR: kinematics and statics\" tests=\"6\" failures=\"2\""));
  CHECK(sample::contains(xml, "<testsuite name=\"displacement\" tests=\"3\" failures=\"0\""));
  CHECK(sample::contains(xml, "name=\"virtual power balances\" classname=\"statics\""));
  CHECK(sample::contains(xml, "message=\"measured 3 × 10⁻⁷ W, tolerance 1 × 10⁻⁹ W\""));
  CHECK(sample::contains(xml, "message=\"measured -12.4 mm, limit 0 mm\""));
  CHECK(sample::contains(xml, "t = 3.62 s: limb 3 is too long"));
}

TEST_CASE("evidence without a value says why, and never compares what is not there") {
  Report r = sample::report();
  last_evidence(r).value = not_a_number;
  last_evidence(r).reason = "no sample can be assembled (the feeler is too short)";
  CHECK(sample::contains(to_junit(r),
                         "message=\"has no value: no sample can be assembled (the feeler is too short); tolerance 1 × 10⁻⁹ W\""));
  CHECK(sample::contains(to_html(r), "has no value: no sample can be assembled (the feeler is too short)"));
  const json evidence = json::parse(to_json(r))["sections"].back()["evidence"].back();
  CHECK(evidence["reason"] == "no sample can be assembled (the feeler is too short)");
  CHECK(evidence["passed"] == false);
}

TEST_CASE("junit.xml is well-formed whatever a user typed") {
  if (std::system("command -v xmllint >/dev/null") != 0) {
    WARN("xmllint is not here: well-formedness was not looked at");
    return;
  }
  const sample::Folder folder;
  for (const Report& r : {sample::report(), hostile(), Report{}}) {
    CAPTURE(r.title);
    sample::put(folder / "junit.xml", to_junit(r));
    CHECK(std::system(("xmllint --noout " + (folder / "junit.xml").string()).c_str()) == 0);
  }
}
