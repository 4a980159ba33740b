// The limits of a workspace once more, as they are defined: on the plugin's own placement, by values against ends.
#pragma once

#include <core/analysis/workspace/workspace.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pmreport::analysis {

struct DefinitionCheck {
  int poses = 0;                           // compared
  int accepted = 0;                        // of them, by definition
  int differing = 0;                       // the margins say otherwise
  int near = 0;                            // left out: so near a limit that digits decide
  std::string first;                       // coordinates of the first that differs, in words; empty: none does
  std::vector<std::string> not_looked_at;  // limits that are judged in one way only
};
// Over poses spread evenly over the ranges of the scan, Halton's points; half of them, where home is within, around home.
DefinitionCheck check_by_definition(const Workspace& w, const mechanics::Machine& machine, int poses);

}  // namespace pmreport::analysis
