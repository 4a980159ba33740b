// What a study may be asked.
#pragma once

#include <core/analysis/design/machine_numbers.hpp>
#include <core/analysis/design/sweep.hpp>
#include <core/scenario/loaded.hpp>
#include <core/scenario/section/key.hpp>

#include <memory>
#include <string>
#include <vector>

namespace pmreport::section {

inline constexpr std::size_t most_variants_told = 400;  // have values of their own, for checks

// A number that a study looks at.
struct StudiedNumber {
  analysis::MachineNumber what;
  std::string own;    // within quantities of the study: "volume", "inner_volume"
  std::string unit;   // SI
  std::string title;  // "volume of the workspace"
  std::string label;  // of axes and columns: "volume"
};

// A parameter that a study varies.
struct StudiedParameter {
  std::size_t index = 0;          // of the mechanism's parameters
  std::string name, title, unit;  // SI
  double own = 0;                 // of the scenario
  double from = 0, to = 0;        // SI, from < to
  std::size_t count = 0;          // of a sweep
};

// A machine that is laid beside others.
struct StudiedVariant {
  std::string name;
  std::shared_ptr<const scenario::Loaded> other;  // whose mechanism it is; null: that of this scenario
  std::string file;                               // of the other, as it is named; empty: this one
  mechanics::ParameterValues parameters;          // all of that mechanism
  std::vector<std::size_t> changed;               // those that the variant gives itself
  std::vector<analysis::WorkspaceRequest> requests;
};

struct StudyOptions : scenario::Options {
  enum class Asked { nothing, sweep, variants, optimise, pareto } asked = Asked::nothing;
  std::string name;  // of this section among several, for checks and files; empty: it has none
  std::vector<StudiedNumber> numbers;
  analysis::MachineStudy study;         // of this scenario's mechanism
  std::vector<std::string> workspaces;  // names of the sections that its requests come from
  std::vector<StudiedParameter> over;
  std::vector<StudiedVariant> variants;
  std::vector<analysis::DesignGoal> goals;
  std::vector<analysis::DesignConstraint> constraints;
  int evaluations = 200, points = 12;
};

}  // namespace pmreport::section
