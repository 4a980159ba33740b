// Every variant that a search tried, as data; and what its searches rest on, as evidence.
#pragma once

#include <reports/section/study/study.hpp>
#include <reports/section/study/words.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// One row a trial: what asked for it, why it has no numbers, parameters, numbers, whether it keeps every constraint.
document::Data data_of_trials(const StudyOptions& o, const analysis::DesignProblem& problem, const std::vector<analysis::Trial>& trials);

std::vector<const Judged*> judged_of(const std::vector<analysis::Trial>& trials);

// The gap between two brackets, of the larger value, less what a grid leaves open; 0 where they meet.
double relative_gap(const analysis::Bracketed& x, const analysis::Bracketed& y);
// How far the numbers of a closer look lie from those that a search saw, in the worst of them. NaN where one has no number, or the closer
// look has none at all.
double disagreement(const StudyOptions& o, const Judged& seen, const Judged& closer);
// What it may be: nothing, for two proved brackets of one number meet, and so do two counts within what their grids leave open. Of random
// poses one interval in twenty misses: below the difference by which optima are told apart that does not matter.
double allowed_disagreement(const StudyOptions& o);
// "tenth the gap of the proof": what the closer look is.
std::string closer_look(const StudyOptions& o);

// "home.condition ≤ 40"
std::string words_of(const StudyOptions& o, const analysis::DesignConstraint& c);
// "workspace.volume as large as possible"
std::string words_of(const StudyOptions& o, const analysis::DesignGoal& g);

}  // namespace pmreport::section
