// Plugins that do not come back: the program does, with an answer, and an earlier report stays.
#include <catch2/catch.hpp>

#include <tests/program/workshop.hpp>

#include <chrono>
#include <csignal>
#include <thread>

namespace fs = std::filesystem;
using program_test::Result;
using program_test::slider;
using program_test::Workshop;

namespace {

struct Evil {
  explicit Evil(const std::string& plugin) {
    fs::create_directory(workshop / "plugins");
    fs::copy_file(fs::path(FIXTURES) / (plugin + ".so"), workshop / "plugins" / (plugin + ".so"));
  }
  Result report(std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--plugin-path", (workshop / "plugins").string()});
    return workshop.report(slider, more);
  }
  Workshop workshop;
};

}  // namespace

TEST_CASE("a plugin that crashes is told with its signal, and the exit status is 3") {
  const Result segv = Evil("crashing").report();
  CHECK(segv.status == 3);
  CHECK(segv.err.find("plugin crashed") != std::string::npos);
  CHECK(segv.err.find("signal 11") != std::string::npos);
  const Result abort = Evil("aborting").report();
  CHECK(abort.status == 3);
  CHECK(abort.err.find("signal 6") != std::string::npos);
}

TEST_CASE("a plugin that ends the program with success does not make a success of it") {
  const Evil evil("exiting");
  const Result r = evil.report();
  CHECK(r.status == 3);
  CHECK(r.err.find("ended the program") != std::string::npos);
  CHECK_FALSE(fs::exists(evil.workshop.report_folder()));
}

TEST_CASE("a plugin that hangs is stopped after the time that the user gives") {
  const Result r = Evil("hanging").report({"--timeout", "1"});
  CHECK(r.status == 5);
  CHECK(r.err.find("not done after 1 s") != std::string::npos);
}

TEST_CASE("a plugin that hangs can be interrupted") {
  const Evil evil("hanging");
  evil.workshop.write("scenario.toml", slider);
  program_test::Process process({PROGRAM, "scenario.toml", "--plugin-path", (evil.workshop / "plugins").string()},
                                {.folder = evil.workshop.path()});
  std::this_thread::sleep_for(std::chrono::seconds(1));  // well within what never ends; nothing is said before
  process.send(SIGTERM);
  const Result r = process.finish();
  CHECK(r.status == 143);
  CHECK(r.err.find("interrupted in the midst of a step that did not end") != std::string::npos);
}

TEST_CASE("an earlier report survives a plugin that crashes") {
  const Evil evil("crashing");
  const Result sound = evil.workshop.report(program_test::small);
  REQUIRE(sound.status == 0);
  const auto before = program_test::contents(evil.workshop.report_folder());
  CHECK(evil.report().status == 3);
  CHECK(program_test::contents(evil.workshop.report_folder()) == before);
}
