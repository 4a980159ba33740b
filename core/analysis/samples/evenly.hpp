// As many of a list as are wanted, spread evenly, its ends left out.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pmreport::analysis {

template <class T>
std::vector<T> evenly(const std::vector<T>& of, std::size_t wanted) {
  const std::size_t n = of.size(), count = std::min(n, wanted);
  std::vector<T> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(of[(2 * i + 1) * n / (2 * count)]);
  return out;
}

// How many of them are before `end` in a list of n: a part of the list knows its share by itself.
inline std::size_t evenly_before(std::size_t end, std::size_t n, std::size_t wanted) {
  const std::size_t count = std::min(n, wanted);
  std::size_t out = 0;
  while (out < count && (2 * out + 1) * n / (2 * count) < end) ++out;
  return out;
}

}  // namespace pmreport::analysis
