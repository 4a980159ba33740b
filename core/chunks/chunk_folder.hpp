// What chunks of work have found, on disk, a file each: whole or not there. Any number of processes may keep and read them at once.
#pragma once

#include <core/chunks/bytes.hpp>
#include <core/chunks/work.hpp>

#include <filesystem>
#include <optional>
#include <stdexcept>

namespace pmreport::chunks {

// A folder of chunks that is of no use; the sentence says why, and what to do.
struct ChunkError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct ChunkNotKept : ChunkError {  // one cannot be written
  using ChunkError::ChunkError;
};

class ChunkFolder {
 public:
  // `of_run`: what decides the answers besides the work itself, as a hash.
  ChunkFolder(const std::filesystem::path& folder, std::uint64_t of_run, const Work& work);

  bool has(std::size_t chunk) const;
  // Nothing: there is no such chunk, or (`damaged`) it is not what was written; then it has to be done again. Throws ChunkError where it
  // cannot be read.
  std::optional<Bytes> load(std::size_t chunk, bool& damaged) const;
  // Written beside its place and then put there, so that a kill leaves it or nothing. Throws ChunkNotKept.
  void keep(std::size_t chunk, const Bytes& bytes) const;

 private:
  std::filesystem::path file(std::size_t chunk) const;

  std::filesystem::path folder_;
  std::uint64_t meaning_;
};

}  // namespace pmreport::chunks
