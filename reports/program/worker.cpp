#include <reports/program/worker.hpp>

#include <fmt/core.h>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

namespace pmreport::program {

namespace {

constexpr const char* mark = "PMREPORT_WORKER";  // in the environment of a worker: its parent's process number

volatile sig_atomic_t worker = 0;
void hand_on(int signal) {
  if (worker > 0) kill(static_cast<pid_t>(worker), signal);
}

// A worker is one only for the parent that started it: a mark that was inherited further down means nothing.
bool is_worker() {
  const char* parent = std::getenv(mark);
  return parent != nullptr && parent == std::to_string(getppid());
}

}  // namespace

std::optional<int> run_in_worker(char** argv, double timeout) {
  if (is_worker()) return std::nullopt;
  const std::string marked = std::string(mark) + "=" + std::to_string(getpid());
  std::vector<char*> environment;
  for (char** e = environ; *e != nullptr; ++e)
    if (std::strncmp(*e, mark, std::strlen(mark)) != 0) environment.push_back(*e);
  environment.push_back(const_cast<char*>(marked.c_str()));
  environment.push_back(nullptr);

  struct sigaction action {};
  action.sa_handler = hand_on;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  pid_t pid = 0;
  if (posix_spawn(&pid, "/proc/self/exe", nullptr, nullptr, argv, environment.data()) != 0) return std::nullopt;
  worker = pid;

  int status = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout);
  bool late = false;
  while (true) {
    const pid_t done = waitpid(pid, &status, timeout > 0 && !late ? WNOHANG : 0);
    if (done == pid) break;
    if (done < 0 && errno != EINTR) return worker_crashed;
    if (done == 0) {
      if (std::chrono::steady_clock::now() > end) {
        late = true;
        kill(pid, SIGKILL);
      } else {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
    }
  }
  worker = 0;
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  const int signal = WTERMSIG(status);
  if (late) {
    fmt::print(stderr, "error: not done after {} s (--timeout); an earlier report is untouched\n", timeout);
    return worker_limited;
  }
  if (signal == SIGINT || signal == SIGTERM) return 128 + signal;
  if (signal == SIGKILL) {
    fmt::print(stderr,
               "error: the work was killed, perhaps for lack of memory; ask for fewer samples or smaller pictures. An earlier report is "
               "untouched\n");
    return worker_limited;
  }
  fmt::print(stderr,
             "error: the mechanism's plugin crashed: {} (signal {}); an earlier report is untouched. Run `pmreport check` on the plugin, "
             "under a debugger "
             "if need be\n",
             strsignal(signal), signal);
  return worker_crashed;
}

}  // namespace pmreport::program
