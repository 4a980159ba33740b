// `pmreport classify`: the class of parallel-cross mechanisms.
#pragma once

#include <string>

namespace pmreport::program {

std::string classify_text();
std::string classify_json();

}  // namespace pmreport::program
