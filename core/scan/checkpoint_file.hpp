// The file of a checkpoint: arrays of numbers whose sizes are known, whole or not at all.
#pragma once

#include <core/scan/checkpoint.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pmreport::scan {

// All that a scan needs to go on, in the memory where it works with it.
using ScanState = std::vector<std::span<std::byte>>;
template <class T>
void add_to(ScanState& state, std::vector<T>& numbers) {
  state.push_back(std::as_writable_bytes(std::span(numbers)));
}

// Written beside the old one and then put in its place, so that a kill leaves the one or the other. Failures are CheckpointErrors.
class CheckpointFile {
 public:
  // `form`: tells apart states of other meaning under the same name of the scan.
  CheckpointFile(const Checkpoint& checkpoint, std::uint64_t form) : checkpoint_(checkpoint), form_(form), saved_(Clock::now()) {}

  // Where it is to be resumed and there is a file: fills the state from it. Where that fails the state is of no use any more.
  bool load(const ScanState& state) const;
  void save(const ScanState& state);
  // When enough was done since the last time: a few seconds, and far more than it takes to write.
  bool due() const { return std::chrono::duration<double>(Clock::now() - saved_).count() > std::max(3.0, 20 * seconds_to_save_); }

 private:
  using Clock = std::chrono::steady_clock;

  const Checkpoint checkpoint_;
  const std::uint64_t form_;
  Clock::time_point saved_;
  double seconds_to_save_ = 0;
};

}  // namespace pmreport::scan
