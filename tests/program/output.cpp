// What stands in the report's place and what happens to it when things go wrong outside of the program.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

#include <sys/mount.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

using namespace program_test;
using Catch::Contains;

namespace {

// A file system of so many bytes, or another place mounted read-only, while it lives. Only root may do so, and not in every container.
class Mount {
 public:
  Mount(std::filesystem::path at, const char* options) : at_(std::move(at)) {
    std::filesystem::create_directories(at_);
    made_ = mount("tmpfs", at_.c_str(), "tmpfs", 0, options) == 0;
    if (!made_) WARN("no file system can be mounted here (" << std::strerror(errno) << "): what needs one is not tested");
  }
  Mount(const Mount&) = delete;
  Mount& operator=(const Mount&) = delete;
  ~Mount() {
    if (made_) umount2(at_.c_str(), MNT_DETACH);
  }
  explicit operator bool() const { return made_; }
  bool make_read_only() const { return mount(nullptr, at_.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr) == 0; }
  const std::filesystem::path& path() const { return at_; }

 private:
  std::filesystem::path at_;
  bool made_;
};

// Long to draw, so that there is something to interrupt.
const std::string long_work = with(small, {{"samples = 21", "samples = 200001"}});

void check_interrupted(int signal, int status, const std::string& while_it_says, const std::string& scenario) {
  CAPTURE(while_it_says);
  const Workshop here;
  REQUIRE(here.report(small).status == 0);
  const auto before = contents(here.report_folder());
  here.write("scenario.toml", scenario);
  Process process({PROGRAM, "scenario.toml"}, {.folder = here.path(), .terminal = true});
  REQUIRE(process.says(while_it_says));
  process.send(signal);
  const Result result = process.finish();
  CHECK(result.status == status);
  CHECK_THAT(result.err, Contains("interrupted; an earlier report is untouched"));
  CHECK(contents(here.report_folder()) == before);
  for (const auto& entry : std::filesystem::directory_iterator(here.path())) {
    const std::string name = entry.path().filename().string();
    CHECK((name == "scenario.toml" || name == "scenario-report" || name == "scenario-report.chunks"));  // the last is for --resume
  }
}

}  // namespace

TEST_CASE("an interrupted analysis leaves the earlier report and nothing beside it") {
  check_interrupted(SIGINT, 130, "samples of", long_work);
  check_interrupted(SIGTERM, 143, "samples of", long_work);
}

TEST_CASE("an interrupted writing leaves the earlier report and nothing beside it") {
  check_interrupted(SIGINT, 130, "writing", with(small, {{"samples = 21", "samples = 5001"}}));
  check_interrupted(SIGTERM, 143, "writing", with(small, {{"samples = 21", "samples = 5001"}}));
}

TEST_CASE("interrupted pictures leave the earlier report and nothing beside it") {
  const std::string pictures = with(small, {{"kind = \"acceleration\"", "kind = \"snapshots\"\ntimes = [\"0 s\", \"1 s\", \"2 s\"]"}});
  check_interrupted(SIGINT, 130, "picture 1 of 3", pictures);
  check_interrupted(SIGTERM, 143, "picture 1 of 3", pictures);
}

TEST_CASE("an interruption while a scenario is read ends the run before anything is written") {
  const Workshop here;
  here.write("scenario.toml", long_work);
  for (const int signal : {SIGINT, SIGTERM}) {
    Process process({PROGRAM, "scenario.toml"}, {.folder = here.path()});
    std::this_thread::sleep_for(std::chrono::milliseconds(60));  // the worker begins; reading takes far longer
    process.send(signal);
    const int status = process.finish().status;
    CHECK((status == 128 + signal || status == -signal));  // the latter where the signal came before the program's first line
    CHECK(contents(here.path()).size() == 1);
  }
}

TEST_CASE("of two runs on one folder the second says so, and does not disturb the first") {
  const Workshop here;
  here.write("scenario.toml", long_work);
  Process first({PROGRAM, "scenario.toml"}, {.folder = here.path(), .terminal = true});
  REQUIRE(first.says("samples of"));
  here.write("other.toml", small);
  const Result second = run_pmreport({"other.toml", "--out", "scenario-report"}, {.folder = here.path()});
  CHECK(second.status == 4);
  CHECK_THAT(second.err, Contains("another run is writing it now"));
  first.send(SIGTERM);
  CHECK(first.finish().status == 143);
  CHECK(here.report(small).status == 0);
}

TEST_CASE("a clock that goes back changes nothing") {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which would have to be the first library
  const Workshop here;
  const std::string pictures = with(small, {{"kind = \"acceleration\"", "kind = \"snapshots\"\nsize = [160, 120]"}});
  REQUIRE(here.report(pictures).status == 0);
  const auto before = contents(here.report_folder());
  const Result r =
      here.report(pictures, {"--timeout", "60"}, {.environment = {{"LD_PRELOAD", CLOCK_BACK}, {"CLOCK_COUNT", (here / "looks").string()}}});
  INFO(r.err);
  CHECK(r.status == 0);
  CHECK(contents(here.report_folder()) == before);
  CHECK(contents(here.path()).count("looks") == 1);  // the shim was there
#endif
}

TEST_CASE("an interrupted check ends at once") {
  Process process({PROGRAM, "check", "4sps-spr", "--poses", "1000000"});
  process.send(SIGINT);
  const int status = process.finish().status;
  CHECK((status == 130 || status == -SIGINT));  // the latter where the signal came before the program's first line
}

TEST_CASE("a report below a file cannot be written") {
  const Workshop here;
  here.write("notes", "mine");
  const Result result = here.report(small, {"--out", "notes/report"});
  CHECK(result.status == 4);
  CHECK_THAT(result.err, Contains("error: cannot ") && Contains("notes") && Contains("Not a directory"));
  CHECK(bytes_of(here / "notes") == "mine");
  CHECK(contents(here.path()).size() == 2);
}

TEST_CASE("a report in place of a file cannot be written") {
  const Workshop here;
  here.write("notes", "mine");
  const Result result = here.report(small, {"--out", "notes"});
  CHECK(result.status == 4);
  CHECK_THAT(result.err, Contains("it is a file. Choose the name of a folder."));
  CHECK(bytes_of(here / "notes") == "mine");
}

TEST_CASE("a user's own folder is never replaced") {
  const Workshop here;
  here.write("thesis/chapter.tex", "years of work");
  const Result result = here.report(small, {"--out", "thesis"});
  CHECK(result.status == 4);
  CHECK_THAT(result.err, Contains("it holds chapter.tex, and is no earlier report. Choose another folder, or empty this one."));
  CHECK(contents(here.path()).size() == 2);
  CHECK(bytes_of(here / "thesis/chapter.tex") == "years of work");
}

TEST_CASE("a note in an earlier report is not lost") {
  const Workshop here;
  REQUIRE(here.report(small).status == 0);
  here.write("scenario-report/note.txt", "look again");
  const auto before = contents(here.report_folder());
  const Result result = here.report(small);
  CHECK(result.status == 4);
  CHECK_THAT(result.err, Contains("it holds note.txt beside an earlier report"));
  CHECK(contents(here.report_folder()) == before);
}

TEST_CASE("a new report takes the place of the earlier one") {
  const Workshop here;
  REQUIRE(here.report(small).status == 0);
  const auto before = contents(here.report_folder());
  REQUIRE(here.report(with(small, {{"\"Small\"", "\"Another\""}, {"[[section]]\nkind = \"acceleration\"\n", ""}})).status == 0);
  const auto after = contents(here.report_folder());
  CHECK(before.contains("data/acceleration.csv"));
  CHECK_FALSE(after.contains("data/acceleration.csv"));
  CHECK_THAT(after.at("report.html"), Contains("Another"));
}

TEST_CASE("a full disk leaves the earlier report and nothing beside it") {
  const Workshop here;
  const Mount disk(here / "disk", "size=256k");
  if (!disk) return;
  const std::string out = (disk.path() / "report").string();
  const std::string one = with(small, {{"kind = \"displacement\"", "kind = \"mechanism\""},
                                       {"kind = \"velocity\"", "kind = \"snapshots\"\nsize = [640, 480]"},
                                       {"[[section]]\nkind = \"acceleration\"\n", ""},
                                       {"[[section]]\nkind = \"statics\"\n", ""},
                                       {std::string(small.substr(small.find("[[check]]"))), ""}});
  here.write("disk/report/results.json", "");
  std::filesystem::remove(here / "disk/report/results.json");
  const Result result = here.report(one, {"--out", out});
  CHECK(result.status == 4);
  CHECK_THAT(result.err, Contains("No space left on device. Free some space, or choose a folder on another disk."));
  CHECK(contents(disk.path()).empty());
  CHECK(std::filesystem::is_empty(disk.path() / "report"));
}

TEST_CASE("a read-only disk is told") {
  const Workshop here;
  const Mount disk(here / "disk", "size=256k");
  if (!disk || !disk.make_read_only()) return;
  const Result result = here.report(small, {"--out", "disk/report"});
  CHECK(result.status == 4);
  CHECK_THAT(result.err, Contains("Read-only file system. A report is made beside its place, then renamed"));
}

TEST_CASE("a standard output that takes nothing is an output error, a standard error that takes nothing is none") {
  const Workshop here;
  const Result full = here.report(small, {}, {.out = "/dev/full"});
  CHECK(full.status == 4);
  CHECK_THAT(full.err, Contains("standard output"));
  const Result closed = here.report(small, {}, {.no_out = true});
  CHECK(closed.status == 4);
  CHECK_THAT(closed.err, Contains("standard output"));
  CHECK(here.report(small, {"--quiet"}, {.no_out = true}).status == 0);
  CHECK(here.report(small, {}, {.no_err = true}).status == 0);
  CHECK(here.report("", {}, {.no_err = true}).status == 2);
  here.write("scenario.toml", small);
  CHECK(run({"sh", "-c", "exec \"$0\" scenario.toml --quiet <&- >&- 2>&-", PROGRAM}, {.folder = here.path()}).status == 0);
  CHECK(run_pmreport({"describe", "4sps-spr"}, {.out = "/dev/full"}).status == 4);
  CHECK(run_pmreport({"describe", "4sps-spr"}, {.no_out = true}).status == 4);
}
