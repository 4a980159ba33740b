// What a workspace section may be asked.
#pragma once

#include <core/analysis/workspace/request.hpp>
#include <core/scenario/section/key.hpp>
#include <pmreport/topology.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

struct WorkspaceOptions : scenario::Options {
  std::string name;  // of this section among several, for checks and files; empty: it has none
  analysis::WorkspaceRequest request;
  std::vector<Eigen::VectorXd> slices;  // what coordinates are held at in the slices, NaN: home; empty: one through home
  std::string map;                      // an index shown over the slices: "condition" or "determinant"; empty: none
  bool pictures = true, exports = true;

  std::vector<std::string> scanned, units;            // names of the scanned coordinates, and their units, for quantities
  std::vector<std::string> safe_scanned, safe_units;  // of the safe box: orientations too
  std::string unit;                                   // of the volume
};

// "workspace.volume", or "workspace.NAME.volume".
std::string quantity_name(const WorkspaceOptions& options, const std::string& own);

}  // namespace pmreport::section
