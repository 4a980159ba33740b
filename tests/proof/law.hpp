// The law of a motion in extended precision.
#pragma once

#include <functional>

namespace pmreport::test {

// The coordinates at a time [s], with rates and accelerations, each dof long.
using Law = std::function<void(long double t, long double* value, long double* rate, long double* acceleration)>;

}  // namespace pmreport::test
