// Section `study`: machines with other parameters, or other machines, beside one another.
#pragma once

#include <core/analysis/design/front.hpp>
#include <core/analysis/design/optimise.hpp>
#include <reports/section/kind.hpp>
#include <reports/section/study/options.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

Result study_section(const Analysis& a, const StudyOptions& o, int number, const Progress& progress);

// What each question puts into the section.
void add_sweep(const Analysis& a, const StudyOptions& o, const Progress& progress, Result& out);
void add_variants(const Analysis& a, const StudyOptions& o, const Progress& progress, Result& out);
void add_optimum(const Analysis& a, const StudyOptions& o, const Progress& progress, Result& out);
void add_front(const Analysis& a, const StudyOptions& o, const Progress& progress, Result& out);

// The study of this scenario's machine, with its characteristic length; and what makes its variants. `progress` and the machine must
// outlive the judge.
analysis::MachineStudy study_of(const Analysis& a, const StudyOptions& o);
analysis::Judge judge_of(const Analysis& a, const StudyOptions& o, const analysis::MachineStudy& study, const Progress& progress);
// The problem of a search.
analysis::DesignProblem problem_of(const Analysis& a, const StudyOptions& o, const Progress& progress);

// How variants are judged, in words: by which request, at which home, over which length.
std::string method_words(const Analysis& a, const StudyOptions& o);

// Judges the scenario's own machine, and tells how long so many variants will take. The time is told there alone: no report depends on it.
analysis::Judged judge_own(const analysis::Judge& judge, const StudyOptions& o, std::size_t variants, const Progress& progress);

}  // namespace pmreport::section
