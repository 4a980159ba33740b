// Which build of a plugin is loaded.
#include <catch2/catch.hpp>
#include <core/host/plugin_file.hpp>
#include <core/host/processor.hpp>
#include <cstdlib>
#include <tests/host/fixtures/temporary.hpp>

using pmreport::host::best_build;
using pmreport::host::load_plugin;
using pmreport::host::PluginError;
using pmreport::host::processor_levels;
namespace fs = std::filesystem;

TEST_CASE("the best build that the processor runs is taken, and the plain one where there is none") {
  const TemporaryFolder folder;
  const fs::path plain = folder.write("a.so", "");
  CHECK(best_build(plain, {"x86-64-v4", "x86-64-v3"}) == plain);
  fs::create_directories(folder.path() / "x86-64-v3");
  const fs::path v3 = folder.write("x86-64-v3/a.so", "");
  CHECK(best_build(plain, {"x86-64-v4", "x86-64-v3"}) == v3);
  fs::create_directories(folder.path() / "x86-64-v4");
  const fs::path v4 = folder.write("x86-64-v4/a.so", "");
  CHECK(best_build(plain, {"x86-64-v4", "x86-64-v3"}) == v4);
  CHECK(best_build(plain, {"x86-64-v3"}) == v3);
  CHECK(best_build(plain, {}) == plain);
  CHECK(best_build(folder.path() / "b.so", {"x86-64-v4", "x86-64-v3"}) == folder.path() / "b.so");
}

TEST_CASE("the environment can keep to builds for older processors") {
  const auto with = [](const char* value) {
    setenv("PMREPORT_PROCESSOR", value, 1);
    const auto levels = processor_levels();
    unsetenv("PMREPORT_PROCESSOR");
    return levels;
  };
  CHECK(with("x86-64").empty());
  CHECK(with("x86-64-v4") == processor_levels());
  for (const std::string& level : with("x86-64-v3")) CHECK(level == "x86-64-v3");
}

TEST_CASE("a build for the processor answers under the name of the plain file, and must have its mechanisms") {
  if (processor_levels().empty()) return;  // nothing is chosen on such a processor
  const std::string level = processor_levels().front();
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / level);
  fs::copy_file(fs::path(FIXTURES) / "plain.so", folder.path() / "p.so");
  CHECK(load_plugin(folder.path() / "p.so").level.empty());

  fs::copy_file(fs::path(FIXTURES) / "plain.so", folder.path() / level / "p.so");
  const auto plugin = load_plugin(folder.path() / "p.so");
  CHECK(plugin.level == level);
  CHECK(plugin.path == folder.path() / "p.so");

  fs::copy_file(fs::path(FIXTURES) / "plain.so", folder.path() / "other.so");
  fs::copy_file(fs::path(FIXTURES) / "faulty.so", folder.path() / level / "other.so");
  CHECK_THROWS_WITH(load_plugin(folder.path() / "other.so"),
                    Catch::Contains("expected the same mechanisms") && Catch::Contains((folder.path() / level / "other.so").string()));
}
