#include <reports/program/cli/child.hpp>

#include <reports/document/folder/file.hpp>
#include <reports/document/write.hpp>
#include <reports/program/worker/worker.hpp>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

namespace pmreport::program {

namespace {

constexpr std::size_t most_told = 16384;  // [bytes]: whoever says more is not kept
constexpr int between_looks = 50;         // [ms], at whether the child has ended or is to

using document::Descriptor;

struct Pipe {
  Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "a pipe");
    out = Descriptor(ends[0]), in = Descriptor(ends[1]);
  }
  Descriptor out, in;
};

pid_t start(const std::vector<std::string>& arguments, const Pipe& out, const Pipe& err) {
  std::vector<char*> argv{const_cast<char*>("pmreport")};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  std::string mark = mark_of_many();
  std::vector<char*> environment;
  for (char** e = environ; *e != nullptr; ++e) environment.push_back(*e);
  environment.push_back(mark.data());
  environment.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out.in.number(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.in.number(), STDERR_FILENO);
  pid_t pid = -1;
  const int error = posix_spawn(&pid, "/proc/self/exe", &actions, nullptr, argv.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), "no process of its own for a scenario");
  return pid;
}

}  // namespace

ChildResult run_again(const std::vector<std::string>& arguments, bool (*stop)(), const std::function<void()>& before_words) {
  Pipe out, err;
  const pid_t pid = start(arguments, out, err);
  out.in.close(), err.in.close();

  ChildResult result;
  bool ended = false;
  const auto end_when_asked = [&] {
    if (!ended && stop()) {
      kill(pid, SIGTERM);  // it clears away what it has begun
      ended = true;
    }
  };
  std::array<pollfd, 2> streams{pollfd{out.out.number(), POLLIN, 0}, pollfd{err.out.number(), POLLIN, 0}};
  int status = 0;
  bool gone = false;
  // Not until both streams close: a process that a plugin has left may hold them.
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    end_when_asked();
    const int ready = poll(streams.data(), streams.size(), gone ? 0 : between_looks);
    if (ready < 0 && errno != EINTR) break;
    if (ready == 0 && gone) break;
    if (!gone && waitpid(pid, &status, WNOHANG) == pid) gone = true;
    if (ready <= 0) continue;
    for (pollfd& stream : streams) {
      if (stream.fd < 0 || stream.revents == 0) continue;
      char bytes[4096];
      const ssize_t n = read(stream.fd, bytes, sizeof bytes);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) {
        stream.fd = -1;  // poll passes it over
        continue;
      }
      const bool is_err = stream.fd == streams[1].fd;
      if (is_err && result.told.size() < most_told) result.told.append(bytes, static_cast<std::size_t>(n));
      before_words();
      std::fwrite(bytes, 1, static_cast<std::size_t>(n), is_err ? stderr : stdout);
      std::fflush(stdout);
    }
  }
  while (!gone) {
    const pid_t ended = waitpid(pid, &status, 0);
    if (ended < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "nobody knows how a scenario ended");
    gone = ended == pid;
    if (!gone) end_when_asked();
  }
  if (stop()) throw document::Interrupted("interrupted");
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace pmreport::program
