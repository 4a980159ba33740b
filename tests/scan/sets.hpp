// Sets of poses to scan, and what a scan of them counts when every pose is judged by itself, as a person would.
#pragma once

#include <core/scan/grid.hpp>
#include <tests/recorded_program/recording.hpp>

#include <cstdint>
#include <vector>

namespace sets {

using namespace pmreport;
using functions::Random;

// Margins of five coordinates, x, y, z, a tilt and a turn, such as a platform on three legs has: a reach that ends at a sphere, squares of
// lengths between two values, cosines, a distance that has no number everywhere. Limits are such that grids of quarters meet them exactly.
scan::PoseSet three_legs();
// r1 <= |(x, y, z)| <= r2 as two margins behind a reach that always holds.
scan::PoseSet shell(double r1, double r2);
// The sign of x + y + z + tilt - 0.25: zero on many poses of a grid of quarters.
program::Program plane();

// The same scan for all of `three_legs`: axes of which one is reversed or single now and then, and a list of orientations.
scan::Scan any_scan(Random& random, bool turned);

// One pose after another with Evaluator<double>, no block, no order but that of the list.
scan::GridCounts brute_force(const scan::PoseSet& set, const scan::Scan& scan, const scan::GridOptions& options);

// Every number of the two that a scan tells.
void check_same(const scan::GridCounts& a, const scan::GridCounts& b);

}  // namespace sets
