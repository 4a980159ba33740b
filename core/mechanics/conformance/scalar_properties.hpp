// The same geometry on other scalars, and at many poses at once, must give the same numbers.
#pragma once

#include <core/mechanics/machine/machine.hpp>

#include <string>
#include <vector>

namespace pmreport::mechanics {

struct ScalarDeviation {
  struct Largest {
    double value = 0;   // of numbers of the mechanism's own size; infinite where one is not finite and the other is
    std::string where;  // "7 poses at once, number 12"
    long evaluations = 0;
  };
  Largest lanes;            // poses many at once against one at a time, in every order of scalars, of placement and G
  Largest extended;         // extended against double precision, of the placement
  std::string no_extended;  // why the mechanism gives none; empty: it does
};
// `poses`: coordinates of poses in reach, one after another; of fewer than two nothing is compared.
ScalarDeviation scalar_deviation(const Machine& machine, const std::vector<double>& poses);

}  // namespace pmreport::mechanics
