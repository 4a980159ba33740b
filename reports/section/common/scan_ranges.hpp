// Ranges of coordinates that are scanned: x = ["-300 mm", "300 mm", 61], from, to, and of a grid how many values.
#pragma once

#include <core/analysis/workspace/request.hpp>
#include <core/scenario/section/reading.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// The ranges in a table of coordinates, called `where` by the user: "section.scan". What is wrong is told, and left out.
std::vector<analysis::ScanRange> read_scan_ranges(const scenario::Entry& entry, const std::string& where, const scenario::Reading& r);

}  // namespace pmreport::section
