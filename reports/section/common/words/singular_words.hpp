// What a reader is told of singularities, wherever forces, rates or verdicts depend on them.
#pragma once

#include <reports/section/common/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// "det G changes its sign": what shows at a crossing.
std::string signs_of(const Crossing& c);
// "the motion crosses a singular surface at t = 3.31 s: det G changes its sign. There the actuators do not hold the platform."
std::string sentence(const Analysis& a, const Crossing& c);

// What is lost on the way: one sentence for an architecture that is singular at every pose; else one for each crossing, and for each run
// of samples that are singular apart from those.
std::vector<std::string> singularity_sentences(const Analysis& a);
// How many times: 0 when nothing is lost.
int singularities_met(const Analysis& a);

// What comes near without being lost: the end of reach, a poor hold of the platform, coordinates that are singular where the machine is
// not.
std::vector<std::string> nearness_sentences(const Analysis& a);

}  // namespace pmreport::section
