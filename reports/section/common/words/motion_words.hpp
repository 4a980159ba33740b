// What is odd about the motion that a scenario asks for: it jumps, or it does between its samples what they do not show.
#pragma once

#include <core/analysis/study/between_samples.hpp>
#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

using mechanics::Break;

// How often value or rate of something that is prescribed jump.
int count_jumps(const Analysis& a);
// Whether the scenario asks for what follows from rates of a motion that it prescribes: then neither values nor rates may jump.
bool must_be_smooth(const Analysis& a);
// "The rate of x jumps by 100 mm/s at t = 1 s and 3 s: no finite force follows it.", one for each that jumps: in value or rate; in
// acceleration.
std::vector<std::string> jump_sentences(const Analysis& a);
std::vector<std::string> acceleration_sentences(const Analysis& a);
// "Between its samples x goes up to 1 mm beyond them (at t = 0.0025 s), and its samples ...: 101 samples cannot show it, 2001 do."
std::vector<std::string> unseen_sentences(const Analysis& a, const std::vector<analysis::Unseen>& unseen);
// What every report demands of its motion, beside what evaluate_checks does: that the samples show it; where the scenario asks for rates,
// accelerations or forces, that neither values nor rates jump.
std::vector<document::Check> motion_demands(const Analysis& a, const std::vector<analysis::Unseen>& unseen);

}  // namespace pmreport::section
