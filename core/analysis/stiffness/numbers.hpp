// The numbers of elasticity at a pose, under the names of their columns: along a motion, over a map, at a pose.
#pragma once

#include <core/analysis/column_names.hpp>
#include <core/analysis/stiffness/request.hpp>
#include <core/mechanics/stiffness/answers.hpp>

#include <functional>
#include <vector>

namespace pmreport::analysis {

// Some part of the machine is not rigid.
bool gives_way(const mechanics::Machine& machine);

// A pose seen at its tool point, in the axes that the section asks for.
struct ToolElasticity {
  mechanics::Matrix6d to_tool;  // T of answers.hpp
  mechanics::Matrix6d compliance;
  mechanics::Vector6d deflection, by_load, by_weights, by_inertia, by_strain;
};
ToolElasticity at_tool(const mechanics::Machine& machine, const mechanics::ElasticPose& pose, const double* placement,
                       const StiffnessRequest& request);

// Natural frequencies [Hz], lowest first, at most so many: of the whole machine, or of the platform on massless limbs.
constexpr int told_frequencies = 6;
std::vector<double> frequencies(const mechanics::ElasticPose& pose, bool limb_inertia, double length);

// Hands every number of `pose` to `put` under its column's name (stiffness_columns); what the pose does not have is left out. `length`:
// characteristic length [m]; `loaded`: there are loads.
void stiffness_numbers(const mechanics::Machine& machine, const mechanics::ElasticPose& pose, const ToolElasticity& tool,
                       const StiffnessRequest& request, double length, bool loaded,
                       const std::function<void(const ColumnId&, double)>& put);

// Share of every element in the size of the tool's deflection, the last that of base and platform: they sum to 1, and may be negative. NaN
// without a deflection.
std::vector<double> budget_under_load(const mechanics::Machine& machine, const mechanics::ElasticPose& pose, const ToolElasticity& tool);
// The same in the translation of the tool under a unit force in the direction in which it gives most.
std::vector<double> budget_of_softest(const mechanics::Machine& machine, const mechanics::ElasticPose& pose, const ToolElasticity& tool,
                                      Eigen::Vector3d* direction = nullptr);

}  // namespace pmreport::analysis
