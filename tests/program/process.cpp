#include <tests/program/process.hpp>

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <utility>

namespace program_test {

namespace {

// What the program reads, and a user's plugins, stay out of a test that does not ask for them.
std::vector<std::string> environment_with(std::map<std::string, std::string> wanted) {
  for (const char* name : {"CI", "NO_COLOR", "PMREPORT_PLUGIN_PATH", "SOURCE_DATE_EPOCH", "LC_ALL", "LANG", "TZ"}) wanted.try_emplace(name);
  wanted.try_emplace("XDG_DATA_HOME", "/nonexistent");
  wanted.try_emplace("TERM", "xterm");
  std::vector<std::string> out;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    if (!wanted.contains(std::string(text.substr(0, text.find('='))))) out.emplace_back(text);
  }
  for (const auto& [name, value] : wanted)
    if (!value.empty()) out.push_back(name + "=" + value);
  return out;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  for (std::string& text : texts) out.push_back(text.data());
  out.push_back(nullptr);
  return out;
}

struct Ends {
  int ours, theirs;
};
// The child gets its end by dup2; neither end may be inherited besides, or the stream would never end.
Ends pair_of_ends(bool terminal) {
  int ends[2];
  if ((terminal ? openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) : pipe(ends)) != 0) throw std::runtime_error("no pipe");
  for (const int end : ends) fcntl(end, F_SETFD, FD_CLOEXEC);
  return {ends[0], ends[1]};
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const Surroundings& s) {
  const Ends out = pair_of_ends(false), err = pair_of_ends(s.terminal);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (!s.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, s.folder.c_str());
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  if (s.out)
    posix_spawn_file_actions_addopen(&actions, 1, s.out->c_str(), O_WRONLY | O_CREAT, 0666);
  else
    posix_spawn_file_actions_adddup2(&actions, out.theirs, 1);
  posix_spawn_file_actions_adddup2(&actions, err.theirs, 2);
  if (s.no_out) posix_spawn_file_actions_addclose(&actions, 1);
  if (s.no_err) posix_spawn_file_actions_addclose(&actions, 2);

  std::vector<std::string> arguments = command, environment = environment_with(s.environment);
  const int error =
      posix_spawnp(&id_, arguments.front().c_str(), &actions, nullptr, pointers(arguments).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  close(out.theirs);
  close(err.theirs);
  out_ = out.ours;
  err_ = err.ours;
  if (error != 0) throw std::runtime_error("cannot run " + command.front());
}

Process::~Process() {
  if (id_ > 0) {
    kill(id_, SIGKILL);
    finish();
  }
}

bool Process::read_some() {
  pollfd streams[] = {{out_, POLLIN, 0}, {err_, POLLIN, 0}};
  if (out_ < 0 && err_ < 0) return false;
  if (poll(streams, 2, -1) < 0 && errno != EINTR) throw std::runtime_error("no poll");
  for (const auto& [stream, text, number] : {std::tuple{streams[0], &result_.out, &out_}, {streams[1], &result_.err, &err_}}) {
    if (stream.revents == 0) continue;
    char buffer[65536];
    const ssize_t n = read(*number, buffer, sizeof buffer);
    if (n > 0) {
      text->append(buffer, static_cast<std::size_t>(n));
    } else if (n == 0 || errno != EINTR) {  // a terminal whose other side is gone gives EIO
      close(std::exchange(*number, -1));
    }
  }
  return true;
}

bool Process::says(std::string_view text) {
  while (result_.err.find(text) == std::string::npos)
    if (!read_some()) return false;
  return true;
}

void Process::send(int signal) { kill(id_, signal); }

Result Process::finish() {
  while (read_some()) {
  }
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = -1;
  result_.status = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return result_;
}

Result run(const std::vector<std::string>& command, const Surroundings& s) { return Process(command, s).finish(); }

Result run_pmreport(std::vector<std::string> arguments, const Surroundings& s) {
  arguments.insert(arguments.begin(), PROGRAM);
  return run(arguments, s);
}

}  // namespace program_test
