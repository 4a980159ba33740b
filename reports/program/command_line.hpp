// What the user typed.
#pragma once

#include <core/chunks/sharing.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pmreport::program {

// Part of the interface, in README.md.
enum ExitStatus { all_well = 0, gate_failed = 1, bad_scenario = 2, plugin_failed = 3, output_failed = 4, resource_limit = 5 };

enum class Command {
  report,
  many,
  list,
  describe,
  check,
  new_mechanism,
  classify,
  limits,
  schema,
  new_scenario,
  import_settings,
  compare,
  approve
};

struct Options {
  Command command = Command::report;
  std::vector<std::filesystem::path> plugin_path;
  int threads = 0;                   // 0: all cores
  double timeout = 0;                // [s]; 0: none
  std::optional<double> max_memory;  // that a report may take [bytes]; none: by what the machine has
  bool sandbox = false;              // plugins can neither write elsewhere nor reach anybody
  // report
  std::string scenario, out;
  std::vector<std::string> scenarios;  // of several reports
  bool check_only = false, quiet = false;
  bool resume = false;                 // chunks of work that an interrupted run has left count
  std::optional<chunks::Shard> shard;  // only its chunks are done, and kept; there is no report
  bool merge = false;                  // all chunks are there: a report of them
  std::string chunks;                  // folder where they are kept; empty: beside the report
  chunks::Dealer* dealer = nullptr;    // of chunks, where several processes make one report
  std::string baseline;                // results that those of the report are held against; empty: none
  // report with a baseline, compare, approve: as of compare::Tolerance
  double relative = 1e-6, absolute = 1e-12;
  bool failed_too = false;  // approve: also the results of a report that did not pass
  // limits
  std::string format = "toml", axes;  // settings of which controller; letters of its axes, "alpha=c,beta=a"
  // describe, classify
  bool json = false;
  // describe, new mechanism, new scenario: one; schema: one, or none as an empty name; check: several, or all;
  // compare: the reports; approve: the report and its baseline; import: the files
  std::vector<std::string> names;
  bool check_all = false;
  int poses = 1000;
  std::string parameters, setting;  // of the one to check: as in a scenario's table; the scenario that sets them
  std::string folder;               // of a new mechanism
};

// What is asked for; or the exit status, when that was told at once: help, the version, a mistake.
std::variant<Options, int> read_command_line(int argc, char** argv);

}  // namespace pmreport::program
