// Section `stiffness`, and its parts.
#pragma once

#include <core/analysis/stiffness/numbers.hpp>
#include <reports/section/common/pose_map.hpp>
#include <reports/section/common/stage.hpp>
#include <reports/section/kind.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

using analysis::StiffnessRequest;

Result stiffness_section(const Analysis& a, const StiffnessRequest& request, const Stage& stage, const Progress& progress);

// A pose that the section looks at closely.
struct ElasticView {
  std::string name;     // "home", "t = 2.5 s", "pose 1"
  Eigen::VectorXd q;    // coordinates
  bool loaded = false;  // under the load of the motion
  mechanics::ElasticPose pose;
  analysis::ToolElasticity tool;
  std::vector<double> placement;
};

// What is declared, at a pose: dimensions, stiffnesses, and what is left rigid.
document::Table element_table(const Analysis& a, const ElasticView& at);
// Limbs that carry load and have no element; "limb 2 and limb 3".
std::vector<std::string> rigid_limbs(const Analysis& a);

// "x = 10 mm and z = 900 mm", what differs from home; "home".
std::string where_words(const mechanics::Machine& m, const Eigen::VectorXd& q);

// Along the motion. Empty figures are left out.
std::vector<figure::Figure> motion_figures(const Analysis& a);
document::Table motion_extremes(const Analysis& a);

// Of the poses that are looked at.
std::vector<document::Block> pose_blocks(const Analysis& a, const StiffnessRequest& request, const std::vector<ElasticView>& views);
document::Table matrix_table(const mechanics::Matrix6d& m, bool stiffness, const std::string& caption);

// Indices over the map.
// `singular`: poses of it that the actuators do not hold; extremes over the map are then not known.
DrawnMap stiffness_map(const Analysis& a, const StiffnessRequest& request, std::vector<document::Value>& values, int& singular);

// The lowest mode of a pose, drawn: bodies where they are at the end of its swing, much enlarged.
Stage::Ordered mode_picture(const Analysis& a, const StiffnessRequest& request, const ElasticView& view, const Stage& stage,
                            std::size_t number);

}  // namespace pmreport::section
