// A mechanism of one's own: from `pmreport new mechanism` to its report, and what cannot be its name or its place.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>
#include <sstream>

using namespace program_test;
using Catch::Contains;
using Catch::StartsWith;
namespace fs = std::filesystem;

namespace {

Result make(const Workshop& here, const std::string& name, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"new", "mechanism", name});
  return run_pmreport(more, {.folder = here.path()});
}

// JointKind gives joint-kind.
std::string dashed(const std::string& name) {
  std::string out;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z')
      out += (out.empty() ? "" : "-") + std::string(1, static_cast<char>(c - 'A' + 'a'));
    else
      out += c;
  }
  return out;
}

}  // namespace

TEST_CASE("a new mechanism builds against the installed program, has every property and reports") {
  const Workshop here;
  const fs::path prefix = install(here);
  // The compiler and the generator of this build, and no mercy; else as the README of the new folder says.
  const std::string path = (prefix / "bin").string() + ":" + fs::path(CMAKE).parent_path().string() + ":" + std::getenv("PATH");
  const std::map<std::string, std::string> environment{{"PATH", path},
                                                       {"CXX", CXX},
                                                       {"CMAKE_GENERATOR", GENERATOR},
                                                       {"CMAKE_BUILD_TYPE", "Debug"},
                                                       {"CXXFLAGS", "-Wall -Wextra -Wconversion -Werror"}};
  const Result made = succeed({"sh", "-c", "pmreport new mechanism my-robot"}, {.environment = environment, .folder = here.path()});
  CHECK_THAT(made.out, StartsWith("my-robot: mechanism.cpp, CMakeLists.txt, scenario.toml") && Contains("README.md"));

  const std::string readme = bytes_of(here / "my-robot/README.md"), opening = "```sh\n";
  const auto begin = readme.find(opening) + opening.size();
  std::istringstream commands(readme.substr(begin, readme.find("```", begin) - begin));
  std::string all;
  int count = 0;
  for (std::string command; std::getline(commands, command); ++count)
    all += succeed({"sh", "-c", command}, {.environment = environment, .folder = here / "my-robot"}).out;
  CHECK(count == 3);
  CHECK_THAT(all, Contains("my-robot: home and 1000 random poses") && !Contains("FAIL") && Contains("passed: "));

  CHECK(fs::exists(here / "my-robot/scenario-report/report.html"));
  CHECK(fs::exists(here / "my-robot/scenario-report/snapshots/mechanism.png"));
  // At the start every limb runs from 0.5 m out to 0.15 m aside.
  const auto lengths = columns(here / "my-robot/scenario-report/data/displacement.csv");
  for (const char* limb : {"l1", "l2", "l3"}) CHECK(lengths.at(limb).at(0) == Approx(std::hypot(0.5, 0.15)).epsilon(1e-12));
}

TEST_CASE("the folder of a new mechanism holds four files that bear its name") {
  const Workshop here;
  REQUIRE(make(here, "para-3rps", {"--folder", "mine/robots"}).status == 0);
  const auto files = contents(here / "mine/robots/para-3rps");
  REQUIRE(files.size() == 4);
  CHECK_THAT(files.at("mechanism.cpp"), StartsWith("// para-3rps, ") && Contains("class Para3rps : public Mechanism<3>") &&
                                            Contains("PMREPORT_PLUGIN(Para3rps)") && Contains("name = \"para-3rps\";"));
  CHECK_THAT(files.at("CMakeLists.txt"), Contains("pmreport_add_mechanism(para-3rps mechanism.cpp)"));
  CHECK_THAT(files.at("scenario.toml"), Contains("use = \"para-3rps\""));
  for (const auto& [name, text] : files) CHECK_THAT(text, !Contains("my-robot") && !Contains("MyRobot"));
}

TEST_CASE("a mechanism's name may begin with a digit, its class does not") {
  const Workshop here;
  REQUIRE(make(here, "3-rps").status == 0);
  const auto files = contents(here / "3-rps");
  CHECK_THAT(files.at("mechanism.cpp"),
             Contains("class Robot3Rps : public Mechanism<3>") && Contains("PMREPORT_PLUGIN(Robot3Rps)") && Contains("name = \"3-rps\";"));
  CHECK_THAT(files.at("CMakeLists.txt"), Contains("project(3-rps ") && Contains("pmreport_add_mechanism(3-rps mechanism.cpp)"));
}

TEST_CASE("a class never takes the name of something of the library") {
  const std::regex declaration("\\n(?:class|struct|enum class|concept|using) ([A-Z]\\w*)");
  std::set<std::string> taken{"Vector3d"};  // by the scaffold's own using-declaration
  for (const auto& file : fs::directory_iterator(SOURCE "/core/pmreport")) {
    const std::string text = bytes_of(file.path());
    for (auto at = std::sregex_iterator(text.begin(), text.end(), declaration); at != std::sregex_iterator(); ++at) taken.insert((*at)[1]);
  }
  CHECK(taken.size() > 20);
  CHECK(taken.contains("Joint"));
  const Workshop here;
  for (const std::string& name : taken) {
    CAPTURE(name);
    REQUIRE(make(here, dashed(name)).status == 0);
    CHECK_THAT(bytes_of(here / dashed(name) / "mechanism.cpp"), Contains("class " + name + "Mechanism : public Mechanism<3>"));
  }
}

TEST_CASE("a name that cannot be a mechanism's is refused with the rule") {
  const Workshop here;
  const std::string rule = "a mechanism's name has lower-case letters, digits and dashes, one letter at least, and begins with no dash\n";
  const std::map<std::string, std::string> refused{
      {"", "error: the name is empty; " + rule},
      {"MyRobot", "error: 'MyRobot' begins with 'M'; " + rule},
      {"42", "error: '42' has no letter; " + rule},
      {"my_robot", "error: 'my_robot' has a '_'; " + rule},
      {"my robot", "error: 'my robot' has a ' '; " + rule},
      {"../robot", "error: '../robot' begins with '.'; " + rule},
      {"robot/../x", "error: 'robot/../x' has a '/'; " + rule},
      {"robot-", "error: 'robot-': a dash stands between two words\n"},
      {"my--robot", "error: 'my--robot': a dash stands between two words\n"},
      {"test", "error: 'test' is a target of CMake's own; choose another name\n"},
      {std::string(61, 'a'), "error: the name has 61 letters; at most 60 fit\n"},
  };
  for (const auto& [name, sentence] : refused) {
    const Result result = make(here, name);
    CAPTURE(name, result.out);
    CHECK(result.status == 2);
    CHECK(result.err == sentence);
  }
  CHECK(make(here, std::string(60, 'a')).status == 0);
  CHECK(run_pmreport({"new", "mechanism"}, {.folder = here.path()}).status == 2);
  CHECK(run_pmreport({"new"}, {.folder = here.path()}).status == 2);
  CHECK(contents(here.path()).size() == 4);
}

TEST_CASE("what is there already is not touched") {
  const Workshop here;
  here.write("my-robot/mechanism.cpp", "mine");
  here.write("other-robot", "a file");
  for (const char* name : {"my-robot", "other-robot"}) {
    const Result result = make(here, name);
    CHECK(result.status == 2);
    CHECK_THAT(result.err, StartsWith("error: ") && Contains(std::string(name) + " is there already; choose another name"));
  }
  CHECK(contents(here.path()) == std::map<std::string, std::string>{{"my-robot/mechanism.cpp", "mine"}, {"other-robot", "a file"}});

  const Result known = make(here, "delta");
  CHECK(known.status == 2);
  CHECK_THAT(known.err, StartsWith("error: there is a mechanism 'delta' already, ") && Contains("delta.so; choose another name"));
}

TEST_CASE("a place where nothing can be written is told, with exit status 4") {
  const Workshop here;
  here.write("file", "no folder");
  for (const char* folder : {"file", "/proc/self"}) {
    const Result result = make(here, "my-robot", {"--folder", folder});
    CAPTURE(folder, result.err);
    CHECK(result.status == 4);
    CHECK_THAT(result.err, StartsWith("error: cannot make " + std::string(folder) + "/my-robot: ") && Contains("--folder"));
  }
  CHECK(contents(here.path()).size() == 1);
}

TEST_CASE("check of several mechanisms ends with a table of them") {
  const Result result = run_pmreport({"check", "4sps-spr", "delta", FIXTURES "/lying.so", "--poses", "20"});
  CAPTURE(result.out, result.err);
  CHECK(result.status == 1);
  const std::string table = result.out.substr(result.out.rfind("\nmechanism "));
  CHECK(std::regex_search(table, std::regex("\n4sps-spr +([0-9]+) of \\1 pass +[0-9].*[a-z]\n")));
  CHECK(std::regex_search(table, std::regex("\ndelta +([0-9]+) of \\1 pass ")));
  CHECK(std::regex_search(table, std::regex("\nplain-slider +[0-9]+ of [0-9]+ FAIL ")));
  CHECK(std::count(table.begin(), table.end(), '\n') == 5);
  CHECK(run_pmreport({"check", "4sps-spr", "delta", "--poses", "5"}).status == 0);
}

TEST_CASE("check --all checks every mechanism found") {
  const Result list = run_pmreport({"list"}), all = run_pmreport({"check", "--all", "--poses", "2"});
  CAPTURE(all.out, all.err);
  CHECK(all.status == 0);
  const std::string table = all.out.substr(all.out.rfind("\nmechanism "));
  std::istringstream lines(list.out);
  for (std::string line; std::getline(lines, line);)
    if (line[0] != ' ') CHECK_THAT(table, Contains("\n" + line.substr(0, line.find(' ')) + " "));
}

TEST_CASE("a mechanism that breaks among several is told, and the others are checked") {
  const Result result = run_pmreport({"check", FIXTURES "/faulty.so", "delta", "--poses", "5"});
  CHECK(result.status == 3);
  CHECK_THAT(result.err, Contains("the cylinder has no oil"));
  CHECK_THAT(result.out, Contains("\ndelta "));
}

TEST_CASE("check without a mechanism says what it expects") {
  const Result result = run_pmreport({"check"});
  CHECK(result.status == 2);
  CHECK(result.err == "error: check expects a mechanism, several, --all, or --scenario FILE\n");
}
