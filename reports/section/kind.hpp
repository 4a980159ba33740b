// A kind of section as the report makes it: what core/scenario knows of it, and how it is made.
#pragma once

#include <core/scenario/section/kind.hpp>
#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>
#include <reports/section/memory_need.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

class Stage;

// A section, and what it gives besides itself.
struct Result {
  document::Section section;
  std::vector<document::Value> values = {};      // its quantities: `section` the kind, `name` without it
  std::vector<document::Data> data = {};         // data files, besides the one of its columns
  std::vector<document::File> files = {};        // files of other formats
  std::vector<document::Check> checks = {};      // gates of its own
  std::vector<document::Finding> findings = {};  // what a hurried reader must know of it; the section is told by the report
};

// What a section is made of, besides what the scenario says of it.
struct Context {
  const Analysis& analysis;
  const Stage& stage;
  const Progress& progress;
  const std::vector<document::Value>& values;  // of the sections before; of all others where the kind needs them
  int number = 1;                              // of the section among its kind, from 1
};

struct SectionKind : scenario::SectionKind {
  Result (*make)(const Context&, const scenario::Section&) = nullptr;
  bool shared = false;  // its work comes in chunks that several processes may share; up to there it needs the machine alone
  // What it holds besides its columns; the first section of the kind has what all of them share. nullptr: little.
  MemoryNeed::Part (*memory)(const scenario::Loaded&, const scenario::Section&, bool first) = nullptr;
};

}  // namespace pmreport::section
