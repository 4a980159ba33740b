// Workspaces of the plugins as reference cases describe them.
#pragma once

#include <core/mechanics/workspace/pose_limits.hpp>
#include <core/scan/grid.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/plugin.hpp>

#include <memory>
#include <string>
#include <vector>

namespace pmreport::test {

// The machine of a case: its mechanism, with its parameters.
std::unique_ptr<mechanics::Machine> machine_of(const json& reference_case);

scan::PoseSet pose_set(const mechanics::PoseMargins& margins);

// A grid told by { "x": { "from", "to", "count" }, ... }: those of `points` are point axes, others of more than one value orientations.
scan::Scan scan_of(const mechanics::Machine& machine, const json& grid, const std::vector<std::string>& points);

}  // namespace pmreport::test
