// What of a mechanism's data looks odd, for whoever checks it.
#pragma once

#include <core/mechanics/machine/machine.hpp>

namespace pmreport::program {

// One block on standard output, a remark a paragraph; one line where there is none. Remarks fail nothing.
void print_remarks(const mechanics::Machine& machine);

}  // namespace pmreport::program
