// How near a pose may be to a singular one for its numbers to mean something.
#pragma once

namespace pmreport::analysis {

// Beyond this condition number of G an answer has lost too many digits to be compared with another; beyond `singular` it is none.
inline constexpr double comparable = 1e7, singular = 1e11;

}  // namespace pmreport::analysis
