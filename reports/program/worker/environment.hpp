// What of the environment a report may depend on.
#pragma once

#include <string_view>

namespace pmreport::program {

// Of "NAME=VALUE": false of switches of the libraries that draw, some of which change a picture, and some hang.
bool matters(std::string_view variable);

// For a process that makes reports and was not started by one that left these out.
void forget_what_does_not_matter();

}  // namespace pmreport::program
