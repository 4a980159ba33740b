// Every variant that a search tried, as data; and what its searches rest on, as evidence.
#pragma once

#include <reports/section/study/study.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// One row a trial: what asked for it, why it has no numbers, parameters, numbers, whether it keeps every constraint.
document::Data data_of_trials(const StudyOptions& o, const analysis::DesignProblem& problem, const std::vector<analysis::Trial>& trials);

std::vector<const Judged*> judged_of(const std::vector<analysis::Trial>& trials);

// The gap between two brackets, of the larger value; 0 where they meet.
double relative_gap(const analysis::Bracketed& x, const analysis::Bracketed& y);
// How far the numbers of a closer look lie from those that a search saw, in the worst of them: the gap between the brackets, of the value.
// 0 where they meet; NaN where one has no numbers.
double disagreement(const StudyOptions& o, const Judged& seen, const Judged& closer);
// What it may be. Two proved brackets of one number meet; of counted numbers a difference below that by which optima are told apart does
// not change which variant is the best.
double allowed_disagreement(const StudyOptions& o);
// "tenth the gap of the proof": what the closer look is.
std::string closer_look(const StudyOptions& o);

// "home.condition ≤ 40"
std::string words_of(const StudyOptions& o, const analysis::DesignConstraint& c);
// "workspace.volume as large as possible"
std::string words_of(const StudyOptions& o, const analysis::DesignGoal& g);

}  // namespace pmreport::section
