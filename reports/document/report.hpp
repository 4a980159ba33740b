// The finished report, before any file exists: sections of text, tables, figures, pictures and evidence, the data behind them, the checks.
// Writers turn it into HTML, PDF, CSV, JSON and JUnit; they compute nothing.
#pragma once

#include <reports/document/every_instant.hpp>
#include <reports/document/input.hpp>
#include <reports/figure/figure.hpp>

#include <cairo.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
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
  bool ranked = false;  // the first rows matter most
};

struct Picture {        // a snapshot
  std::string id;       // file name without extension
  std::string caption;  // "t = 0 s, isometric"
  std::string png;
  int width = 0, height = 0;                                     // [px]
  std::string pdf = {}, svg = {};                                // the same as vectors; empty: there are none
  std::function<void(cairo_t* cr, double width)> as_lines = {};  // draws it `width` [pt] wide: pages show this and the SVG, not the PNG
};
struct Gallery {
  std::vector<Picture> pictures;
  std::string caption;
};

// What became of a line of evidence.
enum class Verdict {
  passed,  // it was looked at, and could have failed
  failed,
  not_decided,     // it was looked at, and neither shown nor refuted
  not_examined,    // it was not looked at
  not_applicable,  // there is nothing that it could be true of
  error            // it could not be computed, which fails as well
};
constexpr std::size_t verdicts = 6;

// One line of proof: a residual that must stay below its tolerance, or a statement of which the state is known otherwise.
struct Evidence {
  std::string claim;  // "loop closure: every joint meets"
  std::string how;    // the two ways compared, or the definition, one sentence
  double value = 0;   // NaN: could not be computed, an error
  double tolerance = 0;
  std::string unit;                    // SI, or "" for relative
  std::string reason = {};             // why there is no value; what fails, and when; what is not decided, and when
  std::optional<Verdict> stated = {};  // where value and tolerance do not tell it
  std::string demanded_by = {};        // name of the check that demands the same: a list of failures tells both once

  // A claim without a value, for this reason.
  static Evidence without_value(Verdict stated, std::string claim, std::string how, std::string reason) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {std::move(claim), std::move(how), none, none, "", std::move(reason), stated};
  }
  // A claim that there was nothing to hold against.
  static Evidence not_examined(std::string claim, std::string how, std::string reason) {
    return without_value(Verdict::not_examined, std::move(claim), std::move(how), std::move(reason));
  }
  Verdict verdict() const {
    if (stated) return *stated;
    return std::isnan(value) ? Verdict::error : value <= tolerance ? Verdict::passed : Verdict::failed;
  }
  bool failed() const { return verdict() == Verdict::failed || verdict() == Verdict::error; }
  bool has_numbers() const { return !stated; }
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

struct Data {                                        // data/<name>.csv
  std::string name;                                  // "displacement"
  std::vector<std::string> headings;                 // "t [s]", "x [m]"
  std::vector<std::vector<double>> columns;          // equally long; not finite: empty cell
  std::vector<std::vector<std::string>> words = {};  // columns of words, as long, which stand before those of numbers
};

struct File {         // anything else to go with the report, as it is
  std::string name;   // below the report's folder, in data/: "data/workspace.stl"; what is no plain name is made one
  std::string title;  // what it is, a phrase
  std::string bytes;
};

struct Check {
  std::string name;             // "max(abs(actuator_force)) < 400 N"
  std::string measured, limit;  // "312.4 N", "400 N"
  double value = 0, bound = 0;  // SI
  std::string unit;
  bool passed = false;
  std::string message;       // a sentence when failed, "t = 1.32 s: ..."; otherwise what else there is to say, or nothing
  int line = 0;              // in the scenario
  bool proved = false;       // decided for every instant of the motion, not at its samples alone
  Bracket bracket = {};      // of the value over every instant, SI; not finite: none is known
  std::string told_in = {};  // the unit of its words, where its author chose it: "rad/s"
};

struct Value {  // a scalar result for results.json
  std::string section, name, unit;
  double value = 0;
};

// A number that tells at a glance how the machine does, against what limits it.
struct KeyNumber {
  std::string what;                                         // "largest force of an actuator"
  std::string value;                                        // "312 N"
  std::string limit = {};                                   // "limit 400 N", "stroke 850 mm to 1490 mm"; empty: nothing limits it
  std::string where = {};                                   // "l₃, t = 1.2 s"; empty: of the whole
  std::string section = {};                                 // id of the section that shows it
  double used = std::numeric_limits<double>::quiet_NaN();   // share of the limit, more than 1 beyond it; NaN: no limit
  double number = 0;                                        // SI
  double bound = std::numeric_limits<double>::quiet_NaN();  // the end of the limit that is nearer, SI
  std::string unit = {};                                    // SI

  bool limited() const { return std::isfinite(used); }
  bool broken() const { return used > 1; }
};

// What a hurried reader must know: a sentence with its number and when.
struct Finding {
  enum class Kind {
    fault,         // a limit broken, a pose out of reach, a loss of control
    disagreement,  // with what was published
    surprise,      // of proportion
    result
  } kind = Kind::result;
  std::string text;
  std::string section = {};  // id of the section that shows it; empty: none does
};
const char* name_of(Finding::Kind kind);  // "fault"

struct Provenance {              // nothing of it may differ between two runs of the same thing
  std::string program, version;  // "pmreport", "1.0.0"
  std::string mechanism, plugin_build, scenario_name, scenario_sha256;
};

struct Report {
  std::string title, author, description;
  std::string mechanism_title, source;
  std::string scenario_text;
  std::vector<KeyNumber> key_numbers;    // a handful, what is nearest to its limit first
  std::vector<Finding> findings;         // worst first
  std::vector<Paragraph> summary;        // what was asked: motion, load, proof
  std::vector<Input> inputs;             // what went into it
  std::vector<std::string> assumptions;  // what all of it rests on, a sentence each
  std::vector<std::string> not_asked;    // kinds of examination that the scenario leaves out: "stiffness"
  std::optional<Picture> cover;          // of the machine
  std::vector<Section> sections;
  std::vector<Data> data;
  std::vector<File> files;
  std::string live;  // JavaScript: what moves the machine in the page; empty: nothing does
  std::vector<Check> checks;
  std::vector<Value> values;
  std::optional<EveryInstant> every_instant;  // of a motion
  Provenance provenance;
  bool passed() const;  // no check fails and no line of evidence
};

}  // namespace pmreport::document
