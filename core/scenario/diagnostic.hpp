// What is wrong with a scenario, as its user is told.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace pmreport::scenario {

struct Diagnostic {
  std::string file;
  int line = 0, column = 0;  // 1-based; 0: the file as a whole
  std::string message;       // expected and seen, "did you mean"
  std::string source_line;   // the text of the line, for the caret
  std::string hint;          // what to do; may be empty
};
// "file:line:col: error: message", the source line, a caret, "hint: ...". Plain text, no colour.
std::string to_string(const Diagnostic& d);

class ScenarioError : public std::runtime_error {
 public:
  explicit ScenarioError(std::vector<Diagnostic> d);
  std::vector<Diagnostic> diagnostics;  // in the order of the file, at least one
};

}  // namespace pmreport::scenario
