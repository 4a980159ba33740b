// The curves of a figure for the script of the page: what it shows at the cursor.
#pragma once

#include <reports/figure/figure.hpp>

#include <string>

namespace pmreport::document {

// JSON, safe inside <script>:
//   {"x": [the times of curves, a list or {"from", "to", "n"} for n evenly spaced ones, ...],
//    "panels": [{"name": "(a) limb lengths", "time": whether against time, "unit": "mm", "low", "step", "rows": names in the place of
//    numbers,
//                "series": [{"label": "l₁", "points": true for dots alone, "x": which times, "y": values}]}]}
// Values count steps from low, the first of them whole, others less the one before; null is a gap. All is as drawn, that is with the
// offsets that labels tell. Only panels against time have values, of at most some hundred samples a curve: of longer ones those that a
// polyline needs to look the same. Empty where no panel has a curve.
std::string series_data(const figure::Figure& figure);

}  // namespace pmreport::document
