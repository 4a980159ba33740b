// The calls of the kernel that a worker in the sandbox does without.
#pragma once

namespace pmreport::program {

// From here on networks, other processes, programs, modes and owners of files, mounts, keys, clocks and what tells the kernel to go about
// such things by another way are refused with EPERM; of threads that are begun later too. No new privileges may be had (PR_SET_NO_NEW_PRIVS
// is set before). Throws SandboxError (sandbox.hpp).
void refuse_system_calls();

}  // namespace pmreport::program
