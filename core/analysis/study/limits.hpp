// What the motion asks of actuators and joints, against [limits] of the scenario.
#pragma once

#include <core/analysis/analysis.hpp>

#include <vector>

namespace pmreport::analysis {

// A limit is kept when it is met exactly: a motion slowed down until it just keeps a limit must keep it, and not break it by rounding.
constexpr double met_exactly = 1e-9;  // relative

// Every limit that some sample breaks: the first to be broken in time first. The breach's subject tells what is limited: "force of l3
// (length of limb 3)", "moment in joint B5".
std::vector<LimitBreach> limit_breaches(const Analysis& a);
// Samples that have a value to hold against the limits, and how many of them break one.
struct LimitCount {
  int judged = 0, broken = 0;
};
LimitCount count_limits(const Analysis& a);

}  // namespace pmreport::analysis
