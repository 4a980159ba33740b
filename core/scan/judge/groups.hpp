// The orientations of a scan, some thousands of them at a time.
#pragma once

#include <core/scan/judge/orientations.hpp>

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace pmreport::scan {

// Groups of neighbours in the list, all of one size but the last. Prepared when they are asked for; those who ask for the same one share
// it, and the last few stay, since chunks of work that follow one another need the same.
class Groups {
 public:
  explicit Groups(const Plan& plan) : plan_(plan) {}

  static constexpr std::size_t most = 4096;  // orientations of a group

  std::size_t size() const { return (plan_.scan.orientation_count() + most - 1) / most; }
  std::size_t first(std::size_t group) const { return group * most; }  // of its orientations
  // Asked by several threads at once.
  std::shared_ptr<const Orientations> at(std::size_t group);

 private:
  struct Prepared;

  const Plan& plan_;
  std::mutex mutex_;
  std::vector<std::pair<std::size_t, std::shared_ptr<Prepared>>> last_;  // the last one asked for first
};

}  // namespace pmreport::scan
