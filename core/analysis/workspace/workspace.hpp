// Where a mechanism reaches: a workspace section's answers, numbers alone.
#pragma once

#include <core/analysis/progress.hpp>
#include <core/analysis/workspace/request.hpp>
#include <core/mechanics/workspace/tool_point.hpp>
#include <core/scan/components.hpp>
#include <core/scan/field.hpp>
#include <core/scan/grid.hpp>
#include <core/scan/monte_carlo.hpp>
#include <core/scan/proved_volume.hpp>
#include <core/scan/safe_poses.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pmreport::analysis {

struct Workspace {
  WorkspaceRequest request;  // as it was carried out: counts and poses filled in
  // Margins, set and scan are of coordinates by the tool point, where there is one.
  std::optional<mechanics::ToolPoint> tool;
  mechanics::PoseMargins margins;
  scan::PoseSet set;
  scan::Scan scan;
  std::string unit;             // of the volume: "m^3", "m^2", "m^3*rad^3", "rad"
  bool home_inside = false;     // home, but for what `at` holds elsewhere, keeps every limit
  std::string home_refused_by;  // name of the first margin that it does not keep
  std::optional<scan::GridCounts> grid;
  std::optional<scan::Components> components;  // of the grid's points
  std::optional<scan::Sheet> sheet;
  std::optional<scan::ProvedVolume> proof;
  std::vector<scan::ProvedVolume> proof_at_least;  // of each of request.at_least, where there are orientations
  std::optional<scan::Estimate> estimate;
  std::optional<scan::SafeBox> safe_box;
  std::optional<scan::SafeBall> safe_ball;
  std::vector<scan::Axis> safe_axes;     // of both: all scanned coordinates at once, orientations too
  std::vector<double> safe_proportions;  // of these
  std::string not_proved;                // why a proof that was asked for was not made; empty: it was, or was not asked for
};

// Coordinates of the mechanism at a pose of the scan, and of the scan at a pose of the mechanism.
std::vector<double> machine_pose(const Workspace& w, std::span<const double> scanned);
std::vector<double> scanned_pose(const Workspace& w, std::span<const double> of_machine);

// Why no proof can be made, as one sentence; empty: it can.
std::string unprovable(const Workspace& w);

// Cannot be done: too many poses, too much memory. The sentence says what would be needed, and what to do.
struct ScanTooLarge : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The mechanism records no geometry, or its coordinates do not tell the place of a tool point.
struct NoProgram : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws NoProgram, ScanTooLarge, what chunks::run throws, mechanics::MechanismError, and what progress.stop_if_asked throws.
Workspace workspace(const mechanics::Machine& machine, const WorkspaceRequest& request, const Progress& progress);

}  // namespace pmreport::analysis
