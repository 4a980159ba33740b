// Panels of a workspace over two coordinates: what limits where, an index over it, how many orientations, a projection.
#pragma once

#include <core/mechanics/workspace/pose_limits.hpp>
#include <core/scan/field.hpp>
#include <reports/document/report.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pmreport::section {

// All take values over a grid of two axes, the last fastest, and draw the first axis to the right, the second upward, in the units that
// read best, and to one scale where they have one unit. `coordinates`: of the two axes, for their names and units; axes may run downward.
// Another number of axes, or an axis with a single value: std::invalid_argument.

// The accepted poses, the refused ones by the first margin that refuses them, and as lines named on themselves where the limits that bound
// the accepted poses are reached: "ρ₁ max". `margins`: of the field, in its order. Limits that refuse least go together when there are more
// than a reader can tell apart.
figure::Panel slice_panel(const scan::Field& field, const std::array<Coordinate, 2>& coordinates,
                          const std::vector<mechanics::PoseMargin>& margins);
// Slices that stand beside each other show a limit alike: `told` has the margins with a fill of their own, the same for all of them.
figure::Panel slice_panel(const scan::Field& field, const std::array<Coordinate, 2>& coordinates,
                          const std::vector<mechanics::PoseMargin>& margins, const std::vector<std::size_t>& told);
// The margins that refuse most points of some slices, in their order, as many as a reader can tell apart; the reach is not among them.
std::vector<std::size_t> margins_to_tell(const std::vector<const scan::Field*>& fields, const std::vector<mechanics::PoseMargin>& margins);
// The same as numbers: the coordinates, and the name of the first margin that refuses.
document::Data slice_data(const std::string& name, const scan::Field& field, const std::array<Coordinate, 2>& coordinates,
                          const std::vector<mechanics::PoseMargin>& margins);

// An index, NaN at refused poses. `bar`: what it is called, and its unit.
figure::Panel index_panel(const std::vector<scan::Axis>& axes, const std::vector<double>& values,
                          const std::array<Coordinate, 2>& coordinates, const figure::Axis& bar);

// How many orientations are accepted at each point, of `all`.
figure::Panel counts_panel(const std::vector<scan::Axis>& axes, const std::vector<std::uint32_t>& accepted_at,
                           const std::array<Coordinate, 2>& coordinates, std::size_t all);

// What a set over more axes looks like along all but two of them: of each point of those two, `first` and `second`, the largest value
// along the others. NaN counts as less than any number.
std::vector<double> largest_along_others(const std::vector<scan::Axis>& axes, const std::vector<double>& value, std::size_t first,
                                         std::size_t second);
// The outline of where a value is not negative, as a line.
figure::Panel outline_panel(const std::vector<scan::Axis>& axes, const std::vector<double>& value,
                            const std::array<Coordinate, 2>& coordinates, const std::string& label);

}  // namespace pmreport::section
