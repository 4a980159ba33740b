// Simbody 3.7 under C++20. Its index types compare with every kind of integer by member functions, and turn into int. Since C++20 also
// tries the operands of == in reverse, comparing two indices of one type is ambiguous; an exact match settles it. What its matrices do
// with rows and columns as overlays of one memory makes GCC 12 suspect accesses out of bounds.
#pragma once

#include <type_traits>

namespace SimTK {
template <class Index>
requires std::is_convertible_v<Index, int> && requires(const Index& i) { i.isValidExtended(); }
bool operator==(const Index& a, const Index& b) { return int(a) == int(b); }
}  // namespace SimTK

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Warray-bounds"
#include <Simbody.h>
#pragma GCC diagnostic pop
