// Section `reactions`, and its parts.
#pragma once

#include <reports/section/common/stage.hpp>
#include <reports/section/kind.hpp>

#include <core/analysis/study/joint_loads.hpp>
#include <core/analysis/study/limb_wrenches.hpp>
#include <core/mechanics/mobility/mobility.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pmreport::section {

struct ReactionsOptions : scenario::Options {
  std::vector<int> joints;  // whose reactions are drawn; empty: those with the largest
};

Result reactions_section(const Analysis& a, const ReactionsOptions& request, const Stage& stage);

// A component, or a joint, whose value is not determined by rigid bodies: the mark beside its least-norm value.
inline constexpr const char* least_norm_mark = "†";

using analysis::at_joints;
using analysis::joint_loads;
using analysis::JointLoad;
using analysis::LimbWrenches;
using analysis::samples_with_forces;
using analysis::state_of;

document::Table bearing_table(const Analysis& a, const std::vector<JointLoad>& loads);
document::Table direction_table(const Analysis& a, const std::vector<JointLoad>& loads);
// The components of each joint at its largest force, and at its largest moment where that is another sample.
document::Table component_table(const Analysis& a, const std::vector<JointLoad>& loads);

// The machine where a joint carries its largest force of all, with the force in each joint as an arrow. Only where there are forces.
Stage::Ordered reaction_picture(const Analysis& a, const std::vector<JointLoad>& loads, const Stage& stage);

// To the fourth digit of `largest`: no bearing is chosen by more, and a component that vanishes beside others reads as zero.
double rounded(double x, double largest);

// The wrenches of the limbs on the platform.
figure::Figure limb_figure(const Analysis& a, const LimbWrenches& limbs);
document::Table limb_table(const Analysis& a, const LimbWrenches& limbs);
// The 6 x 6 formula against the free bodies, where they differ: text, then a table. Empty: they agree, or there is no constraint wrench.
std::vector<document::Block> limb_formula(const Analysis& a, const LimbWrenches& limbs);
document::Evidence platform_in_balance(const LimbWrenches& limbs);

}  // namespace pmreport::section
