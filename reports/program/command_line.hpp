// What the user typed.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace pmreport::program {

// Part of the interface, in README.md.
enum ExitStatus { all_well = 0, gate_failed = 1, bad_scenario = 2, plugin_failed = 3, output_failed = 4, resource_limit = 5 };

enum class Command { report, list, describe, check, new_mechanism, classify, limits };

struct Options {
  Command command = Command::report;
  std::vector<std::filesystem::path> plugin_path;
  int threads = 0;     // 0: all cores
  double timeout = 0;  // [s]; 0: none
  // report
  std::string scenario, out;
  bool check_only = false, quiet = false;
  bool resume = false;  // long scans go on with what an interrupted run has left
  // limits
  std::string format = "toml", axes;  // settings of which controller; letters of its axes, "alpha=c,beta=a"
  // describe, classify
  bool json = false;
  // describe, new mechanism: one; check: several, or all
  std::vector<std::string> names;
  bool check_all = false;
  int poses = 1000;
  std::string parameters, setting;  // of the one to check: as in a scenario's table; the scenario that sets them
  std::string folder;               // of a new mechanism
};

// What is asked for; or the exit status, when that was told at once: help, the version, a mistake.
std::variant<Options, int> read_command_line(int argc, char** argv);

}  // namespace pmreport::program
