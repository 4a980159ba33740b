// The keys of a study, and how they are read.
#pragma once

#include <core/analysis/spread.hpp>
#include <core/scenario/section/kind.hpp>
#include <core/scenario/section/reading.hpp>
#include <reports/section/study/options.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::section {

std::vector<scenario::Key> study_keys();
// Which of its four questions a study asks: one, and no more.
void complete_study(scenario::TableReader& table, const scenario::Reading& r, scenario::Options& options);

// Index of the number of this name among those that the study looks at, to which it is added where it is new. Nothing, told, where the
// scenario has no such number.
std::optional<std::size_t> read_studied_number(const scenario::Value& value, const scenario::Reading& r, StudyOptions& options);
// The requests that the same numbers have in another scenario; nothing, told at `value`, where it lacks one.
std::optional<std::vector<analysis::WorkspaceRequest>> requests_elsewhere(const StudyOptions& options, const scenario::Loaded& other,
                                                                          const scenario::Value& value, const scenario::Reader& reader);

// Parameters with their ranges: from, to and, of a sweep, how many values.
void read_sweep(const scenario::Entry& e, const scenario::Reading& r, StudyOptions& options);
void read_optimise(const scenario::Entry& e, const scenario::Reading& r, StudyOptions& options);
void read_pareto(const scenario::Entry& e, const scenario::Reading& r, StudyOptions& options);
void read_variants(const scenario::Entry& e, const scenario::Reading& r, StudyOptions& options);

inline constexpr std::size_t most_numbers = 12, most_machines = 24, most_constraints = 12;
inline constexpr double most_variants = 10'000;  // that a sweep or a search may judge
inline constexpr double fewest_trials = 20, trials_a_point = 10, fewest_points = 3, most_points = 40;
inline constexpr int pareto_evaluations = 400;

}  // namespace pmreport::section
