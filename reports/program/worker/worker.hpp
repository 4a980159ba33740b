// The work runs in a process of its own: plugins are native code, and one that crashes or hangs must not take the program along, nor leave
// its caller without an answer.
#pragma once

#include <optional>

namespace pmreport::program {

// Exit status when the worker does not come to an end of its own: a plugin that crashed, and a limit of time or memory.
inline constexpr int worker_crashed = 3, worker_limited = 5;

// In the program itself: runs it again as a worker with the same arguments, hands SIGINT and SIGTERM on, waits, and gives the exit status;
// a crash is told on stderr. `timeout` [s], 0: none. In the worker, or where no process can be started: nothing, and the caller does the
// work.
std::optional<int> run_in_worker(char** argv, double timeout);

// Said by a worker at its regular end. A worker that ends without has been ended by the plugin: its exit status means nothing.
void worker_done();

}  // namespace pmreport::program
