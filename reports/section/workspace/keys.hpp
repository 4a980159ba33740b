// The keys of a workspace section, and how they are read.
#pragma once

#include <core/scenario/section/kind.hpp>
#include <core/scenario/section/reading.hpp>
#include <reports/section/workspace/options.hpp>

#include <vector>

namespace pmreport::section {

std::vector<scenario::Key> workspace_keys();
// What no key can judge alone: ranges that a method needs, coordinates that are given twice.
void complete_workspace(scenario::TableReader& table, const scenario::Reading& r, scenario::Options& options);

// [[section.limit]]
std::vector<mechanics::AskedLimit> read_asked_limits(const scenario::Entry& entry, const scenario::Reading& r);
scenario::Shape limit_shape();

}  // namespace pmreport::section
