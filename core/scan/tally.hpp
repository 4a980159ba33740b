// What is counted of poses that were judged.
#pragma once

#include <core/chunks/bytes.hpp>

#include <cstdint>
#include <vector>

namespace pmreport::scan {

struct Tally {
  std::uint64_t poses = 0, accepted = 0;
  std::uint64_t on_a_limit = 0;  // accepted by a margin that rounding decides
  std::vector<std::uint64_t> first,
      any;  // one a margin: poses that it refuses first; that it refuses, whatever else does. Without reasons: empty

  Tally& operator+=(const Tally& more);
};

// As part of a chunk's answers. What is got has as many margins as there are before, else NotReadable is thrown.
void put(chunks::Writer& to, const Tally& tally);
void get(chunks::Reader& from, Tally& tally);

}  // namespace pmreport::scan
