// Settings files of controllers, as lines and values with their places. They are somebody's: every file is bounded, every number finite,
// nothing in them is followed or run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::program::settings {

struct Place {
  std::string file;
  int line = 0;           // 1-based; 0: the file as a whole
  std::string text = {};  // of that line, for whoever is told of it
};

struct Line {
  Place place;
  std::string text;
};
using Lines = std::vector<Line>;

// [SECTION] KEY = VALUE.
struct Setting {
  std::string section, key, value;
  Place place;
};
using Settings = std::vector<Setting>;

inline constexpr std::size_t most_bytes = 1 << 20, most_lines = 20'000;

// The lines of a text file without their ends. Throws ScenarioError where there is no such file, or none that a person would write.
Lines lines_of(const std::filesystem::path& file);

// Throws ScenarioError: "kinematics.hal:12: error: MESSAGE", with the line and what to do.
[[noreturn]] void refuse(const Place& place, const std::string& message, const std::string& hint = {});

// A finite number and nothing else, or a ScenarioError that says what is expected: "the x of a base joint".
double number_of(std::string_view text, const Place& place, const std::string& what);
// Several, between blanks or commas, with or without brackets; `most` at most.
std::vector<double> numbers_of(std::string_view text, const Place& place, const std::string& what, std::size_t most);

// A word of a file as it may be told in a line of its own: printable ASCII, not too long.
std::string shown(std::string_view text);

std::vector<std::string> words_of(std::string_view text);
std::string lower(std::string_view text);

// How the section of another file begins.
inline constexpr std::string_view include = "include ";

// Sections with keys and values. LinuxCNC: NAME = VALUE, comments from # or ; at the beginning of a line. Klipper: also NAME: VALUE, values
// that go on in lines that are set in, comments to the end of a line, and a block of saved values at the end, which count in place of those
// before them. A section [include FILE] is a setting without a key: the file is not read.
Settings read_linuxcnc_ini(const Lines& lines);
Settings read_klipper(const Lines& lines);

// The one that counts where a key stands several times: the first of LinuxCNC, the last of Klipper.
const Setting* first_of(const Settings& all, std::string_view section, std::string_view key);
const Setting* last_of(const Settings& all, std::string_view section, std::string_view key);

}  // namespace pmreport::program::settings
