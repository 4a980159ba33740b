// The folder of the report: all of it or nothing, the old one or the new one.
#include <fcntl.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <regex>
#include <reports/document/folder/staged_folder.hpp>
#include <reports/document/write.hpp>
#include <set>

#include <tests/document/sample.hpp>

using namespace pmreport::document;
using sample::contains;
using sample::content_of;
namespace fs = std::filesystem;

namespace {

std::string refusal(const std::string& folder) {
  try {
    write(sample::report(), folder);
  } catch (const OutputError& error) {
    return error.what();
  }
  return "";
}

int names_in(const fs::path& folder) { return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator())); }

Report another() {
  Report r = sample::report();
  r.title = "another";
  return r;
}

int asked, asked_at_most;
bool after_a_while() { return ++asked > asked_at_most; }

// A small disk of its own.
class Disk {
 public:
  Disk(const fs::path& at, const std::string& options) : at_(at) {
    fs::create_directory(at);
    mounted_ = mount("tmpfs", at.c_str(), "tmpfs", 0, options.c_str()) == 0;
  }
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;
  ~Disk() {
    if (mounted_) umount2(at_.c_str(), MNT_DETACH);
  }
  bool mounted() const { return mounted_; }

 private:
  fs::path at_;
  bool mounted_;
};

}  // namespace

TEST_CASE("a report is written with every file that it lists, and nothing beside it") {
  const sample::Folder place;
  write(sample::report(), place / "report");
  const auto content = content_of(place / "report");
  std::set<std::string> names;
  for (const auto& [name, bytes] : content) names.insert(name);
  CHECK(names == std::set<std::string>{"report.html", "report.pdf", "results.json", "junit.xml", "summary.md", "figures/displacement.svg",
                                       "figures/displacement.pdf", "figures/statics.svg", "figures/statics.pdf", "snapshots/pose-0.png",
                                       "snapshots/pose-5.png", "data/displacement.csv", "data/statics.csv"});
  const auto listed = nlohmann::json::parse(content.at("results.json"))["files"].get<std::set<std::string>>();
  CHECK(listed == names);
  CHECK(content.at("report.html") == to_html(sample::report()));
  CHECK(content.at("report.pdf").starts_with("%PDF-"));
  CHECK(content.at("figures/statics.pdf").starts_with("%PDF-"));
  CHECK(content.at("data/displacement.csv") == "t [s],x [m]\n0,0.1\n0.1,\n0.2,0.3333333333333333\n");
  CHECK(names_in(place.path()) == 1);
}

TEST_CASE("what other programs read is written byte by byte, and listed with its size and its hash") {
  const sample::Folder place;
  Report r = sample::report();
  r.files = {{"data/mesh.stl", "boundary of the workspace & its <rim>", std::string("\0\xff\n\r\0", 5)}, {"data/none.npy", "nothing", ""}};
  write(r, place / "report");
  auto content = content_of(place / "report");
  CHECK(content.at("data/mesh.stl") == r.files[0].bytes);
  CHECK(content.at("data/none.npy").empty());
  const auto results = nlohmann::json::parse(content.at("results.json"));
  std::set<std::string> names;
  for (const auto& [name, bytes] : content) names.insert(name);
  CHECK(results["files"].get<std::set<std::string>>() == names);
  REQUIRE(results["exports"].size() == 2);
  CHECK(results["exports"][0]["name"] == "data/mesh.stl");
  CHECK(results["exports"][0]["title"] == r.files[0].title);
  CHECK(results["exports"][0]["bytes"] == 5);
  // By sha256sum of coreutils.
  CHECK(results["exports"][0]["sha256"] == "5d4d5bf580a5f1a190aaa9c298005d4477bb018ba4adb1b93b13095d94a3217d");
  CHECK(results["exports"][1]["sha256"] == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  write(sample::report(), place / "report");  // the next report knows them for its own
  CHECK(!content_of(place / "report").contains("data/mesh.stl"));
}

TEST_CASE("two runs write the same bytes") {
  const sample::Folder place;
  write(sample::report(), place / "one");
  write(sample::report(), place / "two");
  CHECK(content_of(place / "one") == content_of(place / "two"));
}

TEST_CASE("no file of a report holds the word nan") {
  const sample::Folder place;
  Report r = sample::report();
  std::get<Proof>(r.sections[0].blocks.back()).lines[0].value = std::nan("");
  write(r, place / "report");
  for (const auto& [name, bytes] : content_of(place / "report")) {
    if (!name.ends_with(".csv") && !name.ends_with(".json") && !name.ends_with(".svg") && !name.ends_with(".xml")) continue;
    CAPTURE(name);
    CHECK_FALSE(std::regex_search(bytes, std::regex("\\b-?nan\\b", std::regex::icase)));
  }
}

TEST_CASE("a new report takes the place of an earlier one, with nothing of it left") {
  const sample::Folder place;
  write(sample::report(), place / "report");
  Report r = another();
  r.sections.pop_back();
  write(r, place / "report");
  const auto content = content_of(place / "report");
  CHECK(contains(content.at("report.html"), "<title>another</title>"));
  CHECK_FALSE(content.contains("figures/statics.svg"));
  CHECK(names_in(place.path()) == 1);
}

TEST_CASE("an empty folder is taken, and a link to a folder stays a link") {
  const sample::Folder place;
  fs::create_directory(place / "report");
  fs::create_directory_symlink("report", place / "link");
  write(sample::report(), (place / "link").string() + "/");
  CHECK(fs::is_symlink(place / "link"));
  CHECK(fs::exists(place / "report/results.json"));
}

TEST_CASE("folders above that are missing are made") {
  const sample::Folder place;
  write(sample::report(), place / "a/b/Prüfung 机构");
  CHECK(fs::exists(place / "a/b/Prüfung 机构/report.html"));
  CHECK(names_in(place / "a/b") == 1);
}

TEST_CASE("a folder of the user's own is refused and keeps its files") {
  const sample::Folder place;
  SECTION("no report at all") {
    sample::put(place / "report/thesis.tex", "years of work");
    CHECK(contains(refusal(place / "report"), "it holds thesis.tex, and is no earlier report"));
  }
  SECTION("somebody else's results.json") {
    sample::put(place / "report/results.json", R"({"files": ["results.json"]})");
    CHECK(contains(refusal(place / "report"), "is no earlier report"));
  }
  SECTION("a note beside an earlier report") {
    write(another(), place / "report");
    sample::put(place / "report/data/note.txt", "mine");
    CHECK(contains(refusal(place / "report"), "it holds data/note.txt beside an earlier report"));
  }
  SECTION("a file") {
    sample::put(place / "report", "mine");
    CHECK(contains(refusal(place / "report"), "it is a file"));
    CHECK(sample::bytes_of(place / "report") == "mine");
  }
  const auto before = content_of(place / "report");
  refusal(place / "report");
  CHECK(content_of(place / "report") == before);
  CHECK(names_in(place.path()) == 1);
}

TEST_CASE("a place where no report can be is refused, with the reason and what to do") {
  const sample::Folder place;
  sample::put(place / "file", "");
  fs::create_symlink("nowhere", place / "dangling");
  CHECK(contains(refusal((place / "file").string() + "/report"), "Not a directory"));
  CHECK(contains(refusal("/dev/null/x"), "choose another folder"));
  CHECK(contains(refusal(place / "dangling"), "link to nothing"));
  CHECK(contains(refusal("/"), "root of the file system"));
  CHECK(contains(refusal("."), "current folder"));
  CHECK(contains(refusal(""), "name of a folder"));
  CHECK(contains(refusal(place / std::string(300, 'x')), "File name too long"));
  CHECK(names_in(place.path()) == 2);
}

TEST_CASE("a report interrupted at any moment leaves the old one as it was") {
  const sample::Folder place;
  write(another(), place / "report");
  const auto before = content_of(place / "report");
  for (asked_at_most = 0;; ++asked_at_most) {
    CAPTURE(asked_at_most);
    REQUIRE(asked_at_most < 1000);
    asked = 0;
    try {
      write(sample::report(), place / "report", after_a_while);
      break;
    } catch (const Interrupted&) {
      REQUIRE(content_of(place / "report") == before);
      REQUIRE(names_in(place.path()) == 1);
    }
  }
  CHECK(asked_at_most > 12);  // it was asked before each of its twelve files
  CHECK(content_of(place / "report") != before);
}

TEST_CASE("an interrupted first report leaves nothing, not even the folders above") {
  const sample::Folder place;
  asked = 0;
  asked_at_most = 5;
  CHECK_THROWS_AS(write(sample::report(), place / "a/b/report", after_a_while), Interrupted);
  CHECK(names_in(place.path()) == 0);
}

TEST_CASE("a full disk leaves the old report as it was, however late it fills") {
  const sample::Folder place;
  Report small = another();
  small.sections.clear();
  int failures = 0;
  for (int kilobytes = 64;; kilobytes *= 2) {
    CAPTURE(kilobytes);
    REQUIRE(kilobytes < 1 << 20);
    const Disk disk(place / std::to_string(kilobytes), "size=" + std::to_string(kilobytes) + "k");
    if (!disk.mounted()) {
      WARN("no disk of our own may be mounted here: a full disk was not tried");
      return;
    }
    const fs::path folder = place / std::to_string(kilobytes) / "report";
    try {
      write(small, folder);
    } catch (const OutputError&) {
      continue;
    }
    const auto before = content_of(folder);
    const std::string told = refusal(folder);
    if (told.empty()) break;
    ++failures;
    CHECK(contains(told, "No space left on device"));
    CHECK(contains(told, "Free some space"));
    CHECK(contains(told, folder.parent_path().string()));
    CHECK(content_of(folder) == before);
    CHECK(names_in(folder.parent_path()) == 1);
  }
  CHECK(failures > 0);
}

TEST_CASE("a folder that may only be read leaves the old report as it was") {
  const sample::Folder place;
  const Disk disk(place / "disk", "size=8m");
  if (!disk.mounted()) {
    WARN("no disk of our own may be mounted here: a read-only one was not tried");
    return;
  }
  write(another(), place / "disk/report");
  const auto before = content_of(place / "disk/report");
  REQUIRE(mount(nullptr, (place / "disk").c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr) == 0);
  CHECK(contains(refusal(place / "disk/report"), "Read-only file system"));
  CHECK(content_of(place / "disk/report") == before);
}

TEST_CASE("a mount point cannot be replaced, and the message says so") {
  const sample::Folder place;
  const Disk disk(place / "disk", "size=8m");
  if (!disk.mounted()) {
    WARN("no disk of our own may be mounted here: a mount point was not tried");
    return;
  }
  CHECK(contains(refusal(place / "disk"), "mount point"));
  CHECK(names_in(place.path()) == 1);
}

TEST_CASE("of two runs into one folder the second is refused") {
  const sample::Folder place;
  {
    StagedFolder first(place / "report");
    CHECK(contains(refusal(place / "report"), "another run is writing it now"));
    CHECK(refusal(place / "other").empty());
    first.add("results.json", to_json(another()));
    first.commit();
  }
  CHECK(refusal(place / "report").empty());
  CHECK(names_in(place.path()) == 2);
}

TEST_CASE("a folder that gets a user's file while the report is drawn is not replaced") {
  const sample::Folder place;
  fs::create_directory(place / "report");
  {
    StagedFolder staged(place / "report");
    staged.add("results.json", to_json(another()));
    sample::put(place / "report/note.txt", "mine");
    CHECK_THROWS_AS(staged.commit(), OutputError);
  }
  CHECK(content_of(place.path()) == std::map<std::string, std::string>{{"report/note.txt", "mine"}});
}

TEST_CASE("what a killed run has left is cleared away, and nothing else") {
  const sample::Folder place;
  sample::put(place / ".report.4711.partial/figures/a.svg", "half");
  sample::put(place / ".report.lock", "");
  sample::put(place / ".other.4711.partial/a", "of another report");
  sample::put(place / ".report.mine.partial/a", "of a user");
  write(sample::report(), place / "report");
  CHECK_FALSE(fs::exists(place / ".report.4711.partial"));
  CHECK_FALSE(fs::exists(place / ".report.lock"));
  CHECK(fs::exists(place / ".other.4711.partial/a"));
  CHECK(fs::exists(place / ".report.mine.partial/a"));
}

TEST_CASE("where folders cannot be exchanged in one step, two renames do") {
  const sample::Folder place;
  sample::put(place / "fresh/a", "new");
  SECTION("over an old folder") { sample::put(place / "old/a", "old"); }
  SECTION("where nothing was") {}
  CHECK(put_in_place_by_two_renames(place / "fresh", place / "old"));
  CHECK(content_of(place.path()) == std::map<std::string, std::string>{{"old/a", "new"}});
}

TEST_CASE("when the second of two renames fails the first is undone") {
  const sample::Folder place;
  sample::put(place / "old/a", "old");
  CHECK_FALSE(put_in_place_by_two_renames(place / "missing", place / "old"));
  CHECK(errno == ENOENT);
  CHECK(content_of(place.path()) == std::map<std::string, std::string>{{"old/a", "old"}});
}

TEST_CASE("a report that was set aside by a killed run returns to its place") {
  const sample::Folder place;
  write(another(), place / "report");
  const auto before = content_of(place / "report");
  fs::rename(place / "report", place / ".report.4711.partial.old");
  sample::put(place / ".report.4711.partial/report.html", "the new one, which was to follow");
  { const StagedFolder staged(place / "report"); }
  CHECK(content_of(place / "report") == before);
  CHECK(names_in(place.path()) == 1);
}

TEST_CASE("a report that was replaced and set aside does not come back when the new one is deleted") {
  const sample::Folder place;
  write(another(), place / "report");
  fs::rename(place / "report", place / ".report.4711.partial.old");
  { const StagedFolder staged(place / "report"); }
  CHECK(names_in(place.path()) == 0);
}

TEST_CASE("who may look into a report stays as its owner has set it") {
  const sample::Folder place;
  write(sample::report(), place / "report");
  fs::permissions(place / "report", fs::perms::owner_all);
  write(another(), place / "report");
  CHECK(fs::status(place / "report").permissions() == fs::perms::owner_all);
}

TEST_CASE("a pipe in the place of an earlier report's results keeps nobody waiting") {
  const sample::Folder place;
  fs::create_directory(place / "report");
  REQUIRE(mkfifo((place / "report/results.json").c_str(), 0600) == 0);
  CHECK(contains(refusal(place / "report"), "is no earlier report"));
}
