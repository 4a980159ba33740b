// What is compared of a report: its values, verdicts and curves, whether it was read from its folder or has just been made.
#pragma once

#include <reports/document/report.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::compare {

// What was given is no results of a report. The message says what was expected, what was seen, and where.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Value {
  std::string section, name, unit;  // SI
  double value = 0;                 // NaN: the report has none
  std::string status;               // "ok", or why there is none
};

// A check or a line of evidence, and what became of it.
struct Judgement {
  std::string section, name;
  std::string state;  // "passed", "not decided"
};

struct Curves {  // of one data file: its columns of numbers against its first, the time
  std::string section;
  std::vector<std::string> headings;         // "x [m]"
  std::vector<double> time;                  // [s]
  std::vector<std::vector<double>> columns;  // as long as `time`; NaN: gap
};

struct Results {
  std::string label;  // what the user typed for it
  std::string title, mechanism, scenario, scenario_sha256, version, plugin_build;
  bool passed = false;
  std::vector<Value> values;          // those of the report, then what its checks measured, in a section "checks"
  std::vector<Judgement> judgements;  // checks, in a section "checks", then evidence
  std::vector<Curves> curves;
  std::string curves_missing;  // why there are none, or not all; empty: the report's are all here
};

constexpr std::string_view checks_section = "checks";

// Reads the text of a results.json, which has no curves. Throws InputError, which names `label`.
Results read_results(const std::string& text, const std::string& label);

// Of a report that was made just now.
Results results_of(const document::Report& report, const std::string& label);

// The file that a folder with a report or the path of a results.json means.
std::filesystem::path results_file(const std::string& folder_or_file);

// All bytes of a regular file. Throws InputError when there is none, when it is none, and when it is larger than any results are.
std::string bytes_of_results(const std::filesystem::path& file);

// A report's folder or its results.json, with the curves in data/ beside it. Throws InputError.
Results read_report(const std::string& folder_or_file);

}  // namespace pmreport::compare
