// An index of the mechanism over a slice.
#pragma once

#include <core/analysis/workspace/workspace.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/scan/field.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// "condition": largest over least singular value of G, moments over the characteristic length; "determinant": of G made dimensionless by
// that length, as maps of singularities show it. Of each point of the field, NaN where a margin is negative or the number does not exist.
std::vector<double> index_over(const mechanics::Machine& machine, const analysis::Workspace& w, const scan::Field& field,
                               const scan::Scan& scan, const std::string& index);

}  // namespace pmreport::section
