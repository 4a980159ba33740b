// The libraries that set text tell on the side what they could not do, and draw on with less: another font, or empty boxes. Here that is a
// failure.
#pragma once

namespace pmreport::figure {

// From now on in this process such warnings are kept, and not written to stderr.
void keep_library_warnings();

// Throws std::runtime_error with the first one, if there was any.
void throw_if_libraries_warned();

}  // namespace pmreport::figure
