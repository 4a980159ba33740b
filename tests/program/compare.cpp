// Reports held against each other and against a baseline, as a user's shell would.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <csignal>
#include <set>

using namespace program_test;
using Catch::Contains;

namespace {

const std::string faster = with(small, {{"20 mm * sin", "21 mm * sin"}});

// A folder with the report of the small scenario in `a`, of another amplitude in `b`.
struct Two {
  Workshop here;
  Two() {
    here.write("a.toml", small);
    here.write("b.toml", faster);
    for (const char* name : {"a", "b"}) REQUIRE(run({std::string(name) + ".toml", "-o", name, "-q"}).status == 0);
  }
  Result run(std::vector<std::string> arguments, Surroundings surroundings = {}) const {
    surroundings.folder = here.path();
    return run_pmreport(std::move(arguments), surroundings);
  }
  std::set<std::string> names() const {
    std::set<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(here.path())) out.insert(entry.path().filename().string());
    return out;
  }
};

}  // namespace

TEST_CASE("two reports that differ are told value by value, and the page is the same twice") {
  const Two two;
  const Result differ = two.run({"compare", "a", "b/results.json", "-o", "page/of/both"});
  CHECK(differ.status == 1);
  CHECK(differ.err.empty());
  CHECK_THAT(differ.out, Contains("These are reports of different scenarios, a.toml and b.toml."));
  CHECK_THAT(differ.out, Contains("max(x) [m]") && Contains("0.02") && Contains("0.021"));
  CHECK_THAT(differ.out, Contains("displacement  x [m]"));
  CHECK_THAT(differ.out, Contains("They differ: "));
  const auto page = contents(two.here / "page");
  REQUIRE(page.size() == 1);
  CHECK_THAT(page.at("of/both/compare.html"), Contains("They differ") && Contains("<svg") && !Contains("<script"));
  const Result again = two.run({"compare", "a", "b/results.json", "-o", "page/of/both"});
  CHECK(again.out == differ.out);
  CHECK(contents(two.here / "page") == page);

  const Result coarse = two.run({"compare", "a", "b", "--relative", "0.2", "--absolute", "1"});
  CHECK(coarse.status == 0);
  CHECK_THAT(coarse.out, Contains("They agree: ") && !Contains("max(x)"));
  const Result quiet = two.run({"compare", "a", "b", "-q"});
  CHECK(quiet.status == 1);
  CHECK((quiet.out + quiet.err).empty());
}

TEST_CASE("a scenario is compared as its report, and leaves nothing behind") {
  const Two two;
  const auto before = two.names();
  const Result same = two.run({"compare", "a", "a.toml"});
  INFO(same.out << same.err);
  CHECK(same.status == 0);
  CHECK_THAT(same.out, Contains("They agree: ") && Contains("curves"));
  CHECK(two.run({"compare", "a.toml", "b.toml"}).status == 1);
  two.here.write("bad.toml", with(small, {{"samples = 21", "samples = many"}}));
  const Result bad = two.run({"compare", "a", "bad.toml", "-o", "page"});
  CHECK(bad.status == 2);
  CHECK_THAT(bad.err, Contains("bad.toml:8:11: "));
  two.here.write("long.toml", with(small, {{"samples = 21", "samples = 200001"}}));
  Process process({PROGRAM, "compare", "a", "long.toml", "-o", "page"}, {.folder = two.here.path(), .terminal = true});
  REQUIRE(process.says("samples of"));
  process.send(SIGINT);
  CHECK(process.finish().status == 130);
  auto after = two.names();
  after.erase("bad.toml");
  after.erase("long.toml");
  CHECK(after == before);
}

TEST_CASE("what is no report, and a page that would stand in a report, are refused") {
  const Two two;
  two.here.write("half.json", bytes_of(two.here / "a/results.json").substr(0, 3000));
  for (const char* name : {"half.json", "nowhere", ".", "a/report.html", "/dev/null"}) {
    CAPTURE(name);
    const Result bad = two.run({"compare", "a", name});
    CHECK(bad.status == 2);
    CHECK(bad.out.empty());
    CHECK_THAT(bad.err, Contains("error: ") && (Contains("expected") || Contains("cannot be read")));
  }
  CHECK(two.run({"compare", "a"}).status == 2);
  CHECK(two.run({"compare", "a", "b", "--relative", "-1"}).status == 2);
  CHECK(two.run({"compare", "a", "b", "--absolute", "nan"}).status == 2);
  CHECK(two.run({"compare", "a", "b", "--baseline", "a"}).status == 2);
  const Result inside = two.run({"compare", "a", "b", "-o", "a"});
  CHECK(inside.status == 4);
  CHECK_THAT(inside.err, Contains("it holds a report. Choose another folder."));
  CHECK_FALSE(std::filesystem::exists(two.here / "a/compare.html"));
  CHECK(two.run({"compare", "a", "b", "-o", "a.toml/below"}).status == 4);
}

TEST_CASE("machines are compared in a column each") {
  const Workshop here;
  const std::string text = "title = \"t\"\n[mechanism]\nuse = \"gough\"\n[[section]]\nkind = \"transmission\"\nposes = [{}]\n";
  for (const char* machine : {"gough", "stewart", "parallel-cross"})
    here.write(std::string(machine) + ".toml", with(text, {{"gough", machine}}));
  const Result three = run_pmreport({"compare", "gough.toml", "stewart.toml", "parallel-cross.toml"}, {.folder = here.path()});
  INFO(three.out << three.err);
  CHECK(three.status == 1);
  CHECK_THAT(three.out, Contains("reports of different mechanisms, gough, stewart and parallel-cross"));
  CHECK_THAT(three.out, Contains("A         B           C  difference  relative  verdict") && Contains("differs\n"));
}

TEST_CASE("a report that is not as its baseline fails, and says what is off") {
  const Two two;
  REQUIRE(two.run({"approve", "a", "base.json"}).status == 0);
  CHECK(bytes_of(two.here / "base.json") == bytes_of(two.here / "a/results.json"));
  const Result same = two.run({"a.toml", "-o", "c", "--baseline", "base.json"});
  CHECK(same.status == 0);
  CHECK_THAT(same.out, Contains("baseline base.json: They agree: ") && !Contains("FAILED"));

  const Result other = two.run({"b.toml", "-o", "c", "--baseline", "base.json"});
  CHECK(other.status == 1);
  CHECK_THAT(other.out, Contains("FAILED  baseline: displacement max(x) [m]: 0.021, in the baseline 0.02; difference 0.001, relative"));
  CHECK(contents(two.here / "c") == contents(two.here / "b"));  // the report is written all the same
  CHECK(bytes_of(two.here / "base.json") == bytes_of(two.here / "a/results.json"));
  CHECK(two.run({"b.toml", "-o", "c", "--baseline", "base.json", "--relative", "0.2", "--absolute", "1"}).status == 0);

  // A folder has curves as well, and may be the one that is replaced.
  const Result folder = two.run({"a.toml", "-o", "c", "--baseline", "c"});
  CHECK(folder.status == 1);
  CHECK_THAT(folder.out, Contains("FAILED  baseline: displacement curve x [m]: off by -0.001 at t = 0.5 s"));

  const Result shorter = two.run({"a.toml", "-o", "c", "--baseline", "nowhere.json"});
  CHECK(shorter.status == 2);
  CHECK_THAT(shorter.err, Contains("nowhere.json: cannot be read"));
}

TEST_CASE("a value, a check and a section that come or go are off the baseline") {
  const Two two;
  two.here.write("less.toml", with(small, {{"[[section]]\nkind = \"velocity\"\n", ""}, {"below = \"400 N\"", "below = \"500 N\""}}));
  const Result less = two.run({"less.toml", "-o", "c", "--baseline", "a/results.json"});
  CHECK(less.status == 1);
  CHECK_THAT(less.out, Contains("FAILED  baseline: velocity max(x_rate) [m/s]: not here, in the baseline "));
  CHECK_THAT(less.out, Contains("FAILED  baseline: checks: max(abs(actuator_force)) < 400 N: not here, in the baseline passed"));
  CHECK_THAT(less.out, Contains("FAILED  baseline: checks: max(abs(actuator_force)) < 500 N: passed, not in the baseline"));
}

TEST_CASE("only a report that passed becomes a baseline, unless it is asked for") {
  const Two two;
  two.here.write("bad.toml", with(small, {{"below = \"400 N\"", "below = \"1 N\""}}));
  REQUIRE(two.run({"bad.toml", "-o", "bad"}).status == 1);
  const Result refused = two.run({"approve", "bad", "base.json"});
  CHECK(refused.status == 1);
  CHECK_THAT(refused.err, Contains("the report did not pass, and is no baseline; --failed approves it all the same"));
  CHECK_FALSE(std::filesystem::exists(two.here / "base.json"));
  const Result asked = two.run({"approve", "bad", "base.json", "--failed"});
  CHECK(asked.status == 0);
  CHECK_THAT(asked.out, Contains("base.json: new baseline of "));

  const Result changed = two.run({"approve", "a", "base.json"});
  CHECK(changed.status == 0);
  CHECK_THAT(changed.out, Contains("failed  –       checks   max(abs(actuator_force)) < 1 N") && Contains("base.json: replaced"));
  CHECK(bytes_of(two.here / "base.json") == bytes_of(two.here / "a/results.json"));
  CHECK_THAT(two.run({"approve", "a", "base.json"}).out, Contains("is this very baseline; nothing changed"));
}

TEST_CASE("an approval replaces nothing but a baseline, and leaves nothing beside it") {
  const Two two;
  two.here.write("notes.txt", "mine");
  const auto before = two.names();
  const Result notes = two.run({"approve", "a", "notes.txt"});
  CHECK(notes.status == 2);
  CHECK_THAT(notes.err, Contains("notes.txt: expected JSON") && Contains("Only an earlier baseline is replaced"));
  CHECK(bytes_of(two.here / "notes.txt") == "mine");
  CHECK(two.run({"approve", "a", "b"}).status == 2);
  CHECK(two.run({"approve", "a", "a/results.json"}).status == 2);
  CHECK(two.run({"approve", "nowhere", "base.json"}).status == 2);
  CHECK(two.run({"approve", "a", "no/such/base.json"}).status == 4);
  CHECK(two.names() == before);
}

TEST_CASE("a page of somebody else is no comparison, and stays") {
  const Two two;
  std::filesystem::create_directory(two.here / "site");
  two.here.write("site/compare.html", "<h1>mine</h1>");
  const Result refused = two.run({"compare", "a", "b", "-o", "site"});
  CHECK(refused.status == 4);
  CHECK_THAT(refused.err, Contains("compare.html in it is no comparison of pmreport"));
  CHECK(bytes_of(two.here / "site/compare.html") == "<h1>mine</h1>");
  CHECK(two.run({"compare", "a", "b", "-o", "page"}).status == 1);
  CHECK(two.run({"compare", "a", "b", "-o", "page"}).status == 1);
}
