// A kind of section, as data: its name, its keys, what it needs of the run, which columns and quantities it has. Whoever reads a scenario
// is given the kinds that there are and knows none of them by name.
#pragma once

#include <core/scenario/section/key.hpp>
#include <cstddef>
#include <memory>
#include <pmreport/topology.hpp>
#include <span>
#include <string>
#include <vector>

namespace pmreport::scenario {

class TableReader;
struct Measurable;
struct Measured;

// A column of output, a number a sample: what checks, data files, plots and tables share.
struct Column {
  std::string name;   // "l1_force"
  std::string unit;   // SI: "N"
  std::string group;  // "actuator_force": a check may name the whole group
  std::string title;  // "force of l1"
};

// A single number that a section names, for checks, comparisons and results.json.
struct Quantity {
  std::string name;        // "mobility.redundant": the kind, a point, its own name
  std::string unit;        // SI
  std::string title;       // "redundant constraints"
  bool count = true;       // a whole number
  bool of_motion = false;  // of the motion, although its section can do without one
};

// What must be computed, or known, for a section.
struct Needs {
  bool motion = true;             // samples along a motion
  bool statics = false;           // forces at rest at every sample
  bool dynamics = false;          // forces in motion
  bool drives = false;            // what drives and motors give; within forces in motion
  bool reactions = false;         // the wrench in every joint; within forces in motion
  bool transmission = false;      // how well actuators move the platform
  bool stiffness = false;         // deflection, indices of the compliance, frequencies
  bool pictures = false;          // 3D pictures
  bool values_of_others = false;  // quantities of the other sections: made when these are
  // That the numbers are right, shown one way and another: of displacement, of velocity, of acceleration, of forces in motion, of power.
  bool displacement_evidence = false, velocity_evidence = false, acceleration_evidence = false, force_evidence = false,
       power_evidence = false;

  Needs& operator|=(const Needs& more);
};

// A table of the scenario without which a section has nothing to show.
struct NeededTable {
  std::string name;       // "drive"
  std::string lacking;    // "the table [drive], which is not there"
  std::string hint;       // what to write
  std::string idle = {};  // what else is true where the table stands and no section shows it; empty: it is of use without one
};

struct SectionKind {
  std::string name;
  std::string purpose;   // what it shows: one line, Markdown
  bool several = false;  // may stand more than once
  std::vector<Key> keys = {};
  Needs needs = {};
  std::vector<NeededTable> tables = {};
  // The columns that it shows and that checks may name while it is asked for; time, always first, is not listed. nullptr: none.
  std::vector<Column> (*columns)(const Topology&) = nullptr;
  // Its quantities as these options make them; all that it could ever have where the options are null. nullptr: it has none.
  std::vector<Quantity> (*quantities)(const Options*) = nullptr;
  // Its options where no key stands. nullptr: it has no keys.
  std::shared_ptr<Options> (*make_options)() = nullptr;
  // What no key can judge or set alone; called when all but the late ones are read.
  void (*complete)(TableReader&, const Reading&, Options&) = nullptr;
  // Takes from a number that a check or a comparison names the columns that this scenario leaves empty. Throws ExpressionError, at `offset`
  // of the text, when nothing is left.
  void (*narrow)(const Measurable&, std::size_t offset, Measured&) = nullptr;
};

// All kinds that there are, in the order in which they are told. They outlive every scenario that was read with them.
using Kinds = std::span<const SectionKind* const>;

// A section that a scenario asks for.
struct Section {
  const SectionKind* kind = nullptr;  // of a loaded scenario: never null
  std::string title;                  // empty: the kind's own
  int line = 0;
  std::shared_ptr<const Options> options;  // the kind's; null where it has no keys
};

// The options of a section whose kind has options O; std::bad_cast when it has others.
template <class O>
const O& options_of(const Section& section) {
  return dynamic_cast<const O&>(*section.options);
}

}  // namespace pmreport::scenario
