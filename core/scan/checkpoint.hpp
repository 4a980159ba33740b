// What is done of a long scan, on disk: a run that was killed goes on where it was.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace pmreport::scan {

// A checkpoint of another scan, or damaged, or one that cannot be written. The sentence says which and what to do.
struct CheckpointError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct CheckpointNotKept : CheckpointError {  // it cannot be written
  using CheckpointError::CheckpointError;
};

struct Checkpoint {
  std::filesystem::path file;
  bool resume = false;     // go on with what the file has, if there is one; else it is begun anew
  std::uint64_t scan = 0;  // tells scans apart: a hash of all that decides the counts
};

}  // namespace pmreport::scan
