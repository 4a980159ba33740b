#include <reports/program/worker/last_words.hpp>
#include <reports/program/worker/notes.hpp>
#include <reports/program/worker/worker.hpp>

#include <dlfcn.h>
#include <execinfo.h>
#include <signal.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>

namespace pmreport::program {

namespace {

constexpr int deepest = 64;             // frames that are looked at, innermost first
constexpr unsigned longest_search = 3;  // [s]: a stack that is in ruins must not keep the process
constexpr std::size_t most_plugins = 256;

// Where each plugin's code begins: what the handler compares, without a lock or an allocation.
std::array<std::atomic<const void*>, most_plugins> plugins;
std::atomic<std::size_t> plugin_count{0};
const void* own_code = nullptr;
std::atomic<bool> silent{false};

const void* base_of(const void* address, const char** file = nullptr) {
  Dl_info info{};
  if (dladdr(address, &info) == 0) return nullptr;
  if (file != nullptr) *file = info.dli_fname;
  return info.dli_fbase;
}

bool is_plugin(const void* base) {
  for (std::size_t i = 0; i < std::min(plugin_count.load(), most_plugins); ++i)
    if (plugins[i] == base) return true;
  return false;
}

// What every crash has on its stack says nothing about it.
bool is_of_every_crash(const char* file) {
  const std::string_view name = std::strrchr(file, '/') != nullptr ? std::strrchr(file, '/') + 1 : file;
  for (const std::string_view common : {"libc.so", "libpthread.so", "libstdc++.so", "libgcc_s.so", "ld-linux", "linux-vdso", "libm.so"})
    if (name.starts_with(common)) return true;
  return false;
}

void blame_the_stack() {
  if (silent) return;
  alarm(longest_search);
  void* frames[deepest];
  const int count = backtrace(frames, deepest);
  const char* library = nullptr;
  for (int i = 0; i < count; ++i) {
    const char* file = nullptr;
    const void* base = base_of(frames[i], &file);
    if (base == nullptr || file == nullptr) continue;
    if (is_plugin(base)) return say(Note::in_plugin, file);
    if (library == nullptr && base != own_code && !is_of_every_crash(file)) library = file;
  }
  say(Note::in_library, library != nullptr ? library : "");
}

void on_crash(int signal) {
  const char number[] = {static_cast<char>('0' + signal / 10), static_cast<char>('0' + signal % 10), '\0'};
  if (!silent) say(Note::signal, number);  // first: the search may not come to an end
  blame_the_stack();
  raise(signal);  // its own action is back: the process ends as if nobody had looked
}

void on_exit() {
  blame_the_stack();
  alarm(0);
}

[[noreturn]] void on_terminate() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    say(Note::no_memory, "");
    _exit(worker_limited);
  } catch (...) {
  }
  std::abort();
}

}  // namespace

void name_plugin(const char* file) {
  void* handle = dlopen(file, RTLD_NOW | RTLD_NOLOAD);
  if (handle == nullptr) return;
  const void* symbol = dlsym(handle, "pm_plugin");
  const void* base = symbol != nullptr ? base_of(symbol) : nullptr;
  dlclose(handle);
  if (base == nullptr || is_plugin(base)) return;
  const std::size_t at = plugin_count++;
  if (at < most_plugins) plugins[at] = base;
}

void keep_silent() { silent = true; }

void leave_last_words() {
  own_code = base_of(reinterpret_cast<const void*>(&leave_last_words));
  void* first[1];
  backtrace(first, 1);  // loads what it needs now, not in the midst of a crash
  std::set_terminate(on_terminate);
  std::atexit(on_exit);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which tell crashes themselves, and better
  // A stack that is used up has no room for its own handler. Of other threads than this one such an end is told without a name.
  static std::array<char, 64 * 1024> room;
  stack_t other{};
  other.ss_sp = room.data();
  other.ss_size = room.size();
  sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_handler = on_crash;
  action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND | SA_NODEFER);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS}) sigaction(signal, &action, nullptr);
#endif
}

}  // namespace pmreport::program
