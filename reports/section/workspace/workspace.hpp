// Section `workspace`: where the mechanism reaches, what limits it, and what a controller may be told.
#pragma once

#include <core/analysis/workspace/workspace.hpp>
#include <reports/section/kind.hpp>
#include <reports/section/workspace/options.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

using analysis::Workspace;

Result workspace_section(const Context& context, const WorkspaceOptions& options);

// -- its parts ------------------------------------------------------------------------------------------------------------------------

// Tables and sentences.
std::vector<document::Paragraph> workspace_words(const Workspace& w, const mechanics::Machine& machine);
std::string workspace_summary(const Workspace& w, const std::string& name);  // `name` of the section, or none
document::Table workspace_volumes(const Workspace& w);
document::Table workspace_reasons(const Workspace& w);  // of no rows where none were counted
document::Table workspace_extent(const Workspace& w, const mechanics::Machine& machine);
document::Table safe_limits(const Workspace& w, const mechanics::Machine& machine);  // of no rows where there is no safe box
document::Proof workspace_proof(const Workspace& w, const mechanics::Machine& machine);
std::vector<document::Value> workspace_values(const Workspace& w, const mechanics::Machine& machine, const WorkspaceOptions& options);
document::Data workspace_counts(const Workspace& w, const std::string& name);  // workspace.csv

// "z = 920 mm and α = 0°": what the scan holds; empty: nothing.
std::string held_words(const analysis::Workspace& w, const mechanics::Machine& machine);
// An end of the safe box, rounded towards home to whole thousandths of a millimetre or of a degree.
struct SafeEnd {
  double value;
  std::string unit;  // "mm", "deg"
};
SafeEnd safe_end_of(double si, const Coordinate& c, bool upper);
std::string margin_words(const Workspace& w, int margin);  // "rho1 at its most"; of -1 "the scanned range"

// Figures, pictures and files.
struct Drawn {
  std::vector<document::Block> blocks;
  std::vector<document::Data> data;
  std::vector<document::File> files;
};
Drawn draw_workspace(const Context& context, const Workspace& w, const WorkspaceOptions& options, const std::string& id);

}  // namespace pmreport::section
