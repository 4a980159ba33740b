#include <reports/program/terminal.hpp>
#include <reports/program/worker/in_worker.hpp>
#include <reports/program/worker/last_words.hpp>
#include <reports/program/worker/notes.hpp>
#include <reports/program/worker/worker.hpp>

#include <core/host/plugin_file.hpp>
#include <reports/document/folder/left_behind.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>
#include <chrono>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <thread>

namespace pmreport::program {

namespace {

constexpr const char* mark = "PMREPORT_WORKER";  // "PARENT:NOTES:LIFE", process number and file descriptors
constexpr const char* mark_left_out = "PMREPORT_WORKER_LEFT_OUT";
constexpr const char* mark_many = "PMREPORT_WORKER_OF_MANY";  // the process that makes several reports
constexpr char between = '\x1e';                              // two libraries
constexpr std::chrono::seconds grace{5};                      // between the end of the parent and the end by force

// Of a worker: its parent, and the pipe that closes when that ends.
pid_t parent_of_worker = -1;
int life_of_parent = -1;

void tell_loading(const std::filesystem::path& file, bool begins) {
  if (!begins) name_plugin(file.c_str());
  say(begins ? Note::loading : Note::loaded, file.c_str());
}

constexpr document::LeftBehindWatch tell_left_behind{
    [](document::Left what, const std::filesystem::path& path) { say(static_cast<Note>(what), path.c_str()); },
    [](const std::filesystem::path& path) { say(Note::removed, path.c_str()); },
    [](const std::filesystem::path& folder) { say(Note::standing, folder.c_str()); }};

// Nobody waits for an orphan's report: it is interrupted as by SIGTERM, and where it hangs in a step, it clears away and ends.
void end_with_parent(int life) {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, nullptr);
  pollfd stream{life, 0, 0};  // nothing is ever written: it closes
  while (poll(&stream, 1, -1) <= 0 || (stream.revents & (POLLHUP | POLLERR | POLLNVAL)) == 0) {
  }
  kill(getpid(), SIGTERM);
  std::this_thread::sleep_for(grace);
  document::clear_all_left_behind();
  _exit(128 + SIGTERM);
}

void leave_out(std::string_view all) {
  while (!all.empty()) {
    const std::size_t end = std::min(all.find(between), all.size());
    const std::string_view one = all.substr(0, end);
    if (const std::size_t line = one.find('\n'); line != std::string_view::npos)
      host::leave_out(one.substr(0, line), std::string(one.substr(line + 1)));
    all.remove_prefix(std::min(end + 1, all.size()));
  }
}

}  // namespace

std::string mark_of_many() { return fmt::format("{}={}", mark_many, getpid()); }

void end_with_many() {
  const char* value = std::getenv(mark_many);
  if (value == nullptr || getppid() != std::atoi(value)) return;
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != std::atoi(value)) raise(SIGTERM);
}

std::vector<std::string> marks_of_worker(int notes, int life, const std::vector<std::string>& left_out) {
  return {fmt::format("{}={}:{}:{}", mark, getpid(), notes, life),
          fmt::format("{}={}", mark_left_out, fmt::join(left_out, std::string(1, between)))};
}

bool begin_as_worker() {
  // A worker is one only for the parent that started it: a mark that was inherited further down means nothing.
  const char* value = std::getenv(mark);
  const std::string parent = fmt::format("{}:", getppid());
  if (value == nullptr || !std::string_view(value).starts_with(parent)) return false;
  char* next = nullptr;
  const long notes = std::strtol(value + parent.size(), &next, 10);
  const long life = *next == ':' ? std::strtol(next + 1, nullptr, 10) : -1;
  for (const long d : {notes, life}) fcntl(static_cast<int>(d), F_SETFD, FD_CLOEXEC);

  signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is told by its write
  say_notes_to(static_cast<int>(notes));
  say(Note::begun, "");
  leave_last_words();
  keep_results_apart();
  host::watch_loading(tell_loading);
  document::watch_left_behind(tell_left_behind);
  if (const char* left_out = std::getenv(mark_left_out)) leave_out(left_out);
  parent_of_worker = std::atoi(value);
  life_of_parent = static_cast<int>(life);
  return true;
}

void watch_parent() {
  if (life_of_parent < 0) return;
  try {
    std::thread(end_with_parent, life_of_parent).detach();
  } catch (const std::system_error&) {  // no thread is to be had: then it ends at once, and leaves what it has begun
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent_of_worker) _exit(128 + SIGTERM);
  }
}

void worker_done(int status) {
  keep_silent();
  say(Note::done, fmt::format("{}", status).c_str());
}

}  // namespace pmreport::program
