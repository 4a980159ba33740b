// The hash that sha256sum prints.
#pragma once

#include <string>
#include <string_view>

namespace pmreport::document {

std::string sha256(std::string_view bytes);  // FIPS 180-4, in lower-case hexadecimal

}  // namespace pmreport::document
