#include <core/scan/components.hpp>
#include <core/scan/neighbours.hpp>

#include <algorithm>
#include <functional>

namespace pmreport::scan {

Components components(const std::vector<std::size_t>& counts, const std::vector<std::uint32_t>& accepted_at, std::uint32_t need) {
  const Neighbours grid(counts);
  std::vector<bool> seen(accepted_at.size());
  Components out;
  for (std::size_t start = 0; start < seen.size(); ++start) {
    if (seen[start]) continue;
    const bool accepted = accepted_at[start] >= need;
    bool at_the_rim = false;
    const std::uint64_t points = grid.flood(
        start, seen, [&](std::size_t n) { return (accepted_at[n] >= need) == accepted; },
        [&](bool rim) { at_the_rim = at_the_rim || rim; });
    if (accepted)
      out.parts.push_back(points);
    else if (!at_the_rim)
      out.holes.push_back(points);
  }
  std::ranges::sort(out.parts, std::greater());
  std::ranges::sort(out.holes, std::greater());
  return out;
}

}  // namespace pmreport::scan
