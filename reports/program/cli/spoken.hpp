// What the command line can say, as data: for whatever tells it to shells and readers.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pmreport::program {

// The type name of arguments that name a mechanism.
inline constexpr const char* mechanism_argument = "MECHANISM";
// The group of options that every command heeds; others of the program itself are of reports.
inline constexpr const char* of_every_command = "Options of every command";

struct SpokenOption {
  std::vector<std::string> names;  // "-o", "--out"
  std::string description;
  bool takes_value = false;
  std::vector<std::string> choices;  // of the value; empty: any
  bool everywhere = false;           // of the program itself: stands behind every command
};

struct SpokenArgument {
  std::string name, description;
  bool needed = false, several = false, mechanism = false;
  std::vector<std::string> choices;
};

struct SpokenCommand {
  std::vector<std::string> words;  // {"new", "scenario"}; none: the program itself
  std::string description;
  std::vector<SpokenOption> options;  // its own
  std::vector<SpokenArgument> arguments;
  std::vector<SpokenCommand> commands;
};

SpokenCommand spoken(const CLI::App& app);
// The program and all commands below it, those before what is below them.
std::vector<const SpokenCommand*> all_of(const SpokenCommand& program);

// A script of bash, zsh or fish that completes it. Mechanisms are those that `pmreport list` tells.
std::string completion(const SpokenCommand& program, const std::string& shell);
// A manual page, in roff.
std::string manual(const SpokenCommand& program, const std::string& version);

}  // namespace pmreport::program
