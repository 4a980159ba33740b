// How near a pose may be to a singular one for its numbers to mean something.
#pragma once

#include <limits>

namespace pmreport::analysis {

// Beyond this condition number an answer has lost too many digits to be compared with another; beyond `singular` it is none.
inline constexpr double comparable = 1e7, singular = 1e11;

// What holds the platform at a sample: the unit wrenches of its limbs (mechanics/model/overall_jacobian.hpp). Levers of the actuators,
// which vanish at the end of reach, play no part in them.
struct HoldingWrenches {
  int side = 0;  // of the singular surface; 0: on it, to rounding, or there is no pose
  double determinant = std::numeric_limits<double>::quiet_NaN();
  double condition = std::numeric_limits<double>::infinity();
  double amplification = std::numeric_limits<double>::infinity();  // of a load of unit size, moments per characteristic length

  bool are_comparable() const { return side != 0 && condition < comparable; }
  bool are_singular() const { return side == 0 || !(condition < singular); }
};

}  // namespace pmreport::analysis
