// What a request comes to for one machine: its scan, the set of its poses, where home lies.
#pragma once

#include <core/analysis/workspace/workspace.hpp>

#include <string>

namespace pmreport::analysis {

// With `at` at home, which is that of the scan, where it has no size or is NaN, at_least filled in (one, and all where there are several
// orientations), each method once.
WorkspaceRequest completed(WorkspaceRequest request, const std::vector<double>& home);
scan::PoseSet set_of(const mechanics::PoseMargins& margins);
scan::Scan scan_of(const WorkspaceRequest& request, const mechanics::Machine& machine);
std::string unit_of(const scan::Scan& scan, const mechanics::Machine& machine);  // "m^3", "m^2*rad"

// Home, but for the coordinates that are held elsewhere.
std::vector<double> home_of(const Workspace& w, const mechanics::Machine& machine);
// Whether it keeps the limits: home_inside and home_refused_by.
void judge_home(Workspace& w, const mechanics::Machine& machine);
// Number of the pose of the grid that is nearest to home, steps counted on each axis.
std::uint64_t nearest_to_home(const Workspace& w, const mechanics::Machine& machine);

}  // namespace pmreport::analysis
