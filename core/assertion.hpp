// What the program promises itself. A broken promise is an error of ours, not of the user's or a plugin's: it ends the run with the place
// and the sentence instead of with numbers that were never computed. On in every build: each stands where a call costs a thousand times as
// much, at the doors of the analyses and never inside a loop over lanes or numbers.
#pragma once

#include <stdexcept>
#include <string>

namespace pmreport {

struct AssertionFailed : std::logic_error {
  using std::logic_error::logic_error;
};

[[noreturn, gnu::cold, gnu::noinline]] inline void assertion_failed(const char* file, int line, const char* sentence) {
  throw AssertionFailed(std::string("a promise of the program is broken at ") + file + ":" + std::to_string(line) + ": " + sentence);
}

}  // namespace pmreport

// `sentence`: what always holds, "the state is that of an assembled pose".
#define PMREPORT_ASSERT(condition, sentence) \
  ((condition) ? static_cast<void>(0) : ::pmreport::assertion_failed(__FILE__, __LINE__, sentence))
