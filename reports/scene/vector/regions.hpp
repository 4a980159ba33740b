// Regions of the picture with whole numbers for coordinates: unions and differences are then exact, and what shares an edge shares it to
// the last digit.
#pragma once

#include <polyclipping/clipper.hpp>
#include <reports/scene/vector/facets.hpp>

namespace pmreport::scene {

constexpr double fine = 128;  // units in a pixel

using Region = ClipperLib::Paths;  // outlines counter-clockwise, holes clockwise

ClipperLib::Path rounded(const Polygon& p);
Region united(const Region& parts);  // parts may overlap and are all filled
Region difference(const Region& from, const Region& less);
Region intersection(const Region& a, const Region& b);
// Without specks and slits, which rounding leaves where nothing is to be seen, and without corners that stand out by less than `near` [px].
Region tidy(const Region& r, double near = 0.08);
// Grown by `by` [px] all round: neighbours then overlap.
Region grown(const Region& r, double by);
// The union of parts that may stand a hair apart, as those of one body do after tidying.
Region closed(const Region& parts);
double area(const Region& r);  // [px²]

}  // namespace pmreport::scene
