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
  Result report(std::vector<std::string> more = {}, program_test::Surroundings surroundings = {}) const {
    more.insert(more.end(), {"--plugin-path", (workshop / "plugins").string()});
    return workshop.report(slider, more, std::move(surroundings));
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

TEST_CASE("a crash and an exit name the file of the plugin") {
  for (const char* plugin : {"crashing", "aborting", "exiting"}) {
    const Evil evil(plugin);
    CHECK(evil.report().err.find("plugins/" + std::string(plugin) + ".so") != std::string::npos);
  }
}

TEST_CASE("a library that crashes while it is loaded is left out, and the others work") {
  const Evil evil("crashing_load");
  fs::copy_file(fs::path(FIXTURES) / "plain.so", evil.workshop / "plugins" / "plain.so");
  const Result r = evil.report();
  CHECK(r.status == 0);
  CHECK(r.err.find("crashing_load.so: expected a library that can be loaded, seen a crash as it was: Segmentation fault") !=
        std::string::npos);
  CHECK(fs::exists(evil.workshop.report_folder() / "report.html"));
}

TEST_CASE("a library that changes how numbers are rounded as it is loaded is refused") {
  const Result r = Evil("meddling_load").report();
  CHECK(r.status == 2);
  CHECK(r.err.find("meddling_load.so: expected a library that leaves the program as it is") != std::string::npos);
}

TEST_CASE("a plugin that changes how numbers are rounded fails") {
  const Result r = Evil("rounding").report();
  CHECK(r.status == 3);
  CHECK(r.err.find("changed how numbers are rounded") != std::string::npos);
}

TEST_CASE("locale and working folder that a plugin changes are put back, and told") {
  const Evil evil("meddling");
  const Result r = evil.report();
  CHECK(r.status == 0);
  CHECK(r.err.find("has changed the locale") != std::string::npos);
  CHECK(r.err.find("has changed the working folder") != std::string::npos);
  CHECK(fs::exists(evil.workshop.report_folder() / "report.html"));
}

TEST_CASE("what a plugin leaves running, or does as the program ends, costs no finished report") {
  for (const char* plugin : {"forking", "crashing_end", "hanging_end"}) {
    CAPTURE(plugin);
    const Evil evil(plugin);
    // No pipe that a process left behind could hold open.
    const Result r = evil.report({}, {.out = evil.workshop / "out", .no_err = true});
    CHECK(r.status == 0);
    CHECK(fs::exists(evil.workshop.report_folder() / "report.html"));
    CHECK_FALSE(fs::exists(evil.workshop / "left-ended"));  // nobody waited for it
  }
}

namespace {

// Names beside the report that begin with a point: what a run had begun.
std::vector<std::string> left_behind(const Workshop& here) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(here.path()))
    if (entry.path().filename().string().starts_with('.')) out.push_back(entry.path().filename().string());
  return out;
}

}  // namespace

TEST_CASE("a run that is killed, hung up or out of time leaves nothing beside the report") {
  for (const int signal : {SIGKILL, SIGHUP, SIGQUIT, SIGTERM}) {
    CAPTURE(signal);
    const Workshop here;
    here.write("scenario.toml", program_test::with(program_test::small, {{"samples = 21", "samples = 200001"}}));
    program_test::Process process({PROGRAM, "scenario.toml"}, {.folder = here.path()});
    // The worker has begun its folder.
    for (int k = 0; k < 500 && left_behind(here).size() < 2; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    REQUIRE(left_behind(here).size() == 2);
    process.send(signal);
    const Result r = process.finish();
    CHECK(r.status == (signal == SIGKILL ? -SIGKILL : 128 + signal));
    for (int k = 0; k < 1000 && !left_behind(here).empty(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(left_behind(here).empty());
    CHECK_FALSE(fs::exists(here.report_folder()));
  }
  const Workshop here;
  const std::string longer = program_test::with(program_test::small, {{"samples = 21", "samples = 200001"}});
  CHECK(here.report(longer, {"--timeout", "1"}).status == 5);
  CHECK(left_behind(here).empty());
}

// A worker without a parent ends by itself, also where it hangs in a plugin.
TEST_CASE("an orphan that hangs ends") {
  const Evil evil("hanging");
  evil.workshop.write("scenario.toml", slider);
  program_test::Process process({PROGRAM, "scenario.toml", "--plugin-path", (evil.workshop / "plugins").string()},
                                {.folder = evil.workshop.path()});
  std::this_thread::sleep_for(std::chrono::seconds(1));
  process.send(SIGKILL);
  CHECK(process.finish().status == -SIGKILL);  // which waits until nobody holds its streams any more
}

TEST_CASE("a library that cannot be loaded is not to blame for what another does") {
  for (const char* plugin : {"exiting", "crashing"}) {
    CAPTURE(plugin);
    const Evil evil(plugin);
    fs::copy_file(fs::path(FIXTURES) / "missing_function.so", evil.workshop / "plugins" / "zz.so");  // looked at last
    const Result r = evil.report();
    CHECK(r.status == 3);
    CHECK(r.err.find(" in " + (evil.workshop / "plugins" / (std::string(plugin) + ".so")).string()) != std::string::npos);
    CHECK(r.err.find("a crash as it was") == std::string::npos);
  }
}

TEST_CASE("an earlier report survives a plugin that crashes") {
  const Evil evil("crashing");
  const Result sound = evil.workshop.report(program_test::small);
  REQUIRE(sound.status == 0);
  const auto before = program_test::contents(evil.workshop.report_folder());
  CHECK(evil.report().status == 3);
  CHECK(program_test::contents(evil.workshop.report_folder()) == before);
}
