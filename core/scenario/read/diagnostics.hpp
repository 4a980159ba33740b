// Collects what is wrong with a file, so that all of it is told in one run.
#pragma once

#include <core/scenario/diagnostic.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::scenario {

struct Place {
  int line = 0, column = 0;  // 1-based, in characters; 0: the file as a whole
};

class Diagnostics {
 public:
  Diagnostics(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

  void add(Place place, std::string message, std::string hint = {});
  // About another file, such as a table that the scenario names.
  void add(Diagnostic diagnostic);
  bool empty() const { return found_.empty() && elsewhere_.empty(); }
  bool full() const { return found_.size() + elsewhere_.size() >= most; }
  void throw_if_any();

  // Where character `offset` (in bytes of the parsed text) of a string value stands in the file; the value's own place when it was written
  // with escapes or over several lines.
  Place inside(Place value, std::string_view parsed, std::size_t offset) const;

  static constexpr std::size_t most = 100;

 private:
  std::string file_;
  std::string_view text_;
  std::vector<Diagnostic> found_, elsewhere_;
};

// Line `number` (1-based) of a text, made printable; empty when it is too long to be shown.
std::string line_of(std::string_view text, int number);

}  // namespace pmreport::scenario
