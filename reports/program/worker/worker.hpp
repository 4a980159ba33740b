// The work runs in a process of its own: plugins are native code, and one that crashes or hangs must not take the program along, nor leave
// its caller without an answer, nor files behind.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::program {

// Exit status when the worker does not come to an end of its own: a plugin that crashed, and a limit of time, memory or threads.
inline constexpr int worker_crashed = 3, worker_limited = 5;

// False: this process is no worker. Else what it says finds its way to its parent, and crashes are told. To be called first of all.
bool begin_as_worker();

// A worker ends when its parent does, from here on: there is a thread that waits for that. Of no effect elsewhere.
void watch_parent();

// Runs the program again as a worker with the same arguments, hands SIGINT, SIGTERM, SIGHUP and SIGQUIT on, waits, removes
// what a worker that died has left, and gives the exit status; a crash is told on stderr, with the file of the plugin that is to blame. A
// library that crashes while it is loaded is left out, and the work begun anew. `timeout` [s], 0: none. `only_in`: folders in which alone
// it removes what was left, for a plugin may say what it likes; null: wherever that is. Where no process can be started: nothing, and the
// caller does the work.
std::optional<int> run_in_worker(char** argv, double timeout, const std::vector<std::filesystem::path>* only_in);

// In the environment of a program that makes one report of several: it ends when the one that started it does.
std::string mark_of_many();

// Said by a worker at its regular end, and of no effect elsewhere. One that ends without has been ended by a plugin: its exit status means
// nothing. What a plugin does later, as its library is unloaded, costs nobody a finished report.
void worker_done(int status);

}  // namespace pmreport::program
