// Pictures made smaller.
#pragma once

#include <string>

namespace pmreport::document {

// A PNG at most `width` pixels wide, on white; itself where it is no wider, or no PNG.
std::string narrowed(const std::string& png, int width);

}  // namespace pmreport::document
