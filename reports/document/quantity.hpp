// Numbers and units as a reader wants them: few digits, real powers of ten, real exponents.
#pragma once

#include <string>
#include <string_view>

namespace pmreport::document {

// "0.52", "312", "2.1 × 10⁻¹⁵"; "not computed" when not finite. A trailing zero is dropped only where nothing was rounded away: a tolerance
// of 1e-9 reads "1 × 10⁻⁹", a residual of 1.0000001e-9 reads "1.0 × 10⁻⁹".
std::string rounded(double value);

// "kg*m^2" as "kg·m²".
std::string unit_text(std::string_view si);

// Both together, "2.1 × 10⁻¹⁵ N·m".
std::string rounded(double value, std::string_view unit);

}  // namespace pmreport::document
