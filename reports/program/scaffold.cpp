#include <reports/program/scaffold.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <reports/document/folder/file.hpp>
#include <reports/document/write.hpp>
#include <reports/program/scaffold_text.hpp>

namespace pmreport::program {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_name = 60;

// Targets that CMake keeps for itself.
constexpr std::array<std::string_view, 9> cmake_targets{"all",     "clean",      "edit-cache",    "help", "install",
                                                        "package", "preinstall", "rebuild-cache", "test"};

// What <pmreport/mechanism.hpp> and the scaffold itself name.
constexpr std::array<std::string_view, 46> taken_names{
    "Actuator",     "Bending",      "Body",      "ClosedForms", "Codec",       "Constraint", "Coordinate",  "Coordinates",
    "CrossSection", "Derived",      "Eigen",     "Element",     "ElementKind", "Functions",  "HasMatrices", "HasReadings",
    "Inertia",      "Instance",     "Jet",       "Joint",       "JointKind",   "Lanes",      "Layout",      "Leg",
    "Limb",         "Line",         "Material",  "Matrix3",     "Matrix6",     "Mechanism",  "Parameter",   "Parameters",
    "Partials",     "Placement",    "Range",     "Rates",       "Reading",     "Recorded",   "Sense",       "Shape",
    "ShapeKind",    "SourceMatrix", "Telescope", "Topology",    "Vector3",     "Vector3d"};

bool lower(char c) { return c >= 'a' && c <= 'z'; }
bool digit(char c) { return c >= '0' && c <= '9'; }

std::string filled(std::string text, std::string_view mark, std::string_view value) {
  for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += value.size()) text.replace(at, mark.size(), value);
  return text;
}

}  // namespace

std::string fault_of_name(std::string_view name) {
  constexpr const char* rule = "a mechanism's name has lower-case letters, digits and dashes, one letter at least, and begins with no dash";
  if (name.empty()) return fmt::format("the name is empty; {}", rule);
  if (name.size() > longest_name) return fmt::format("the name has {} letters; at most {} fit", name.size(), longest_name);
  if (!lower(name.front()) && !digit(name.front())) return fmt::format("'{}' begins with '{}'; {}", name, name.front(), rule);
  for (const char c : name)
    if (!lower(c) && !digit(c) && c != '-') return fmt::format("'{}' has a '{}'; {}", name, c, rule);
  if (std::none_of(name.begin(), name.end(), lower)) return fmt::format("'{}' has no letter; {}", name, rule);
  if (name.back() == '-' || name.find("--") != std::string_view::npos) return fmt::format("'{}': a dash stands between two words", name);
  if (std::find(cmake_targets.begin(), cmake_targets.end(), name) != cmake_targets.end())
    return fmt::format("'{}' is a target of CMake's own; choose another name", name);
  return "";
}

std::string class_of(std::string_view name) {
  std::string out = digit(name.front()) ? "Robot" : "";  // no class of C++ begins with a digit
  bool first = true;
  for (const char c : name) {
    if (c != '-') out += first && lower(c) ? static_cast<char>(c - 'a' + 'A') : c;
    first = c == '-';
  }
  return std::find(taken_names.begin(), taken_names.end(), out) != taken_names.end() ? out + "Mechanism" : out;
}

std::vector<ScaffoldFile> scaffold(std::string_view name) {
  std::vector<ScaffoldFile> files{{"mechanism.cpp", std::string(scaffold_text::mechanism)},
                                  {"CMakeLists.txt", std::string(scaffold_text::cmake)},
                                  {"scenario.toml", std::string(scaffold_text::scenario)},
                                  {"README.md", std::string(scaffold_text::readme)}};
  for (ScaffoldFile& f : files) f.text = filled(filled(std::move(f.text), "MyRobot", class_of(name)), "my-robot", name);
  return files;
}

fs::path write_scaffold(std::string_view name, const fs::path& folder) {
  if (const std::string fault = fault_of_name(name); !fault.empty()) throw ScaffoldError(fault);
  const fs::path made = folder / name;
  std::error_code error;
  if (fs::exists(fs::symlink_status(made, error)))
    throw ScaffoldError(fmt::format("{} is there already; choose another name, or another place with --folder", made.string()));
  fs::create_directories(made, error);
  if (error)
    throw document::OutputError(fmt::format("cannot make {}: {}. Choose another place with --folder.", made.string(), error.message()));
  try {
    for (const ScaffoldFile& f : scaffold(name)) document::write_new_file(made / f.name, f.text);
  } catch (...) {
    fs::remove_all(made, error);
    throw;
  }
  return made;
}

}  // namespace pmreport::program
