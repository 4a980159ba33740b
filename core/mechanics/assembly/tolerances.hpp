// What the searches for assembly modes and along them agree on.
#pragma once

namespace pmreport::mechanics {

inline constexpr double mode_error = 1e-10;      // largest residual of a mode, by substitution in the loop equations
inline constexpr double truncated_pivot = 1e-9;  // of the largest pivot: a direction that the equations do not feel
inline constexpr double slope_probe = 1e-3;      // half way between two slopes whose change is taken

}  // namespace pmreport::mechanics
