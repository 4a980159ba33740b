// --sandbox: what a worker can no longer do, whatever a plugin tries: write outside of a few folders, reach a network or another process,
// run a program. The kernel holds it to that (Landlock for files, a seccomp filter for all else), until it ends.
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace pmreport::program {

// What is missing. Nothing then runs: a sandbox that does not hold would be worse than none.
struct SandboxError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Of every path the folder in which it is made or replaced; where that is missing too, the nearest that is there. Links are followed. Each
// once, sorted.
std::vector<std::filesystem::path> folders_that_hold(const std::vector<std::filesystem::path>& paths);

// Whether something may be made, or removed, at a path by whoever may write these folders alone.
bool within(std::span<const std::filesystem::path> folders, const std::filesystem::path& path);

// This process, from here on; files that are open stay so. It must have no thread but this one, for others would stay free. Throws
// SandboxError.
void confine(std::span<const std::filesystem::path> writable);

}  // namespace pmreport::program
