// What a plugin can no longer do under --sandbox. Where the kernel has no such means, that is told, and nothing runs.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <sys/syscall.h>
#include <unistd.h>
#include <cerrno>

#include <sstream>

namespace fs = std::filesystem;
using namespace program_test;
using Catch::Contains;

namespace {

bool kernel_has_landlock() { return syscall(SYS_landlock_create_ruleset, nullptr, 0, 1u) >= 1; }

// A folder with a plugin that tries what it should not, a home, and a scenario in a folder between.
struct Trespass {
  explicit Trespass(const char* plugin = "trespassing") {
    fs::create_directories(workshop / "plugins");
    fs::create_directories(workshop / "work");
    fs::copy_file(fs::path(FIXTURES) / (std::string(plugin) + ".so"), workshop / "plugins" / "one.so");
    workshop.write("home/kept", "mine\n");
    workshop.write("work/scenario.toml", slider);
  }
  Result run(std::vector<std::string> more) const {
    more.insert(more.begin(), {PROGRAM, "scenario.toml", "--plugin-path", (workshop / "plugins").string()});
    return program_test::run(more, {.environment = {{"HOME", (workshop / "home").string()}}, .folder = workshop / "work"});
  }
  Workshop workshop;
};

// What was tried, and what came of it: "done", or the number of an error.
std::map<std::string, std::string> tried(const Result& r) {
  std::map<std::string, std::string> out;
  std::istringstream lines(r.err);
  for (std::string line; std::getline(lines, line);)
    if (const auto at = line.find(": "); at != std::string::npos) out[line.substr(0, at)] = line.substr(at + 2);
  return out;
}

}  // namespace

TEST_CASE("a plugin in the sandbox reaches neither home nor network nor programs, and its report is made") {
  if (sanitized) return;  // has threads of its own before anything else
  const Trespass here;
  const Result r = here.run({"--sandbox"});
  INFO(r.err);
  if (!kernel_has_landlock()) {
    CHECK(r.status == 5);
    CHECK_THAT(r.err, Contains("--sandbox needs Landlock in the kernel") && Contains("Nothing was run"));
    CHECK(tried(r).count("write home") == 0);
    return;
  }
  CHECK(r.status == 0);
  CHECK(fs::exists(here.workshop / "work/scenario-report/report.html"));
  auto was = tried(r);
  CHECK(was["write here"] == "done");  // the folder in which the report is made
  was.erase("write here");
  const std::string not_permitted = std::to_string(EPERM), denied = std::to_string(EACCES);
  for (const char* what : {"write home", "write home in a thread", "change home", "link home", "remove home"}) {
    CAPTURE(what);
    CHECK(was[what] == denied);
    was.erase(what);
  }
  CHECK((was["rename home"] == denied || was["rename home"] == std::to_string(EXDEV)));
  was.erase("rename home");
  CHECK(was.size() >= 10);
  for (const auto& [what, came] : was) {
    CAPTURE(what);
    CHECK((came == not_permitted || came == denied));
  }
  CHECK(contents(here.workshop / "home") == std::map<std::string, std::string>{{"kept", "mine\n"}});
}

TEST_CASE("without the sandbox the same plugin gets its way") {
  const Trespass here;
  const Result r = here.run({});
  INFO(r.err);
  CHECK(r.status == 0);
  auto was = tried(r);
  for (const char* what : {"write home", "write home in a thread", "empty home", "network", "program"}) CHECK(was[what] == "done");
  CHECK(fs::exists(here.workshop / "home/stolen"));
}

TEST_CASE("a plugin in the sandbox cannot have folders removed by the process that is in none") {
  if (sanitized || !kernel_has_landlock()) return;  // has threads of its own before anything else
  for (const bool bound : {true, false}) {
    CAPTURE(bound);
    const Trespass here("slandering");
    here.workshop.write("home/precious/letter", "mine\n");
    const Result r = here.run(bound ? std::vector<std::string>{"--sandbox"} : std::vector<std::string>{});
    CHECK(r.status == 3);
    CHECK_THAT(r.err, Contains("plugin crashed"));
    CHECK(fs::exists(here.workshop / "home/precious/letter") == bound);
  }
}

TEST_CASE("a report in the sandbox has the same bytes, its mode is that of the earlier one, and other folders are named to it") {
  if (sanitized || !kernel_has_landlock()) return;  // has threads of its own before anything else
  const Workshop here;
  const std::string pictures = with(small, {{"kind = \"velocity\"", "kind = \"snapshots\"\nsize = [200, 150]"}});
  REQUIRE(here.report(pictures, {"--out", "free"}).status == 0);
  fs::permissions(here / "free", fs::perms::owner_all);
  fs::copy(here / "free", here / "bound", fs::copy_options::recursive);
  fs::permissions(here / "bound", fs::perms::owner_all);
  const Result r = here.report(pictures, {"--out", "bound", "--sandbox"});
  INFO(r.err);
  CHECK(r.status == 0);
  CHECK(contents(here / "bound") == contents(here / "free"));
  CHECK(fs::status(here / "bound").permissions() == fs::perms::owner_all);
  CHECK(here.report(small, {"--out", "new/and/deep", "--sandbox", "--chunks", "elsewhere/chunks"}).status == 0);
  CHECK(here.report(small, {"--check", "--sandbox"}).status == 0);
  CHECK(run_pmreport({"describe", "gough", "--sandbox"}).status == 0);
  const Result many = run_pmreport({"scenario.toml", "scenario.toml", "--sandbox", "--out", "all"}, {.folder = here.path()});
  INFO(many.err);
  CHECK(many.status == 0);
}
