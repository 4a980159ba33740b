#include <algorithm>
#include <catch2/catch.hpp>
#include <tests/fuzz/promises.hpp>
#include <tests/scenario/trial.hpp>

namespace {

std::vector<std::filesystem::path> corpus(const char* name) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(SOURCE) / "tests/fuzz/corpus" / name))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() > 5);
  return files;
}

}  // namespace

TEST_CASE("no scenario of the fuzzer's corpus breaks a promise") {
  for (const auto& file : corpus("scenario")) {
    CAPTURE(file);
    CHECK(fuzz::broken_by_scenario(trial::read(file)).empty());
  }
}

TEST_CASE("no expression of the fuzzer's corpus breaks a promise") {
  for (const auto& file : corpus("expression")) {
    CAPTURE(file);
    CHECK(fuzz::broken_by_expression(trial::read(file)).empty());
  }
}
