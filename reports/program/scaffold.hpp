// `pmreport new mechanism NAME`: a folder with a small mechanism that builds against the installed program, passes `pmreport check` and has
// a scenario, for its author to change.
#pragma once

#include <filesystem>
#include <reports/document/write.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::program {

// A name that cannot be given, or a folder that is there already: the sentence says what to do.
class ScaffoldError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ScaffoldFile {
  std::string name, text;
};

// Why `name` cannot name a mechanism; empty when it can: lower-case letters, digits and dashes between them, and
// not digits alone.
std::string fault_of_name(std::string_view name);

// The class of mechanism NAME: my-robot gives MyRobot, 3-rps gives Robot3Rps. A name that the SDK has taken gets "Mechanism" appended.
std::string class_of(std::string_view name);

// The files of a sound name.
std::vector<ScaffoldFile> scaffold(std::string_view name);

// Writes them to FOLDER/NAME, which must not exist; FOLDER is made where it is missing. Returns the folder. Throws ScaffoldError, or
// document::OutputError where nothing can be written; it leaves nothing half-made.
std::filesystem::path write_scaffold(std::string_view name, const std::filesystem::path& folder);

}  // namespace pmreport::program
