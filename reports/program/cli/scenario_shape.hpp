// All that may stand in a scenario, found by having scenarios read.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/scenario/section/key.hpp>

#include <vector>

namespace pmreport::program {

// The table of all keys outside of the sections, whose kinds tell theirs, as the reader of scenarios asks for them when the mechanism is
// this one. What it was not seen to read a value as may be anything: a Shape::either of nothing.
scenario::Shape shape_of_scenario(const pm_mechanism& mechanism, const Topology& topology);

// What holds for scenarios of either kind.
scenario::Shape merged(const scenario::Shape& a, const scenario::Shape& b);

// Without what is named after parts of the mechanism: a table of such keys has them as "names of the mechanism" (Shape::named), a word of
// them is any text.
scenario::Shape without_names(scenario::Shape shape, const Topology& topology);

}  // namespace pmreport::program
