// What README.md shows works as it stands there, against the installed program and its package.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <algorithm>
#include <regex>

using namespace program_test;
using Catch::Contains;

namespace {

// The blocks of code of README.md in one language, in order.
std::vector<std::string> blocks(const std::string& language) {
  const std::string text = bytes_of(SOURCE "/README.md"), opening = "\n```" + language + "\n";
  std::vector<std::string> out;
  for (std::size_t at = 0; (at = text.find(opening, at)) != std::string::npos;) {
    at += opening.size();
    const std::size_t end = text.find("\n```\n", at);
    out.push_back(text.substr(at, end + 1 - at));
    at = end;
  }
  return out;
}

// The one block of a language that has this text.
std::string block_with(const std::string& language, const std::string& text) {
  std::vector<std::string> found;
  for (std::string& block : blocks(language))
    if (block.find(text) != std::string::npos) found.push_back(std::move(block));
  REQUIRE(found.size() == 1);
  return found.front();
}

}  // namespace

TEST_CASE("the first scenario of README.md makes a report") {
  const Workshop here;
  // At a sixteenth of the size of its pictures, which are not the point.
  const std::string quick = with(blocks("toml").at(0), {{"times = [\"0 s\", \"1 s\"]", "times = [\"0 s\", \"1 s\"]\nsize = [400, 300]"}});
  here.write("first.toml", quick);
  const Result result = run_pmreport({"first.toml"}, {.folder = here.path()});
  INFO(result.out << result.err);
  CHECK(result.status == 0);
  CHECK(std::filesystem::exists(here / "first-report/report.html"));
}

TEST_CASE("the tables of forces, drives and limits in README.md make reports") {
  const Workshop here;
  const std::string gravity = "[load]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n";
  const auto of = [&](const std::string& mechanism, const std::string& tables, const std::string& kinds) {
    std::string text = "title = \"t\"\n[mechanism]\nuse = \"" + mechanism + "\"\n" + gravity + tables;
    for (std::size_t at = 0; at < kinds.size();) {
      const std::size_t end = std::min(kinds.find(' ', at), kinds.size());
      text += "[[section]]\nkind = \"" + kinds.substr(at, end - at) + "\"\n";
      at = end + 1;
    }
    return text;
  };
  here.write("forces.toml", of("stewart", block_with("toml", "from = \"forces\""), "dynamics"));
  here.write("limits.toml",
             of("gough", block_with("toml", "[drive.rho1]") + "[motion]\nduration = \"2 s\"\nsamples = 51\nx = \"5 mm * sin(pi*t/1 s)\"\n",
                "dynamics drives reactions speed"));
  for (const char* file : {"forces.toml", "limits.toml"}) {
    const Result result = run_pmreport({file}, {.folder = here.path()});
    INFO(file << '\n' << result.out << result.err);
    CHECK(result.status == 0);
  }
}

TEST_CASE("the workspace of README.md makes a report") {
  const Workshop here;
  here.write("reach.toml", block_with("toml", "where it reaches"));
  const Result report = run_pmreport({"reach.toml"}, {.folder = here.path()});
  INFO(report.out << report.err);
  CHECK(report.status == 0);
  CHECK(std::filesystem::exists(here / "reach-report/data/workspace.csv"));
}

TEST_CASE("the transmission of README.md makes a report, and its check passes") {
  const Workshop here;
  here.write("moves.toml", block_with("toml", "kind = \"transmission\""));
  const Result report = run_pmreport({"moves.toml"}, {.folder = here.path()});
  INFO(report.out << report.err);
  CHECK(report.status == 0);
  CHECK(std::filesystem::exists(here / "moves-report/data/transmission-map.csv"));
}

TEST_CASE("the installed program finds its plugins where it was installed") {
  const Workshop here;
  const std::string program = (install(here) / "bin/pmreport").string();
  const Result list = run({program, "list"});
  CHECK(list.status == 0);
  CHECK_THAT(list.out, Contains("4sps-spr") && Contains("delta") && Contains((here / "prefix").string()) && !Contains(BINARY));
}

TEST_CASE("the pieces of a mechanism in README.md stand in plugins/delta/mechanism.cpp, in the same order") {
  const std::string source = bytes_of(SOURCE "/plugins/delta/mechanism.cpp");
  auto pieces = blocks("cpp");
  REQUIRE(pieces.size() == 7);
  pieces.pop_back();  // an iteration, of another mechanism, which has a test of its own
  for (const std::string& piece : pieces) {
    CAPTURE(piece);
    CHECK_THAT(source, Contains(piece));
  }
  CHECK(source.find(pieces[3]) < source.find(pieces[4]));  // place, then jacobian
  CHECK_THAT(pieces[3], Contains("void place("));
  CHECK_THAT(pieces[4], Contains("jacobian("));
}

TEST_CASE("the Delta's scenario of README.md makes a report") {
  const Workshop here;
  here.write("around.toml", block_with("toml", "goes once around"));
  const Result result = run_pmreport({"around.toml"}, {.folder = here.path()});
  INFO(result.out << result.err);
  CHECK(result.status == 0);
  const auto statics = columns(here / "around-report/data/statics.csv");
  for (const char* motor : {"theta1_force", "theta2_force", "theta3_force"}) {
    REQUIRE(statics.at(motor).size() == 101);
    for (const double torque : statics.at(motor)) CHECK(torque < 0);  // the motors hold the weights up, and positive lowers
  }
}

TEST_CASE("README.md shows the commands and the CMakeLists.txt of a new mechanism") {
  const Workshop here;
  REQUIRE(run_pmreport({"new", "mechanism", "my-robot"}, {.folder = here.path()}).status == 0);
  REQUIRE(blocks("cmake").size() == 1);
  CHECK(blocks("cmake")[0] == bytes_of(here / "my-robot/CMakeLists.txt"));
  const std::string readme = bytes_of(here / "my-robot/README.md"), opening = "```sh\n";
  const auto begin = readme.find(opening) + opening.size();
  const auto shown = blocks("sh");
  CHECK(std::find(shown.begin(), shown.end(),
                  "pmreport new mechanism my-robot\ncd my-robot\n" + readme.substr(begin, readme.find("```", begin) - begin)) !=
        shown.end());
}

TEST_CASE("README.md names every option and every exit status of the program") {
  const std::string text = bytes_of(SOURCE "/README.md"), help = run_pmreport({"--help"}).out;
  const std::regex option("--[a-z][a-z-]+");
  int options = 0;
  for (auto at = std::sregex_iterator(help.begin(), help.end(), option); at != std::sregex_iterator(); ++at) {
    if (at->str() == "--help" || at->str() == "--version") continue;
    ++options;
    CHECK_THAT(text, Contains(at->str()));
  }
  CHECK(options >= 5);
  for (const char* command : {"list", "describe", "check", "new"}) {
    CHECK_THAT(help, Contains(command));
    CHECK_THAT(text, Contains(std::string("`pmreport ") + command));
  }
  for (const char* picture : {SOURCE "/plugins/gallery.png", SOURCE "/plugins/delta/home.png"}) {
    REQUIRE(std::filesystem::exists(picture));
    CHECK(std::filesystem::file_size(picture) < 300 * 1024);
    CHECK_THAT(text, Contains("](" + std::string(picture).substr(std::string(SOURCE "/").size()) + ")"));
  }
}
