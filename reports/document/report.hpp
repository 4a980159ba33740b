// The finished report, before any file exists: sections of text, tables, figures, pictures and evidence, the data behind them, the checks.
// Writers turn it into HTML, PDF, CSV, JSON and JUnit; they compute nothing.
#pragma once

#include <reports/figure/figure.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace pmreport::document {

// All strings are plain text (UTF-8) that may hold anything a user typed; each writer escapes for its format.

struct Paragraph {
  enum class Tone { plain, note, warning } tone = Tone::plain;  // warning: a limit broken, a pose out of reach
  std::string text;
};

struct Table {
  std::string caption;
  std::vector<std::string> headings;  // with unit: "stroke min [mm]"
  std::vector<bool> numeric;          // column is aligned right
  std::vector<std::vector<std::string>> rows;
};

struct Picture {        // a snapshot
  std::string id;       // file name without extension
  std::string caption;  // "t = 0 s, isometric"
  std::string png;
  int width = 0, height = 0;  // [px]
};
struct Gallery {
  std::vector<Picture> pictures;
  std::string caption;
};

enum class Verdict { passed, failed, not_examined };  // "passed" is for what was looked at and could have failed

// One line of proof: a residual that must stay below its tolerance.
struct Evidence {
  std::string claim;  // "loop closure: every joint meets"
  std::string how;    // the two ways compared, or the definition, one sentence
  double value = 0;   // NaN: could not be computed, which fails
  double tolerance = 0;
  std::string unit;         // SI, or "" for relative
  std::string reason = {};  // why there is no value, where there is none
  bool examined = true;

  // A claim that there was nothing to hold against, for this reason.
  static Evidence not_examined(std::string claim, std::string how, std::string reason) {
    return {std::move(claim),  std::move(how), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), "",
            std::move(reason), false};
  }
  Verdict verdict() const { return !examined ? Verdict::not_examined : value <= tolerance ? Verdict::passed : Verdict::failed; }
  bool failed() const { return verdict() == Verdict::failed; }
};
struct Proof {
  std::vector<Evidence> lines;
};

using Block = std::variant<Paragraph, Table, figure::Figure, Gallery, Proof>;

struct Section {
  std::string id;  // unique, for links: "displacement"
  std::string kind, title;
  std::vector<Block> blocks;
};

struct Data {                                // data/<name>.csv
  std::string name;                          // "displacement"
  std::vector<std::string> headings;         // "t [s]", "x [m]"
  std::vector<std::vector<double>> columns;  // equally long; not finite: empty cell
};

struct Check {
  std::string name;             // "max(abs(actuator_force)) < 400 N"
  std::string measured, limit;  // "312.4 N", "400 N"
  double value = 0, bound = 0;  // SI
  std::string unit;
  bool passed = false;
  std::string message;  // a sentence when failed, "t = 1.32 s: ..."
  int line = 0;         // in the scenario
};

struct Value {  // a scalar result for results.json
  std::string section, name, unit;
  double value = 0;
};

struct Provenance {              // nothing of it may differ between two runs of the same thing
  std::string program, version;  // "pmreport", "1.0.0"
  std::string mechanism, plugin_build, scenario_name, scenario_sha256;
};

struct Report {
  std::string title, author, description;
  std::string mechanism_title, source;
  std::string scenario_text;
  std::vector<Paragraph> summary;  // what a hurried reader must know, worst first
  std::vector<Section> sections;
  std::vector<Data> data;
  std::vector<Check> checks;
  std::vector<Value> values;
  Provenance provenance;
  bool passed() const;  // no check fails and no line of evidence
};

}  // namespace pmreport::document
