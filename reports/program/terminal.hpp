// Words for whoever started the program: results on standard output, all else on standard error.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace pmreport::program {

// Where nobody can be told the exit status still speaks.
void tell_text(const std::string& text);
template <class... T>
void tell(fmt::format_string<T...> format, T&&... values) {
  tell_text(fmt::format(format, std::forward<T>(values)...));
}
// Of one of several processes with the same arguments, all of which would find the same mistakes in them.
void leave_telling_to_others(bool leave);

// Where results go: standard output. Once they are kept apart, whatever else writes there, as a plugin may, writes to standard error.
std::FILE* results();
void keep_results_apart();
template <class... T>
void put(fmt::format_string<T...> format, T&&... values) {
  fmt::print(results(), format, std::forward<T>(values)...);
}

// One line on a terminal, overwritten; nothing in a pipe or a log.
class Terminal {
 public:
  explicit Terminal(bool quiet);
  ~Terminal() { clear(); }
  void say(const std::string& what);
  void clear();

 private:
  bool live_ = false, used_ = false;
};

}  // namespace pmreport::program
