// The inputs of a fuzzer that are kept, and what is made of them, for the tests of the room that it tries.
#pragma once

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace fuzz {

inline std::vector<std::filesystem::path> files_of(const std::filesystem::path& corpus) {
  std::vector<std::filesystem::path> files{std::filesystem::directory_iterator(corpus), {}};
  std::sort(files.begin(), files.end());
  return files;
}

inline std::string bytes_in(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// "NAME of the input: promise that it breaks", a line each; nothing where all is well. `corpus`: of tests/fuzz/corpus.
template <class Broken>
std::string broken_in(const std::filesystem::path& corpus, Broken&& broken) {
  const std::vector<std::filesystem::path> files = files_of(corpus);
  if (files.size() < 5) return "too few inputs to say anything";
  std::string out;
  for (const auto& file : files) {
    const std::string wrong = broken(bytes_in(file));
    if (!wrong.empty()) out += file.filename().string() + ": " + wrong + "\n";
  }
  return out;
}

// Inputs that nobody wrote: kept ones with bytes changed, pieces taken out, written twice, or put in from another. The n-th is the same in
// every run. Blind to what they reach, unlike those of libFuzzer, and made wherever the tests are.
class Mutants {
 public:
  static constexpr std::size_t longest = 4096;

  explicit Mutants(const std::filesystem::path& corpus) {
    for (const auto& file : files_of(corpus)) kept_.push_back(bytes_in(file));
  }

  std::string next() {
    std::string out = kept_[below(kept_.size())];
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(out);
    out.resize(std::min(out.size(), longest));
    return out;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random_() % n); }

  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1), size = std::min(below(std::size_t{1} << below(8)) + 1, text.size() - at);
    switch (below(6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      case 2:
        text.erase(at, size);
        break;
      case 3:
        text.insert(at, text.substr(at, size));
        break;
      case 4: {
        const std::string& other = kept_[below(kept_.size())];
        const std::size_t from = below(other.size() + 1);
        text.insert(at, other, from, size + 1);
        break;
      }
      default: {
        static constexpr const char* telling[] = {"-1",           "0",  "1e308", "1e-320", "nan", "inf", "18446744073709551616",
                                                  "\xEF\xBB\xBF", "\"", "]]",    "{",      "\n"};
        text.insert(at, telling[below(std::size(telling))]);
      }
    }
  }

  std::vector<std::string> kept_;
  std::mt19937_64 random_{20261201};
};

// No input that is kept for the fuzzer of this name breaks a promise, and none of its first mutants, PMREPORT_MUTANTS or 300 of them: as
// many on every machine, so that what fails on one fails on all.
template <class Broken>
void check_promises(const std::string& fuzzer, Broken&& broken) {
  const std::filesystem::path corpus = std::filesystem::path(SOURCE "/tests/fuzz/corpus") / fuzzer;
  CHECK(broken_in(corpus, broken) == "");
  const char* asked = std::getenv("PMREPORT_MUTANTS");
  const long count = asked != nullptr ? std::stol(asked) : 300;
  Mutants mutants(corpus);
  for (long n = 0; n < count; ++n) {
    INFO(fuzzer << ", mutant " << n);  // told of one that ends the process, too
    const std::string input = mutants.next();
    CAPTURE(input);
    const std::string wrong = broken(input);
    if (!wrong.empty()) FAIL(wrong);
  }
}

}  // namespace fuzz
