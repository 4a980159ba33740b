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

}  // namespace pmreport::scan
