// The inputs of a fuzzer that are kept, for the tests of the room that it tries.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace fuzz {

// "NAME of the input: promise that it breaks", a line each; nothing where all is well. `corpus`: of tests/fuzz/corpus.
template <class Broken>
std::string broken_in(const std::filesystem::path& corpus, Broken&& broken) {
  std::vector<std::filesystem::path> files{std::filesystem::directory_iterator(corpus), {}};
  std::sort(files.begin(), files.end());
  if (files.size() < 5) return "too few inputs to say anything";
  std::string out;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::string wrong = broken(std::string(std::istreambuf_iterator<char>(in), {}));
    if (!wrong.empty()) out += file.filename().string() + ": " + wrong + "\n";
  }
  return out;
}

}  // namespace fuzz
