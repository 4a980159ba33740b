// Which poses are accepted, a bit each.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace pmreport::scan {

// Words that several threads may mark at once, the lowest bit of a word first; none: nothing is marked.
struct PoseBits {
  std::uint64_t* accepted = nullptr;
  std::uint64_t* positive = nullptr;  // both or neither
  std::uint64_t* negative = nullptr;

  static void mark(std::uint64_t* words, std::size_t pose) {
    std::atomic_ref(words[pose / 64]).fetch_or(std::uint64_t{1} << pose % 64, std::memory_order_relaxed);
  }
};

// Marks from bit `at` on what is marked in `from` from bit `first` on, `count` bits of it.
inline void copy_marks(std::uint64_t* to, std::size_t at, const std::uint64_t* from, std::size_t first, std::size_t count) {
  while (count > 0) {
    const std::size_t n = std::min(count, 64 - first % 64), shift = at % 64;
    const std::uint64_t word = from[first / 64] >> first % 64 & ~std::uint64_t{0} >> (64 - n);
    if (word != 0) {
      to[at / 64] |= word << shift;
      if (shift + n > 64) to[at / 64 + 1] |= word >> (64 - shift);
    }
    at += n, first += n, count -= n;
  }
}

}  // namespace pmreport::scan
