#include <core/scan/components.hpp>
#include <core/scan/neighbours.hpp>

namespace pmreport::scan {

Sheet sheet_of(const std::vector<std::size_t>& counts, const std::vector<std::size_t>& turned_counts, const GridCounts& kept,
               std::uint64_t start) {
  std::vector<std::size_t> all = counts;
  all.insert(all.end(), turned_counts.begin(), turned_counts.end());
  std::size_t poses = 1;
  for (const std::size_t c : all) poses *= c;
  const auto bit = [](const std::vector<std::uint64_t>& words, std::size_t k) {
    return k / 64 < words.size() && (words[k / 64] >> k % 64 & 1) != 0;
  };
  const auto accepted = [&](std::size_t k) { return bit(kept.accepted_poses, k); };
  Sheet out;
  if (start >= poses || !accepted(start)) return out;
  const Neighbours grid(all);
  const auto nothing = [](bool) {};
  std::vector<bool> seen(poses);
  out.connected = grid.flood(start, seen, accepted, nothing);
  const bool positive = bit(kept.positive_poses, start);
  if (!positive && !bit(kept.negative_poses, start)) return out;
  out.sign = positive ? 1 : -1;
  const std::vector<std::uint64_t>& same = positive ? kept.positive_poses : kept.negative_poses;
  seen.assign(poses, false);
  out.poses = grid.flood(
      start, seen, [&](std::size_t k) { return bit(same, k); }, nothing);
  return out;
}

}  // namespace pmreport::scan
