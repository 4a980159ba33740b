// What README.md shows works as it stands there, against the installed program and its package.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

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

void require_success(const std::vector<std::string>& command) {
  const Result result = run(command);
  INFO(result.out << result.err);
  REQUIRE(result.status == 0);
}

// The program, its plugins and the package, moved to a place of their own: nothing may lead back to where they were built.
std::filesystem::path install(const Workshop& here) {
  require_success({CMAKE, "--install", BINARY, "--prefix", (here / "built").string()});
  std::filesystem::rename(here / "built", here / "prefix");
  return here / "prefix";
}

}  // namespace

TEST_CASE("the first scenario of README.md makes a report") {
  const Workshop here;
  const auto scenarios = blocks("toml");
  REQUIRE(scenarios.size() == 2);
  // At a sixteenth of the size of its pictures, which are not the point.
  const std::string quick = with(scenarios[0], {{"times = [\"0 s\", \"1 s\"]", "times = [\"0 s\", \"1 s\"]\nsize = [400, 300]"}});
  here.write("first.toml", quick);
  const Result result = pmreport({"first.toml"}, {.folder = here.path()});
  INFO(result.out << result.err);
  CHECK(result.status == 0);
  CHECK(std::filesystem::exists(here / "first-report/report.html"));
}

TEST_CASE("the installed program finds its plugins, and the first plugin of README.md builds against it, holds and reports") {
  const Workshop here;
  const std::string program = (install(here) / "bin/pmreport").string();
  const Result list = run({program, "list"});
  CHECK(list.status == 0);
  CHECK_THAT(list.out, Contains("4sps-spr") && Contains((here / "prefix").string()) && !Contains(BINARY));

  REQUIRE(blocks("cpp").size() == 1);
  REQUIRE(blocks("cmake").size() == 1);
  here.write("mine/tilt_table.cpp", blocks("cpp")[0]);
  here.write("mine/CMakeLists.txt", blocks("cmake")[0]);
  here.write("mine/sun.toml", blocks("toml").at(1));
  const std::string mine = (here / "mine").string(), build = mine + "/build";
  require_success({CMAKE, "-G", GENERATOR, "-S", mine, "-B", build, "-DCMAKE_PREFIX_PATH=" + (here / "prefix").string(),
                   "-DCMAKE_CXX_COMPILER=" CXX, "-DCMAKE_MAKE_PROGRAM=" MAKE, "-DCMAKE_BUILD_TYPE=Debug",
                   "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wconversion -Werror"});
  require_success({CMAKE, "--build", build});

  const Result check = run({program, "check", build + "/tilt-table.so", "--poses", "200"});
  INFO(check.out << check.err);
  CHECK(check.status == 0);
  CHECK_THAT(run({program, "describe", "tilt-table", "--plugin-path", build}).out, Contains("Tilt table, 2-SPS-U"));
  const Result report = run({program, mine + "/sun.toml", "--plugin-path", build}, {.folder = mine});
  INFO(report.out << report.err);
  CHECK(report.status == 0);

  // At the start and the end of the motion both legs are upright and nothing weighs on the table to either side: a leg carries the part of
  // itself that slides, 0.5 kg, and its cylinder rests on the base.
  const auto statics = columns(here / "mine/sun-report/data/statics.csv");
  for (const char* leg : {"l1_force", "l2_force"})
    for (const std::size_t k : {std::size_t{0}, std::size_t{40}}) CHECK(statics.at(leg).at(k) == Approx(0.5 * 9.81).epsilon(1e-9));
}

TEST_CASE("README.md names every option and every exit status of the program") {
  const std::string text = bytes_of(SOURCE "/README.md"), help = pmreport({"--help"}).out;
  const std::regex option("--[a-z][a-z-]+");
  int options = 0;
  for (auto at = std::sregex_iterator(help.begin(), help.end(), option); at != std::sregex_iterator(); ++at) {
    if (at->str() == "--help" || at->str() == "--version") continue;
    ++options;
    CHECK_THAT(text, Contains(at->str()));
  }
  CHECK(options >= 5);
  for (const char* command : {"list", "describe", "check"}) {
    CHECK_THAT(help, Contains(command));
    CHECK_THAT(text, Contains(std::string("`pmreport ") + command));
  }
  CHECK(std::filesystem::exists(SOURCE "/plugins/4sps-spr/home.png"));
  CHECK(std::filesystem::file_size(SOURCE "/plugins/4sps-spr/home.png") < 300 * 1024);
}
