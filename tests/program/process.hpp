// A program run from outside, as a user's shell would.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace program_test {

struct Result {
  int status;            // exit status; minus the number of the signal that ended it
  std::string out, err;  // all that it wrote
};

struct Surroundings {
  std::map<std::string, std::string> environment{};  // added to that of the test, without what steers pmreport; empty: not set
  std::filesystem::path folder{};                    // working directory; empty: that of the test
  bool terminal = false;                             // stderr is a terminal
  std::optional<std::filesystem::path> out{};        // stdout goes to this file
  bool no_out = false, no_err = false;               // stdout, stderr closed from the start
};

class Process {
 public:
  explicit Process(const std::vector<std::string>& command, const Surroundings& surroundings = {});
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();  // kills what still runs

  bool says(std::string_view text);  // waits until stderr holds `text`; false when the process ends without
  void send(int signal);
  Result finish();

 private:
  bool read_some();  // false at the end of both streams

  pid_t id_ = -1;
  int out_ = -1, err_ = -1;
  Result result_{0, "", ""};
};

Result run(const std::vector<std::string>& command, const Surroundings& surroundings = {});
Result run_pmreport(std::vector<std::string> arguments, const Surroundings& surroundings = {});

}  // namespace program_test
