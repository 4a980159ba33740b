// The six states of a line of evidence, in every form of the report.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <reports/document/finding.hpp>
#include <reports/document/tally.hpp>
#include <reports/document/write.hpp>

#include <tests/document/pdf/pdf_tools.hpp>
#include <tests/document/sample.hpp>

#include <limits>
#include <utility>

using namespace pmreport::document;
using nlohmann::json;
using sample::contains;
using sample::count;

namespace {

const double unknown_number = std::numeric_limits<double>::quiet_NaN();

// A line in each state, its reason "because of STATE".
Evidence line_in(Verdict state) {
  const std::string claim = "a claim " + word_of(state), reason = "because of " + word_of(state);
  switch (state) {
    case Verdict::passed:
      return {claim, "compared", 1e-12, 1e-9, "m"};
    case Verdict::failed:
      return {claim, "compared", 1e-6, 1e-9, "m", reason};
    case Verdict::error:
      return {claim, "compared", unknown_number, 1e-9, "m", reason};
    default:
      return Evidence::without_value(state, claim, "compared", reason);
  }
}

// As many lines of each state as told.
Report with(std::initializer_list<std::pair<Verdict, int>> lines) {
  Report r;
  r.title = "States";
  r.sections = {{"every-instant", "every-instant", "At every instant", {Proof{}}}};
  for (const auto& [state, times] : lines)
    for (int i = 0; i < times; ++i) std::get<Proof>(r.sections[0].blocks[0]).lines.push_back(line_in(state));
  return r;
}

Report with_all() {
  return with({{Verdict::passed, 7},
               {Verdict::failed, 2},
               {Verdict::not_decided, 3},
               {Verdict::not_examined, 4},
               {Verdict::not_applicable, 5},
               {Verdict::error, 6}});
}

}  // namespace

TEST_CASE("what is not decided, not examined or not applicable does not fail a report: a failure and an error do") {
  for (const Verdict state : {Verdict::passed, Verdict::not_decided, Verdict::not_examined, Verdict::not_applicable}) {
    CAPTURE(word_of(state));
    CHECK(line_in(state).verdict() == state);
    CHECK(with({{state, 1}}).passed());
  }
  for (const Verdict state : {Verdict::failed, Verdict::error}) {
    CAPTURE(word_of(state));
    CHECK(line_in(state).verdict() == state);
    CHECK_FALSE(with({{Verdict::passed, 3}, {state, 1}}).passed());
  }
}

TEST_CASE("results.json counts the six states apart, and gives every line its own") {
  const json j = json::parse(to_json(with_all()));
  CHECK(j["verdict"]["evidence"] == json::parse(R"({"total": 27, "passed": 7, "failed": 2, "not_decided": 3, "not_examined": 4,
      "not_applicable": 5, "error": 6})"));
  const json& lines = j["sections"][0]["evidence"];
  CHECK(lines[0]["state"] == "passed");
  CHECK(lines[0]["passed"] == true);
  CHECK(lines[7]["state"] == "failed");
  CHECK(lines[9]["state"] == "not_decided");
  CHECK(lines[9]["passed"] == false);
  CHECK(lines[9]["reason"] == "because of not decided");
  CHECK(lines[9]["value"].is_null());
  CHECK(lines[12]["state"] == "not_examined");
  CHECK(lines[16]["state"] == "not_applicable");
  CHECK(lines[21]["state"] == "error");
  CHECK(lines[21]["status"] == "not finite");
}

TEST_CASE("JUnit skips what is not decided, not examined or not applicable, and says which: an error is an error") {
  const std::string xml = to_junit(with_all());
  CHECK(contains(xml, "name=\"States\" tests=\"27\" failures=\"2\" errors=\"6\" skipped=\"12\""));
  CHECK(contains(xml, "name=\"every-instant\" tests=\"27\" failures=\"2\" errors=\"6\" skipped=\"12\""));
  CHECK(count(xml, "<skipped message=\"not decided: because of not decided") == 3);
  CHECK(count(xml, "<skipped message=\"not examined: because of not examined") == 4);
  CHECK(count(xml, "<skipped message=\"not applicable: because of not applicable") == 5);
  CHECK(count(xml, "<failure type=\"evidence\"") == 2);
  CHECK(count(xml, "<error type=\"evidence\"") == 6);
  CHECK(contains(xml, "message=\"has no value: because of error; tolerance"));
}

TEST_CASE("the page counts the states that occur, and no other") {
  const std::string all = to_html(with_all()), some = to_html(with({{Verdict::passed, 2}, {Verdict::not_decided, 1}}));
  CHECK(contains(all, "<dt>27 lines of evidence</dt>"));
  for (const char* state : {"passed\">7 passed", "failed\">2 failed", "not-decided\">3 not decided", "not-examined\">4 not examined",
                            "not-applicable\">5 not applicable", "error\">6 error"})
    CHECK(contains(all, std::string("<li class=\"state ") + state + "</li>"));
  CHECK(contains(some, "<dt>3 lines of evidence</dt>"));
  CHECK(count(some, "<li class=\"state ") == 2);
}

TEST_CASE("every state has its word in the table of the page, with its reason: a statement has no numbers") {
  const std::string html = to_html(with_all());
  CHECK(count(html, "✓ passed") == 7);
  CHECK(count(html, "✗ failed") == 2);
  CHECK(count(html, "? not decided") == 3);
  CHECK(count(html, "– not examined") == 4);
  CHECK(count(html, "– not applicable") == 5);
  CHECK(count(html, "✗ error") == 6);
  CHECK(contains(html, "compared; not decided: because of not decided"));
  CHECK(contains(html, "compared; because of failed"));
  CHECK(count(html, "<td class=\"number\">–</td>") == 2 * (3 + 4 + 5));
  CHECK(count(html, "<td class=\"number\">not computed</td>") == 2 * 6);  // in its table, and among the failures
}

TEST_CASE("the PDF counts the states that occur on its first page, and names each in its table") {
  const auto text = sample::ask("pdftotext -layout {} -", to_pdf(with_all()));
  if (!text) return;
  for (const char* part : {"no checks", "27 lines of evidence", "7 passed", "6 error", "3 not decided", "4 not examined",
                           "5 not applicable", "ERROR", "FAIL", "not decided", "not examined", "not applicable", "pass"}) {
    CAPTURE(part);
    CHECK(contains(*text, part));
  }
  const auto plain = sample::ask("pdftotext -layout {} -", to_pdf(with({{Verdict::passed, 2}})));
  CHECK(contains(*plain, "2 passed"));
}

TEST_CASE("what a check tells already a list of failures does not tell again") {
  Report r = with({{Verdict::failed, 1}});
  std::get<Proof>(r.sections[0].blocks[0]).lines[0].demanded_by = "strokes are kept";
  const std::string told = "a claim failed</a>";
  CHECK(contains(to_html(r), told));  // no such check: it stands for itself
  r.checks.push_back({"strokes are kept", "1 time", "none", 1, 0, "", false, "l3 leaves its stroke"});
  CHECK_FALSE(contains(to_html(r), told));
  CHECK(contains(to_html(r), "<a href=\"#checks\">strokes are kept</a></div>\n<div class=\"how\">l3 leaves its stroke"));
  r.checks[0].passed = true;
  CHECK(contains(to_html(r), told));
}

TEST_CASE("what was proved for every instant stands in results.json with its brackets, and what is not known is null") {
  Report r;
  const double infinity = std::numeric_limits<double>::infinity();
  EveryInstant p;
  p.sentence = "Strokes hold.";
  p.begin = 0, p.end = 10, p.intervals = 323, p.evaluations = 700, p.resolution = 1e-7;
  p.claims = {{"assembly", "", "", {}, "holds", "", {}, {}},
              {"stroke", "l3", "m", {0.5, 0.8}, "broken", "", {{{1.25, 1.5}, {1.75, 2}, "above", {0.8125, 0.875}, 1.625}}, {{3, 3.5}}}};
  p.meetings = {{"crossing", {4, 4.25}}};
  p.extremes = {{"l3", "m", {0.5, 0.625}, {-infinity, infinity}, 0.25, 1.625}};
  r.every_instant = p;
  const json proof = json::parse(to_json(r))["proof"];
  CHECK(proof["examined"] == true);
  CHECK(proof["sentence"] == "Strokes hold.");
  CHECK(proof["intervals"] == 323);
  CHECK(proof["end"] == 10);
  CHECK(proof["claims"][0] == json::parse(R"({"about": "assembly", "state": "holds", "broken": [], "undecided": []})"));
  CHECK(proof["claims"][1] == json::parse(R"({"about": "stroke", "subject": "l3", "unit": "m", "range": [0.5, 0.8], "state": "broken",
      "broken": [{"begin": [1.25, 1.5], "end": [1.75, 2.0], "side": "above", "worst": [0.8125, 0.875], "at": 1.625}],
      "undecided": [[3.0, 3.5]]})"));
  CHECK(proof["meetings"] == json::parse(R"([{"what": "crossing", "time": [4.0, 4.25]}])"));
  CHECK(proof["extremes"] == json::parse(R"([{"column": "l3", "unit": "m", "least": [0.5, 0.625], "at_least": 0.25,
      "largest": [null, null], "at_largest": 1.625}])"));

  r.every_instant->unexamined = "the motion follows from forces";
  const json none = json::parse(to_json(r))["proof"];
  CHECK(none["examined"] == false);
  CHECK(none["reason"] == "the motion follows from forces");
  CHECK_FALSE(none.contains("claims"));
  r.every_instant.reset();
  CHECK_FALSE(json::parse(to_json(r)).contains("proof"));
}

TEST_CASE("a check that a bracket decides says so in results.json") {
  Report r;
  r.checks = {{"max(l1) < 700 mm", "612.4 mm", "700 mm", 0.6124, 0.7, "m", true, "", 3, true, {0.6123, 0.6125}},
              {"max(z) < 1 m", "0.5 m", "1 m", 0.5, 1, "m", true, "", 4}};
  const json checks = json::parse(to_json(r))["checks"];
  CHECK(checks[0]["decided_by"] == "proof");
  CHECK(checks[0]["bracket"] == json::array({0.6123, 0.6125}));
  CHECK(checks[1]["decided_by"] == "samples");
  CHECK_FALSE(checks[1].contains("bracket"));
}

TEST_CASE("words stand before numbers in a data file, quoted where they must be") {
  const Data d{"every_instant", {"quantity", "unit", "least_low"}, {{0.5, unknown_number}}, {{"l1", "a,b"}, {"m", "=1"}}};
  CHECK(to_csv(d) == "quantity,unit,least_low\nl1,m,0.5\n\"a,b\",'=1,\n");
  CHECK_THROWS_AS(to_csv({"d", {"a", "b"}, {{1, 2}}, {{"one"}}}), std::logic_error);
}
