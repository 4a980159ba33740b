// How much memory a report may take.
#pragma once

#include <reports/section/memory_need.hpp>

#include <optional>
#include <stdexcept>
#include <string>

namespace pmreport::program {

// More is asked for than there is: the sentence has the estimate, and what takes how much of it.
struct TooLarge : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// "4 GB", "500MB", "2 GiB" [bytes]; nothing: it is none.
std::optional<double> size_of(const std::string& text);

// What this process may still get [bytes]: by the machine, the group of processes it belongs to (cgroups, as of a container or a job) and
// its own limits (`ulimit -v`); with the word of which of them is the least.
struct Available {
  double bytes;
  std::string by;
};
Available available_memory();

// Throws TooLarge. `most` [bytes]; none: nine tenths of what is available.
void require_memory(const section::MemoryNeed& need, const std::optional<double>& most);

}  // namespace pmreport::program
