#include <reports/program/terminal.hpp>

#include <fcntl.h>
#include <unistd.h>
#include <cstdlib>
#include <string_view>

namespace pmreport::program {

namespace {

std::FILE* apart = nullptr;
bool told_by_others = false;

}  // namespace

void tell_text(const std::string& text) {
  if (!told_by_others) std::fputs(text.c_str(), stderr);
}

void leave_telling_to_others(bool leave) {
  told_by_others = leave;
  if (leave) apart = std::fopen("/dev/null", "w");
}

std::FILE* results() { return apart != nullptr ? apart : stdout; }

void keep_results_apart() {
  const int copy = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (copy < 0) return;
  apart = fdopen(copy, "w");
  if (apart != nullptr) dup2(STDERR_FILENO, STDOUT_FILENO);
}

Terminal::Terminal(bool quiet) {
  const char* term = std::getenv("TERM");
  live_ = !quiet && isatty(STDERR_FILENO) != 0 && std::getenv("CI") == nullptr && (term == nullptr || std::string_view(term) != "dumb");
}

void Terminal::say(const std::string& what) {
  if (live_) tell("\r\x1b[K{}", what), std::fflush(stderr), used_ = true;
}

void Terminal::clear() {
  if (used_) tell("\r\x1b[K"), std::fflush(stderr), used_ = false;
}

}  // namespace pmreport::program
