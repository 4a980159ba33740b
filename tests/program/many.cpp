#include <tests/program/workshop.hpp>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

using namespace program_test;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

const std::string failing = with(small, {{"title = \"Small\"", "title = \"Fails & <b>bold</b>\""}, {"400 N", "1 N"}});
const std::string wrong = with(small, {{"samples", "sampels"}});

Result in(const Workshop& here, std::vector<std::string> arguments) { return run_pmreport(std::move(arguments), {.folder = here.path()}); }

}  // namespace

TEST_CASE("several scenarios get a report each, and an index that tells of all") {
  const Workshop here;
  here.write("good.toml", small);
  here.write("bad.toml", failing);
  const Result result = in(here, {"good.toml", "bad.toml", "-o", "all"});
  CAPTURE(result.out, result.err);
  CHECK(result.status == 1);
  CHECK_THAT(result.out, Contains("2 scenarios: 1 passed, 1 failed; all/index.html"));
  for (const char* file : {"good/report.html", "good/junit.xml", "bad/results.json", "index.html", "index.json"})
    CHECK(fs::exists(here / "all" / file));

  const json index = json::parse(bytes_of(here / "all/index.json"));
  CHECK(index["schema"] == "pmreport-index");
  CHECK(index["status"] == 1);
  REQUIRE(index["reports"].size() == 2);
  CHECK(index["reports"][0]["verdict"] == "passed");
  CHECK(index["reports"][0]["folder"] == "good");
  CHECK(index["reports"][0]["mechanism"] == "4sps-spr");
  CHECK(index["reports"][1]["title"] == "Fails & <b>bold</b>");
  CHECK(index["reports"][1]["verdict"] == "failed");
  for (const auto& [number, folder] : {std::pair{0, "good"}, {1, "bad"}}) {
    const json verdict = json::parse(bytes_of(here / "all" / folder / "results.json"))["verdict"];
    CHECK(index["reports"][number]["checks"] == verdict["checks"]);
    CHECK(index["reports"][number]["evidence"] == verdict["evidence"]);
  }

  const std::string html = bytes_of(here / "all/index.html");
  CHECK_THAT(html, Contains("Fails &amp; &lt;b&gt;bold&lt;/b&gt;") && !Contains("<b>bold") && Contains("href=\"good/report.html\"") &&
                       Contains("Not passed: Fails"));
  CHECK(html.find("href=\"bad/report.html\"") < html.find("href=\"good/report.html\""));
  CHECK_THAT(html, !Contains("<script") && !Contains("http:") && !Contains("https:"));
}

TEST_CASE("what one scenario does is told on its card, and the others are made all the same") {
  const Workshop here;
  here.write("wrong.toml", wrong);
  here.write("crash.toml", slider);
  here.write("good.toml", small);
  fs::create_directory(here / "plugins");
  fs::copy(FIXTURES "/crashing.so", here / "plugins/crashing.so");
  const Result result = in(here, {"wrong.toml", "none.toml", "crash.toml", "good.toml", "--plugin-path", "plugins", "-o", "all"});
  CAPTURE(result.out, result.err);
  CHECK(result.status == 3);
  CHECK_THAT(result.err, Contains("did you mean \"samples\"?") && Contains("no such file"));
  const json reports = json::parse(bytes_of(here / "all/index.json"))["reports"];
  REQUIRE(reports.size() == 4);
  CHECK(reports[0]["status"] == 2);
  CHECK_THAT(reports[0]["error"].get<std::string>(), Contains("wrong.toml:8:1: error: unknown key \"sampels\""));
  CHECK_THAT(reports[1]["error"].get<std::string>(), Contains("there is no such file"));
  CHECK(reports[2]["status"] == 3);
  CHECK(reports[2]["verdict"] == "error");
  CHECK(reports[3]["verdict"] == "passed");
  CHECK(fs::exists(here / "all/good/report.html"));
  CHECK_FALSE(fs::exists(here / "all/wrong"));
  const std::string html = bytes_of(here / "all/index.html");
  CHECK_THAT(html, Contains("did you mean &quot;samples&quot;?") && Contains("the mechanism&#39;s plugin failed"));
}

TEST_CASE("equal names get numbers, and a run again gives the same bytes") {
  const Workshop here;
  fs::create_directory(here / "other");
  here.write("a.toml", small);
  here.write("other/a.toml", failing);
  REQUIRE(in(here, {"a.toml", "other/a.toml"}).status == 1);  // in "reports", here
  CHECK(json::parse(bytes_of(here / "reports/a/results.json"))["title"] == "Small");
  CHECK(json::parse(bytes_of(here / "reports/a-2/results.json"))["title"] == "Fails & <b>bold</b>");
  const auto before = contents(here / "reports");
  REQUIRE(in(here, {"a.toml", "other/a.toml"}).status == 1);
  CHECK(contents(here / "reports") == before);
}

TEST_CASE("a card shows the first snapshot, within the page") {
  const Workshop here;
  here.write("a.toml", std::string(small) + "\n[[section]]\nkind = \"snapshots\"\nsize = [640, 480]\n");
  here.write("b.toml", small);
  REQUIRE(in(here, {"a.toml", "b.toml"}).status == 0);
  const std::string html = bytes_of(here / "reports/index.html");
  const std::size_t picture = html.find("<img src=\"data:image/png;base64,"), words = html.find("\" alt=\"", picture);
  REQUIRE(words != std::string::npos);
  CHECK(words - picture > 10000);
  CHECK(html[words + 7] != '"');
  CHECK(html.find("<img", words) == std::string::npos);
}

TEST_CASE("several scenarios are validated, and nothing is written") {
  const Workshop here;
  here.write("a.toml", small);
  here.write("b.toml", wrong);
  const Result result = in(here, {"a.toml", "b.toml", "--check"});
  CHECK(result.status == 2);
  CHECK_THAT(result.out, Contains("a.toml: valid"));
  CHECK_FALSE(fs::exists(here / "reports"));
}

TEST_CASE("an index takes the place of no page of another's, and no report's") {
  const Workshop here;
  here.write("a.toml", small);
  here.write("b.toml", small);
  fs::create_directory(here / "site");
  here.write("site/index.html", "<p>My own</p>");
  const Result page = in(here, {"a.toml", "b.toml", "-o", "site"});
  CHECK(page.status == 4);
  CHECK_THAT(page.err, Contains("site/index.html is no index of reports"));
  REQUIRE(in(here, {"a.toml", "-o", "one"}).status == 0);
  const Result report = in(here, {"a.toml", "b.toml", "-o", "one"});
  CHECK(report.status == 4);
  CHECK_THAT(report.err, Contains("one is a report"));
}

TEST_CASE("two words that are no files are told, and no folder is made") {
  const Workshop here;
  const Result result = in(here, {"descrbe", "delta"});
  CHECK(result.status == 2);
  CHECK_THAT(result.err, Contains("there is no file \"descrbe\" and \"delta\"") && Contains("--help"));
  CHECK_FALSE(fs::exists(here / "reports"));
}

TEST_CASE("an interruption ends all, and leaves an earlier index as it was") {
  const Workshop here;
  here.write("a.toml", small);
  here.write("b.toml", small);
  REQUIRE(in(here, {"a.toml", "b.toml"}).status == 0);
  const auto before = contents(here / "reports");
  here.write("long.toml", with(small, {{"samples = 21", "samples = 400000"}}));
  Process process({PROGRAM, "a.toml", "long.toml", "b.toml"}, {.folder = here.path(), .terminal = true});
  REQUIRE(process.says("2 of 3: long.toml"));
  process.send(SIGTERM);
  const Result result = process.finish();
  CAPTURE(result.err);
  CHECK(result.status == 143);
  CHECK(contents(here / "reports") == before);
}

TEST_CASE("a scenario that fails is told to fail also where the ends of children are ignored") {
  const Workshop here;
  here.write("good.toml", small);
  here.write("bad.toml", failing);
  const Result r =
      run({"/bin/sh", "-c", "trap '' CHLD; exec " + std::string(PROGRAM) + " good.toml bad.toml -o all"}, {.folder = here.path()});
  CAPTURE(r.err);
  CHECK(r.status == 1);
  CHECK(json::parse(bytes_of(here / "all/index.json"))["status"] == 1);
}

TEST_CASE("a process that a plugin leaves behind keeps no other scenario waiting") {
  const Workshop here;
  fs::create_directory(here / "plugins");
  fs::copy_file(fs::path(FIXTURES) / "forking.so", here / "plugins" / "forking.so");
  here.write("a.toml", slider);
  const Result r = run_pmreport({"a.toml", "a.toml", "-o", "all", "--plugin-path", "plugins"},
                                {.folder = here.path(), .out = here / "out", .no_err = true});
  CHECK(r.status == 0);
  CHECK(fs::exists(here / "all/index.html"));
  CHECK_FALSE(fs::exists(here / "left-ended"));  // which it makes at its end
}

TEST_CASE("who makes several reports and is killed takes the one at work along") {
  const Workshop here;
  here.write("long.toml", with(small, {{"samples = 21", "samples = 200001"}}));
  Process process({PROGRAM, "long.toml", "long.toml", "-o", "all"}, {.folder = here.path()});
  const auto begun = [&] {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(here / "all", none))
      if (entry.path().extension() == ".partial") return true;
    return false;
  };
  for (int k = 0; k < 1000 && !begun(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  REQUIRE(begun());
  process.send(SIGKILL);
  process.finish();
  for (int k = 0; k < 1000 && begun(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  CHECK_FALSE(begun());
  CHECK_FALSE(fs::exists(here / "all/long"));
}
