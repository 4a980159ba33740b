#include <catch2/catch.hpp>
#include <core/host/catalog.hpp>
#include <cstdlib>
#include <optional>
#include <tests/host/fixtures/temporary.hpp>

using pmreport::host::Catalog;
using pmreport::host::PluginError;
using pmreport::host::search_folders;
namespace fs = std::filesystem;

namespace {

const fs::path plain = fs::path(FIXTURES) / "plain.so";
const fs::path faulty = fs::path(FIXTURES) / "faulty.so";

// Sets a variable of the environment, or removes it, for as long as it lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    value != nullptr ? setenv(name, value, 1) : unsetenv(name);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> old_;
};

std::vector<std::string> names(const Catalog& catalog) {
  std::vector<std::string> out;
  for (const auto& entry : catalog.entries()) out.push_back(entry.name);
  return out;
}

}  // namespace

TEST_CASE("folders are searched from the command line inwards to the user's own") {
  const Variable path("PMREPORT_PLUGIN_PATH", ":/e1::/e2:"), data("XDG_DATA_HOME", "/data"), home("HOME", "/home/someone");
  const auto folders = search_folders({"/c1", "/c2"});
  REQUIRE(folders.size() > 5);
  CHECK(std::vector<fs::path>(folders.begin(), folders.begin() + 4) == std::vector<fs::path>{"/c1", "/c2", "/e1", "/e2"});
  CHECK(folders[4] == fs::canonical("/proc/self/exe").parent_path().parent_path() / "lib/pmreport/plugins");
  CHECK(folders.back() == "/data/pmreport/plugins");
  for (const auto& folder : folders) CHECK(folder.is_absolute());
}

TEST_CASE("the user's folder is in the home folder unless XDG_DATA_HOME says otherwise, and nowhere without a home") {
  const Variable path("PMREPORT_PLUGIN_PATH", nullptr), home("HOME", "/home/someone");
  const fs::path own = "/home/someone/.local/share/pmreport/plugins";
  for (const char* ignored : {static_cast<const char*>(nullptr), "", "relative"}) {
    const Variable data("XDG_DATA_HOME", ignored);
    CHECK(search_folders({}).back() == own);
  }
  const Variable data("XDG_DATA_HOME", nullptr);
  const std::size_t count = search_folders({}).size();
  for (const char* none : {static_cast<const char*>(nullptr), "", "somewhere"}) {
    const Variable homeless("HOME", none);
    const auto folders = search_folders({});
    CHECK(folders.size() == count - 1);
    for (const auto& folder : folders) CHECK(folder.is_absolute());
  }
}

TEST_CASE("the program finds the plugins of its own build tree") {
  const Variable path("PMREPORT_PLUGIN_PATH", nullptr), data("XDG_DATA_HOME", "/nonexistent");
  const Catalog catalog(search_folders({}));
  REQUIRE(catalog.find("4sps-spr") != nullptr);
  CHECK(fs::equivalent(catalog.find("4sps-spr")->file.parent_path(), PLUGINS));
  CHECK(catalog.refused().empty());
}

TEST_CASE("mechanisms are listed by name, with the file they came from and how it was built") {
  const TemporaryFolder folder;
  fs::copy_file(plain, folder.path() / "a.so");
  fs::copy_file(faulty, folder.path() / "b.so");
  const Catalog catalog({folder.path()});
  CHECK(names(catalog) == std::vector<std::string>{"not-finite", "plain-slider", "refusing", "throwing"});
  REQUIRE(catalog.find("throwing") != nullptr);
  CHECK(catalog.find("throwing")->file == folder.path() / "b.so");
  CHECK(catalog.find("throwing")->build.starts_with("C++ "));
  CHECK(catalog.find("throwing")->mechanism->name == std::string("throwing"));
  CHECK(catalog.find("plain") == nullptr);
  CHECK(catalog.find("zzz") == nullptr);
}

TEST_CASE("a file that cannot be loaded does not stop the others") {
  const TemporaryFolder folder;
  const auto text = folder.write("a.so", "not a library");
  fs::copy_file(plain, folder.path() / "b.so");
  folder.write("readme.txt", "not looked at");
  const Catalog catalog({folder.path()});
  CHECK(names(catalog) == std::vector<std::string>{"plain-slider"});
  REQUIRE(catalog.refused().size() == 1);
  CHECK(catalog.refused()[0].starts_with(text.string() + ": expected a shared library"));
}

TEST_CASE("missing folders are skipped") {
  const TemporaryFolder folder;
  const Catalog catalog({folder.path() / "missing", folder.write("file", "x")});
  CHECK(catalog.entries().empty());
  CHECK(catalog.refused().empty());
  CHECK(catalog.folders().size() == 2);
}

TEST_CASE("one file found twice is one plugin") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "one");
  fs::create_directories(folder.path() / "two");
  fs::copy_file(plain, folder.path() / "one/p.so");
  fs::create_symlink(folder.path() / "one/p.so", folder.path() / "one/q.so");
  fs::create_hard_link(folder.path() / "one/p.so", folder.path() / "two/r.so");
  fs::create_directory_symlink(folder.path() / "one", folder.path() / "three");
  const Catalog catalog({folder.path() / "one", folder.path() / "two", folder.path() / "three", folder.path() / "one"});
  CHECK(names(catalog) == std::vector<std::string>{"plain-slider"});
  CHECK(catalog.entries()[0].file == folder.path() / "one/p.so");
}

TEST_CASE("two files with a mechanism of the same name are an error that names both") {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "one");
  fs::create_directories(folder.path() / "two");
  fs::copy_file(plain, folder.path() / "one/p.so");
  fs::copy_file(plain, folder.path() / "two/p.so");
  const std::string first = (folder.path() / "one/p.so").string(), second = (folder.path() / "two/p.so").string();
  CHECK_THROWS_WITH(Catalog({folder.path() / "one", folder.path() / "two"}),
                    Catch::Contains("'plain-slider'") && Catch::Contains(first) && Catch::Contains(second));
}

TEST_CASE("every dangling link is told") {
  const TemporaryFolder folder;
  fs::create_symlink("nowhere", folder.path() / "a.so");
  fs::create_symlink("nowhere", folder.path() / "b.so");
  CHECK(Catalog({folder.path()}).refused().size() == 2);
}
