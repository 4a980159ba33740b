// Trying scenarios: a sound one, changed in one place, and what is said about it.
#pragma once

#include <catch2/catch.hpp>
#include <core/scenario/loaded.hpp>
#include <reports/section/kinds.hpp>
#include <tests/given/stage.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace trial {

inline constexpr std::string_view sound = R"toml(title = "Stage"
[mechanism]
use = "stage"
parameters = { arm = "200 mm" }
[motion]
duration = "2 s"
samples = 21
x = "20 mm * sin(2*pi*t/10 s)"
phi = "5 deg"
[[section]]
kind = "displacement"
)toml";

// The sound scenario with `from` replaced by `to`; with more text at its end.
inline std::string with(std::string_view from, std::string_view to) {
  std::string text(sound);
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}
inline std::string with_more(std::string_view more) { return std::string(sound) + std::string(more); }

inline std::vector<pmreport::scenario::Diagnostic> mistakes(const std::string& text, const std::filesystem::path& file = "a.toml") {
  try {
    (void)pmreport::scenario::load_text(text, file, stage::source(), pmreport::section::kinds());
  } catch (const pmreport::scenario::ScenarioError& e) {
    return e.diagnostics;
  }
  return {};
}

// The one mistake of a text, as the user sees it.
inline std::string told(const std::string& text, const std::filesystem::path& file = "a.toml") {
  const auto all = mistakes(text, file);
  std::string out;
  for (const auto& d : all) out += (out.empty() ? "" : "\n") + to_string(d);
  return out;
}

inline std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A folder of its own, gone when the test is over.
class Folder {
 public:
  Folder() {
    for (int i = 0;; ++i) {
      path_ = std::filesystem::temp_directory_path() / ("pmreport scenario " + std::to_string(i) + " Prüfung");
      if (std::filesystem::create_directory(path_)) return;
    }
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path write(const std::filesystem::path& name, std::string_view text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace trial
