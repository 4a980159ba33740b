#include <core/scan/tally.hpp>

namespace pmreport::scan {

Tally& Tally::operator+=(const Tally& more) {
  poses += more.poses;
  accepted += more.accepted;
  on_a_limit += more.on_a_limit;
  if (first.empty()) {
    first = more.first, any = more.any;
    return *this;
  }
  for (std::size_t m = 0; m < more.first.size(); ++m) first[m] += more.first[m], any[m] += more.any[m];
  return *this;
}

void put(chunks::Writer& to, const Tally& tally) {
  for (const std::uint64_t n : {tally.poses, tally.accepted, tally.on_a_limit}) to.put(n);
  to.put(tally.first);
  to.put(tally.any);
}

void get(chunks::Reader& from, Tally& tally) {
  const std::size_t margins = tally.first.size();
  for (std::uint64_t* n : {&tally.poses, &tally.accepted, &tally.on_a_limit}) from.get(*n);
  from.get(tally.first);
  from.get(tally.any);
  if (tally.first.size() != margins || tally.any.size() != margins) throw chunks::NotReadable();
}

}  // namespace pmreport::scan
