#include <reports/program/terminal.hpp>
#include <reports/program/worker/environment.hpp>
#include <reports/program/worker/in_worker.hpp>
#include <reports/program/worker/notes.hpp>
#include <reports/program/worker/sandbox.hpp>
#include <reports/program/worker/worker.hpp>

#include <core/text/text.hpp>
#include <reports/document/folder/file.hpp>
#include <reports/document/folder/left_behind.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace pmreport::program {

namespace {

using document::Descriptor;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds patience_allowed{5};  // between an interruption and the end by force
constexpr std::chrono::seconds farewell{2};          // between a worker's regular end and the end of its process
constexpr int between_looks = 20;                    // [ms], where the pipe does not wake us
constexpr std::size_t most_libraries_left_out = 32;

constexpr int handed[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

volatile sig_atomic_t worker = 0, handed_on = 0;
void hand_on(int signal) {
  handed_on = signal;
  if (worker > 0) kill(static_cast<pid_t>(worker), signal);
}

// While it lives, these signals wait: one that came between the start of the worker and the note of its number would be lost.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t all;
    sigemptyset(&all);
    for (const int signal : handed) sigaddset(&all, signal);
    sigprocmask(SIG_BLOCK, &all, &before_);
  }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
  ~SignalsWait() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  const sigset_t& before() const { return before_; }

 private:
  sigset_t before_;
};

struct Pipe {
  Pipe() {
    int both[2];
    if (pipe2(both, O_CLOEXEC) != 0) return;
    out = Descriptor(both[0]), in = Descriptor(both[1]);
  }
  bool good() const { return in.number() >= 0; }
  Descriptor out, in;
};

void let_inherit(const Descriptor& d) { fcntl(d.number(), F_SETFD, 0); }

pid_t start(char** argv, std::vector<std::string>& variables) {
  std::vector<char*> environment;
  for (char** e = environ; *e != nullptr; ++e)
    if (matters(*e)) environment.push_back(*e);
  for (std::string& v : variables) environment.push_back(v.data());
  environment.push_back(nullptr);

  const SignalsWait wait;
  for (const int signal : handed) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;  // as nohup wants it
    struct sigaction action {};
    action.sa_handler = hand_on;
    sigaction(signal, &action, nullptr);
  }
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setsigmask(&attributes, &wait.before());
  pid_t pid = 0;
  const int error = posix_spawn(&pid, "/proc/self/exe", nullptr, &attributes, argv, environment.data());
  posix_spawnattr_destroy(&attributes);
  worker = error == 0 ? pid : 0;
  return error == 0 ? pid : -1;
}

// How a worker ended, and what it said before.
struct End {
  Heard heard;
  int status = 0;  // as waitpid tells it
  bool late = false, killed = false;
};

void listen(const Descriptor& pipe, Heard& heard, bool& open) {
  char bytes[4096];
  const ssize_t n = read(pipe.number(), bytes, sizeof bytes);
  if (n > 0) heard.take({bytes, static_cast<std::size_t>(n)});
  if (n == 0) open = false;
}

// Waits for the worker, and ends it where it must be.
End attend(pid_t pid, const Descriptor& notes, double timeout) {
  End end;
  const auto begin = Clock::now();
  std::optional<Clock::time_point> patience;  // an interrupted worker ends by itself between two steps, unless it hangs in one
  bool open = true;
  fcntl(notes.number(), F_SETFL, O_NONBLOCK);
  while (true) {
    pollfd stream{open ? notes.number() : -1, POLLIN, 0};
    poll(&stream, 1, between_looks);
    if (open) listen(notes, end.heard, open);
    const pid_t ended = waitpid(pid, &end.status, WNOHANG);
    if (ended == pid) break;
    if (ended < 0 && errno != EINTR) {  // nobody knows how it ended
      end.status = SIGKILL;
      break;
    }
    const auto now = Clock::now();
    if (end.heard.done >= 0 && !patience) patience = now + farewell;
    if (handed_on != 0 && !patience) patience = now + patience_allowed;
    end.late = end.late || (timeout > 0 && end.heard.done < 0 && std::chrono::duration<double>(now - begin).count() > timeout);
    if (!end.killed && (end.late || (patience && now > *patience))) {
      kill(pid, SIGKILL);
      end.killed = true;
    }
  }
  worker = 0;
  while (open) {
    pollfd stream{notes.number(), POLLIN, 0};
    if (poll(&stream, 1, 0) <= 0) break;  // a process that the plugin has left may hold the pipe
    listen(notes, end.heard, open);
  }
  return end;
}

std::string name_of(int signal) { return fmt::format("{} (signal {})", strsignal(signal), signal); }

std::string untouched(const Heard& heard) {
  return heard.standing.empty() ? "an earlier report is untouched" : fmt::format("the new report stands: {}", printable(heard.standing));
}

// The sentence, and the exit status.
int tell_end(const End& end, double timeout) {
  const Heard& heard = end.heard;
  if (heard.done >= 0) return heard.done;
  if (end.late) {
    tell("error: not done after {} s (--timeout); {}\n", timeout, untouched(heard));
    return worker_limited;
  }
  if (end.killed) {
    tell("interrupted in the midst of a step that did not end; {}\n", untouched(heard));
    return 128 + handed_on;
  }
  // Before it has begun no plugin has a part in what ends it: a library that could not be set up for lack of memory.
  if (heard.no_memory || !heard.begun) {
    tell("error: out of memory; ask for fewer samples or smaller pictures; {}\n", untouched(heard));
    return worker_limited;
  }
  const std::string in_plugin = !heard.loading.empty() ? heard.loading : heard.in_plugin;
  const std::string where = in_plugin.empty() ? "" : fmt::format(" in {}", printable(in_plugin));
  if (WIFEXITED(end.status)) {
    if (in_plugin.empty() && heard.in_library.empty())
      tell("error: the mechanism's plugin ended the program (exit status {}); {}\n", WEXITSTATUS(end.status), untouched(heard));
    else
      tell("error: {} ended the program (exit status {}){}; {}\n", in_plugin.empty() ? "a library" : "the mechanism's plugin",
           WEXITSTATUS(end.status), in_plugin.empty() ? fmt::format(" in {}", printable(heard.in_library)) : where, untouched(heard));
    return worker_crashed;
  }
  const int signal = heard.signal > 0 ? heard.signal : WTERMSIG(end.status);
  if (handed_on == signal) return 128 + signal;
  if (signal == SIGKILL || signal == SIGXCPU) {
    tell("error: the work was killed (signal {}), perhaps for lack of memory or time; ask for fewer samples or smaller pictures; {}\n",
         signal, untouched(heard));
    return worker_limited;
  }
  if (in_plugin.empty() && !heard.in_library.empty()) {
    tell(
        "error: {} gave up: {}; libraries do where memory, threads or files run out: look at `ulimit -a`, ask for fewer samples or smaller "
        "pictures; {}\n",
        printable(heard.in_library), name_of(signal), untouched(heard));
    return worker_limited;
  }
  tell("error: the mechanism's plugin crashed: {}{}; {}. Run `pmreport check` on the plugin, under a debugger if need be\n",
       name_of(signal), where, untouched(heard));
  return worker_crashed;
}

}  // namespace

std::optional<int> run_in_worker(char** argv, double timeout, const std::vector<std::filesystem::path>* only_in) {
  end_with_many();
  std::vector<std::string> left_out;
  while (true) {
    Pipe notes, life;
    if (!notes.good() || !life.good()) return std::nullopt;
    let_inherit(notes.in), let_inherit(life.out);
    std::vector<std::string> variables = marks_of_worker(notes.in.number(), life.out.number(), left_out);
    const pid_t pid = start(argv, variables);
    notes.in.close(), life.out.close();
    if (pid < 0) return std::nullopt;
    const End end = attend(pid, notes.out, timeout);
    if (end.heard.done < 0)
      for (auto path = end.heard.left_behind.rbegin(); path != end.heard.left_behind.rend(); ++path)
        if (only_in == nullptr || within(*only_in, path->second))
          document::clear_left_behind(static_cast<document::Left>(path->first), path->second);
    const bool by_itself = WIFSIGNALED(end.status) && WTERMSIG(end.status) != SIGKILL;
    const bool crashed = (end.heard.signal > 0 || by_itself) && !end.killed && handed_on == 0;
    if (end.heard.done >= 0 || !crashed || end.heard.loading.empty() || left_out.size() >= most_libraries_left_out)
      return tell_end(end, timeout);
    left_out.push_back(fmt::format("{}\n{}", end.heard.loading, name_of(end.heard.signal > 0 ? end.heard.signal : WTERMSIG(end.status))));
  }
}

}  // namespace pmreport::program
