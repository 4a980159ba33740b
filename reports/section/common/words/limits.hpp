// What the motion breaks: strokes and limits of joints, and [limits] of the scenario. The worst is told first; many alike share a sentence.
#pragma once

#include <core/analysis/study/limits.hpp>
#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

using analysis::count_limits;
using analysis::limit_breaches;
using analysis::LimitCount;
using analysis::met_exactly;

// "t = 1.32 s to 2.1 s: l3 (length of limb 3) needs 812.4 mm, its stroke ends at 800 mm (worst at t = 1.64 s, 40 samples)."
std::string sentence(const Analysis& a, const LimitBreach& b);
// Of strokes and joints: "l1 to l6 leave their strokes at 214 of 501 samples, t = 0.1 s to 4.2 s; worst is l3 at t = 0.4 s: it needs 812.3
// mm, its stroke ends at 800 mm."
std::vector<std::string> breach_sentences(const Analysis& a);

// Each stroke and limit of a joint that is left: by how much, when, how often.
document::Table breach_table(const Analysis& a);

// "t = 0.3 s to 0.42 s: torque of theta1 (arm 1) is 31.2 N·m, the limit is 25 N·m (worst at t = 0.36 s, 14 samples)."
std::string limit_sentence(const Analysis& a, const LimitBreach& b);
// Of [limits]: "The forces of l1 to l6 exceed their limits at 20 of 501 samples, t = 0.3 s to 0.5 s; worst is l3 at t = 0.4 s: it is 431 N,
// the limit is 400 N."
std::vector<std::string> limit_sentences(const Analysis& a);
std::vector<std::string> joint_limit_sentences(const Analysis& a);  // those of joints alone

}  // namespace pmreport::section
