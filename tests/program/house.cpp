// The plan of the house, held by what its files include: no two headers know each other, and arrows between rooms never run back.
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Arrows = std::map<std::string, std::set<std::string>>;

// Of every file below core and reports what it includes of them: "core/text/units.cpp" -> "core/text/units.hpp".
Arrows arrows_between_files() {
  static const std::regex include("#include [<\"]((core|reports|pmreport)/[^>\"]+\\.h(?:pp)?)[>\"]");
  Arrows out;
  for (const char* root : {"core", "reports"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE) / root)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".hpp" && extension != ".h") continue;
      const std::string from = fs::relative(entry.path(), SOURCE).string();
      std::ifstream file(entry.path());
      std::stringstream text;
      text << file.rdbuf();
      const std::string source = text.str();
      out[from];
      for (std::sregex_iterator i(source.begin(), source.end(), include), end; i != end; ++i) {
        const std::string to = ((*i)[2] == "pmreport" ? "core/" : "") + (*i)[1].str();
        if (to != from) out[from].insert(to);  // a guide may show how it is itself included
      }
    }
  return out;
}

Arrows arrows_between(const Arrows& files, const std::function<std::string(const std::string&)>& room_of) {
  Arrows out;
  for (const auto& [from, all] : files)
    for (const std::string& to : all)
      if (room_of(from) != room_of(to)) out[room_of(from)].insert(room_of(to));
  return out;
}

// A way along the arrows that comes back to where it began, "a -> b -> a"; empty: there is none.
std::string circle(const Arrows& arrows) {
  std::set<std::string> done;
  std::vector<std::string> way;
  std::string found;
  const std::function<void(const std::string&)> follow = [&](const std::string& at) {
    if (!found.empty() || done.contains(at)) return;
    if (const auto before = std::find(way.begin(), way.end(), at); before != way.end()) {
      for (auto i = before; i != way.end(); ++i) found += *i + " -> ";
      found += at;
      return;
    }
    way.push_back(at);
    if (const auto next = arrows.find(at); next != arrows.end())
      for (const std::string& to : next->second) follow(to);
    way.pop_back();
    done.insert(at);
  };
  for (const auto& [from, to] : arrows) follow(from);
  return found;
}

std::string folder_of(const std::string& file) { return fs::path(file).parent_path().string(); }

// Folders that hold rooms, each folder in them one; a room may have folders of its own.
std::string room_of(const std::string& file) {
  const std::vector<std::string> of_rooms{"core", "core/mechanics", "reports", "reports/section", "reports/document"};
  std::string room = folder_of(file);
  while (std::find(of_rooms.begin(), of_rooms.end(), folder_of(room)) == of_rooms.end() &&
         std::find(of_rooms.begin(), of_rooms.end(), room) == of_rooms.end())
    room = folder_of(room);
  return room;
}

}  // namespace

TEST_CASE("a way that comes back is found") {
  CHECK(circle({{"a", {"b"}}, {"b", {"c"}}, {"c", {"d"}}}).empty());
  CHECK(circle({{"a", {"b"}}, {"b", {"c", "d"}}, {"d", {"b"}}}) == "b -> d -> b");
}

TEST_CASE("a file belongs to its room, however deep it lies") {
  CHECK(room_of("core/mechanics/reactions/by_limb/kernel.cpp") == "core/mechanics/reactions");
  CHECK(room_of("core/scenario/motion/spline.hpp") == "core/scenario");
  CHECK(room_of("reports/section/kinds.cpp") == "reports/section");
  CHECK(room_of("reports/section/drives/kind.cpp") == "reports/section/drives");
}

TEST_CASE("no two headers know each other, straight or round about") {
  const Arrows files = arrows_between_files();
  REQUIRE(files.size() > 300);
  CHECK(circle(files) == "");
}

TEST_CASE("arrows between rooms run one way") { CHECK(circle(arrows_between(arrows_between_files(), room_of)) == ""); }

TEST_CASE("core knows nothing of reports, mechanics nothing of scenarios, the SDK nothing but itself") {
  for (const auto& [from, all] : arrows_between_files())
    for (const std::string& to : all) {
      CAPTURE(from, to);
      if (from.starts_with("core/")) CHECK_FALSE(to.starts_with("reports/"));
      if (from.starts_with("core/pmreport/")) CHECK(to.starts_with("core/pmreport/"));
      if (from.starts_with("core/mechanics/") || from.starts_with("core/linear/") || from.starts_with("core/text/"))
        CHECK_FALSE((to.starts_with("core/scenario/") || to.starts_with("core/analysis/") || to.starts_with("core/host/")));
      if (from.starts_with("core/scenario/")) CHECK_FALSE(to.starts_with("core/analysis/"));
      if (from.starts_with("reports/figure/")) CHECK_FALSE((to.starts_with("reports/") && !to.starts_with("reports/figure/")));
      if (from.starts_with("reports/document/")) CHECK_FALSE((to.starts_with("reports/section/") || to.starts_with("core/mechanics/")));
    }
}

TEST_CASE("no folder holds more sources than a person keeps in mind") {
  std::map<std::string, int> sources;
  for (const auto& [file, all] : arrows_between_files())
    if (file.ends_with(".cpp")) ++sources[folder_of(file)];
  for (const auto& [folder, count] : sources) {
    CAPTURE(folder);
    CHECK(count <= 16);
  }
}

// CMake takes what stands behind a semicolon for a test of its own: both halves name nothing, and pass.
TEST_CASE("no test has a semicolon in its name") {
  static const std::regex name("TEST_CASE\\(\\s*\"([^\"]*)\"");
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE) / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    std::ifstream file(entry.path());
    std::stringstream text;
    text << file.rdbuf();
    const std::string source = text.str();
    for (std::sregex_iterator i(source.begin(), source.end(), name), end; i != end; ++i) {
      CAPTURE(entry.path().string(), (*i)[1].str());
      CHECK((*i)[1].str().find(';') == std::string::npos);
    }
  }
}
