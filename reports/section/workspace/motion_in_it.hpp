// The motion within the workspace: how near it comes to the boundary, and to which limit.
#pragma once

#include <core/analysis/workspace/along_motion.hpp>
#include <reports/section/workspace/workspace.hpp>

namespace pmreport::section {

// A figure, its data and a sentence; nothing where the scenario has no motion.
Drawn motion_in_workspace(const Analysis& a, const Workspace& w, const std::string& id);

}  // namespace pmreport::section
