#include <reports/program/worker.hpp>

#include <fmt/core.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace pmreport::program {

namespace {

constexpr std::chrono::seconds grace{5};         // between an interruption and the end by force
constexpr const char* mark = "PMREPORT_WORKER";  // in the environment of a worker: "PARENT:PIPE", process number and file descriptor

int done_pipe = -1;  // of a worker: where it says that it is done
volatile sig_atomic_t worker = 0, handed_on = 0;
void hand_on(int signal) {
  handed_on = signal;
  if (worker > 0) kill(static_cast<pid_t>(worker), signal);
}

// While it lives, SIGINT and SIGTERM wait: one that came between the start of the worker and the note of its number would be lost.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t both;
    sigemptyset(&both);
    sigaddset(&both, SIGINT);
    sigaddset(&both, SIGTERM);
    sigprocmask(SIG_BLOCK, &both, &before_);
  }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
  ~SignalsWait() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  const sigset_t& before() const { return before_; }

 private:
  sigset_t before_;
};

int start(char** argv, const std::vector<char*>& environment) {
  const SignalsWait wait;
  struct sigaction action {};
  action.sa_handler = hand_on;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setsigmask(&attributes, &wait.before());
  pid_t pid = 0;
  const int error = posix_spawn(&pid, "/proc/self/exe", nullptr, &attributes, argv, environment.data());
  posix_spawnattr_destroy(&attributes);
  worker = pid;
  return error == 0 ? pid : -1;
}

template <class... T>
void tell(fmt::format_string<T...> format, T&&... values) {
  std::fputs(fmt::format(format, std::forward<T>(values)...).c_str(), stderr);
}

// A worker is one only for the parent that started it: a mark that was inherited further down means nothing.
bool is_worker() {
  const char* value = std::getenv(mark);
  const std::string parent = std::to_string(getppid()) + ":";
  if (value == nullptr || !std::string_view(value).starts_with(parent)) return false;
  done_pipe = std::atoi(value + parent.size());
  fcntl(done_pipe, F_SETFD, FD_CLOEXEC);
  return true;
}

}  // namespace

std::optional<int> run_in_worker(char** argv, double timeout) {
  if (is_worker()) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // nobody waits for an orphan's report
    return std::nullopt;
  }
  int done[2] = {-1, -1};
  if (pipe(done) != 0) return std::nullopt;
  fcntl(done[0], F_SETFD, FD_CLOEXEC);
  const std::string marked = fmt::format("{}={}:{}", mark, getpid(), done[1]);
  std::vector<char*> environment;
  for (char** e = environ; *e != nullptr; ++e)
    if (std::strncmp(*e, mark, std::strlen(mark)) != 0) environment.push_back(*e);
  environment.push_back(const_cast<char*>(marked.c_str()));
  environment.push_back(nullptr);

  const pid_t pid = start(argv, environment);
  close(done[1]);
  if (pid < 0) return std::nullopt;

  int status = 0;
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(timeout);
  std::optional<Clock::time_point> patience;  // an interrupted worker ends by itself between two steps, unless it hangs in one
  bool late = false, killed = false;
  while (true) {
    if (handed_on != 0 && !patience) patience = Clock::now() + grace;
    const pid_t ended = waitpid(pid, &status, (timeout > 0 || patience) && !killed ? WNOHANG : 0);
    if (ended == pid) break;
    if (ended < 0 && errno != EINTR) return worker_crashed;
    if (ended == 0) {
      late = timeout > 0 && Clock::now() > end;
      killed = late || (patience && Clock::now() > *patience);
      if (killed)
        kill(pid, SIGKILL);
      else
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  worker = 0;
  if (killed && !late) {
    tell("interrupted in the midst of a step that did not end; an earlier report is untouched\n");
    return 128 + handed_on;
  }
  if (WIFEXITED(status)) {
    char byte = 0;
    if (read(done[0], &byte, 1) == 1) return WEXITSTATUS(status);
    tell("error: the mechanism's plugin ended the program (exit status {}); an earlier report is untouched\n", WEXITSTATUS(status));
    return worker_crashed;
  }
  const int signal = WTERMSIG(status);
  if (late) {
    tell("error: not done after {} s (--timeout); an earlier report is untouched\n", timeout);
    return worker_limited;
  }
  if (signal == SIGINT || signal == SIGTERM) return 128 + signal;
  if (signal == SIGKILL) {
    tell(
        "error: the work was killed, perhaps for lack of memory; ask for fewer samples or smaller pictures. An earlier report is "
        "untouched\n");
    return worker_limited;
  }
  tell(
      "error: the mechanism's plugin crashed: {} (signal {}); an earlier report is untouched. Run `pmreport check` on the plugin, "
      "under a debugger "
      "if need be\n",
      strsignal(signal), signal);
  return worker_crashed;
}

void worker_done() {
  const char byte = 1;
  if (done_pipe < 0) return;
  [[maybe_unused]] const auto written = write(done_pipe, &byte, 1);  // where the parent is gone nobody is left to tell
}

}  // namespace pmreport::program
