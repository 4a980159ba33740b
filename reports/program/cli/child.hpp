// The program, run once more by itself.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pmreport::program {

struct ChildResult {
  int status = 0;    // exit status; 128 and the number of the signal that ended it
  std::string told;  // what it wrote on stderr, the first of it
};

// With these arguments. What it writes is handed on as it comes, after a call of `before_words`. `stop`: asked when a signal came: the
// child is ended then, and document::Interrupted thrown. Throws std::system_error where no process can be started.
ChildResult run_again(const std::vector<std::string>& arguments, bool (*stop)(), const std::function<void()>& before_words);

}  // namespace pmreport::program
