// The boundary of a set of poses in space, as a mesh.
#pragma once

#include <core/scan/field.hpp>
#include <reports/scene/scene.hpp>

#include <vector>

namespace pmreport::section {

// The surface about the points of a grid of three axes where `value` is not negative, last axis fastest: closed, also where the set goes
// on beyond the grid, every edge between two triangles, and turned outward. NaN is outside. Coordinates are those of the axes as x, y and
// z; the colour is left to the caller; empty where no point is inside. An axis with a single value, another number of axes, or of values
// than the grid has: std::invalid_argument. By marching tetrahedra, A. Doi and A. Koide (1991).
scene::Surface boundary_surface(const std::vector<scan::Axis>& axes, const std::vector<double>& value);
// The same about the points where no margin is negative, with the edges at which one takes over from another. `rounding`: of each margin; a
// margin nearer to zero counts as zero.
scene::Surface boundary_surface(const scan::Field& field, const std::vector<double>& rounding);

// Enclosed by a closed surface that is turned outward, by the divergence theorem [cube of the units of its points].
double enclosed_volume(const scene::Surface& surface);

}  // namespace pmreport::section
