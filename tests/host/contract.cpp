#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "fixtures/contract_sizes.h"

extern "C" const std::size_t contract_sizes_in_c[];
extern "C" const std::size_t contract_size_count;
extern const std::size_t contract_sizes_in_cpp[];

namespace {

std::string exported_symbols(const std::filesystem::path& file) {
  const std::string command = "nm -D --defined-only --format=just-symbols '" + file.string() + "'";
  const std::unique_ptr<std::FILE, decltype(&pclose)> pipe(popen(command.c_str(), "r"), &pclose);
  REQUIRE(pipe != nullptr);
  std::string symbols;
  char buffer[4096];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe.get())) symbols.append(buffer, n);
  return symbols;
}

}  // namespace

TEST_CASE("the contract has one layout in C and in C++") {
  const std::size_t here[] = {CONTRACT_SIZES};
  REQUIRE(contract_size_count == std::size(here));
  const std::vector<std::size_t> c(contract_sizes_in_c, contract_sizes_in_c + contract_size_count);
  CHECK(c == std::vector<std::size_t>(std::begin(here), std::end(here)));
  CHECK(c == std::vector<std::size_t>(contract_sizes_in_cpp, contract_sizes_in_cpp + contract_size_count));
}

TEST_CASE("a plugin exports one symbol") {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(PLUGINS))
    if (entry.is_regular_file()) files.push_back(entry.path());
  REQUIRE_FALSE(files.empty());
  for (const auto& entry : std::filesystem::directory_iterator(FIXTURES))
    if (const auto stem = entry.path().stem(); stem != "no_symbol") files.push_back(entry.path());
  for (const auto& file : files) {
    CAPTURE(file);
    CHECK(exported_symbols(file) == "pm_plugin\n");
  }
}
