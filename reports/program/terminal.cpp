#include <reports/program/terminal.hpp>

#include <unistd.h>
#include <cstdlib>
#include <string_view>

namespace pmreport::program {

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
