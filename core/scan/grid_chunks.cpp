#include <core/scan/grid_chunks.hpp>

#include <core/scan/grid_size.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>

namespace pmreport::scan {

namespace {

constexpr std::size_t most_at_once = 1024;                 // walks whose answers are in memory
constexpr std::uint64_t most_points_at_once = 1ull << 21;  // and their points, but those of one tile

// Late margins cost hundreds of times what others do.
std::uint64_t cost(const PoseSet& set) { return set.late.size > 0 ? 8 : 1; }

// A long scan has some hundred to some thousand chunks, each of which is done in seconds, and worth a file.
std::uint64_t poses_of_a_chunk(const PoseSet& set, const Scan& scan) {
  constexpr std::uint64_t fewest = 1ull << 19, most = 1ull << 24;
  return std::clamp(poses_of(scan) / 256, fewest, most) / cost(set);
}

// A small grid has some hundred tiles, so that no thread waits long for another; but the larger a tile is, the more of it intervals decide
// at once.
std::uint64_t poses_of_a_tile(const PoseSet& set, const Scan& scan) {
  constexpr std::uint64_t fewest = 4096, most = 1ull << 21;
  return std::clamp(poses_of(scan) / 256 / cost(set), fewest, most);
}

// Fewer do not pay for what each orientation costs beside them.
std::size_t points_of_a_tile(const PoseSet& set, const Scan& scan, std::uint64_t poses) {
  const std::uint64_t fewest = 512 / cost(set);
  return std::max(fewest, poses / std::min(Groups::most, scan.orientation_count()));
}

}  // namespace

GridChunks::GridChunks(const PoseSet& set, const Scan& scan, const GridOptions& options, std::function<void()> stop_if_asked)
    : scan_(scan),
      plan_(set, scan, options.reasons, options.sign),
      poses_of_a_tile_(poses_of_a_tile(set, scan)),
      tiling_(scan, points_of_a_tile(set, scan, poses_of_a_tile_)),
      groups_(plan_),
      walks_([this, prune = options.prune, stop = std::move(stop_if_asked)] { return Walk(plan_, prune, stop); }) {
  const std::uint64_t of_a_step = tiling_.tile(0).size() * std::min(Groups::most, scan.orientation_count());
  steps_of_a_chunk_ = std::max<std::uint64_t>(1, poses_of_a_chunk(set, scan) / of_a_step);
  out_.tally = empty_tally(set.size(), options.reasons);
  out_.accepted_at.resize(scan.point_count());
  if (set.late.every > 0) out_.by_others_at.resize(scan.point_count());
  const std::size_t words = options.keep_poses ? (poses_of(scan) + 63) / 64 : 0;
  out_.accepted_poses.resize(words);
  if (options.sign != nullptr) out_.positive_poses.resize(words), out_.negative_poses.resize(words);
}

std::uint64_t GridChunks::form() const {
  chunks::Meaning m;
  m << std::uint64_t{1}  // of the order itself
    << steps_of_a_chunk_ << tiling_.size() << tiling_.tile(0).size() << Groups::most << plan_.reasons << !out_.by_others_at.empty()
    << !out_.accepted_poses.empty() << !out_.positive_poses.empty();
  return m.value();
}

std::vector<GridChunks::Tiles> GridChunks::tiles_of(std::size_t chunk) const {
  std::vector<Tiles> out;
  const std::size_t end = std::min(steps(), (chunk + 1) * steps_of_a_chunk_);
  for (std::size_t step = chunk * steps_of_a_chunk_; step < end;) {
    const std::size_t group = step / tiling_.size(), first = step % tiling_.size(), n = std::min(end - step, tiling_.size() - first);
    out.push_back({group, first, first + n});
    step += n;
  }
  return out;
}

// In turn the tiles of each group, and of each tile its counts and its bits, if any is set; then what all of them come to.
chunks::Bytes GridChunks::compute(std::size_t chunk) {
  chunks::Writer out;
  Found sums;
  sums.tally = empty_tally(plan_.set.size(), plan_.reasons);
  for (const Tiles& tiles : tiles_of(chunk)) {
    const auto orientations = groups_.at(tiles.group);
    const std::size_t points = tiling_.tile(0).size();
    const std::vector<int> parts = orientations->parts(std::max<std::uint64_t>(1, poses_of_a_tile_ / points));
    const std::size_t at_once = std::max<std::size_t>(1, std::min(most_at_once, most_points_at_once / points) / parts.size());
    for (std::size_t t = tiles.first; t < tiles.end; t += at_once)
      count({tiles.group, t, std::min(tiles.end, t + at_once)}, *orientations, parts, sums, out);
  }
  put(out, sums.tally);
  out.put(sums.positive);
  out.put(sums.negative);
  return out.take();
}

void GridChunks::count(const Tiles& tiles, const Orientations& orientations, std::span<const int> parts, Found& sums, chunks::Writer& out) {
  struct Counted {
    Tile tile;
    std::vector<Found> found;  // of each part
    std::vector<std::uint64_t> accepted, positive, negative;
    PoseBits bits;
  };
  std::vector<Counted> counted(tiles.end - tiles.first);
  const bool kept = !out_.accepted_poses.empty(), signs = !out_.positive_poses.empty();
  for (std::size_t k = 0; k < counted.size(); ++k) {
    Counted& c = counted[k];
    c.tile = tiling_.tile(tiles.first + k);
    c.found.resize(parts.size());
    const std::size_t words = kept ? (c.tile.size() * orientations.size() + 63) / 64 : 0;
    c.accepted.resize(words);
    if (signs) c.positive.resize(words), c.negative.resize(words);
    if (kept) c.bits = {c.accepted.data(), c.positive.data(), c.negative.data()};
  }
  tbb::parallel_for(std::size_t{0}, counted.size() * parts.size(), [&](std::size_t k) {
    Counted& c = counted[k / parts.size()];
    const std::size_t part = k % parts.size();
    c.found[part] = walks_.local().run(c.tile, orientations, parts[part], c.bits);
  });
  const auto put_runs = [&](const auto& numbers) { out.put_runs(std::span(numbers)); };
  const auto put_bits = [&](const auto& words, std::uint64_t marked) {
    if (words.empty()) return;
    out.put(marked > 0);
    if (marked > 0) put_runs(words);
  };
  for (Counted& c : counted) {
    Found& whole = c.found.front();
    for (std::size_t part = 1; part < c.found.size(); ++part) whole += c.found[part];
    put_runs(whole.accepted);
    put_runs(whole.by_others);
    put_bits(c.accepted, whole.tally.accepted);
    put_bits(c.positive, whole.positive);
    put_bits(c.negative, whole.negative);
    sums.tally += whole.tally;
    sums.positive += whole.positive;
    sums.negative += whole.negative;
  }
}

void GridChunks::take(std::size_t chunk, std::span<const std::byte> answers) {
  chunks::Reader in(answers);
  for (const Tiles& tiles : tiles_of(chunk))
    for (std::size_t t = tiles.first; t < tiles.end; ++t) {
      const Tile tile = tiling_.tile(t);
      for (auto* counts : {&out_.accepted_at, &out_.by_others_at}) add_counts(tile, in, *counts);
      for (auto* bits : {&out_.accepted_poses, &out_.positive_poses, &out_.negative_poses}) add_bits(tile, tiles.group, in, *bits);
    }
  Found sums;
  sums.tally = empty_tally(plan_.set.size(), plan_.reasons);
  get(in, sums.tally);
  in.get(sums.positive);
  in.get(sums.negative);
  in.end();
  out_.tally += sums.tally;
  out_.positive += sums.positive;
  out_.negative += sums.negative;
}

void GridChunks::add_counts(const Tile& tile, chunks::Reader& in, std::vector<std::uint32_t>& to) {
  if (to.empty()) return;
  counts_of_tile_.resize(tile.size());
  in.get_runs(std::span(counts_of_tile_));
  each_row(tile, Tile::whole(scan_), [&](std::size_t k, std::size_t number, std::size_t length) {
    for (std::size_t i = 0; i < length; ++i) to[number + i] += counts_of_tile_[k + i];
  });
}

// Of a point the orientations of a group stand together; where that is all of them, so do the points of a row.
void GridChunks::add_bits(const Tile& tile, std::size_t group, chunks::Reader& in, std::vector<std::uint64_t>& to) {
  if (to.empty()) return;
  bool any = false;
  in.get(any);
  if (!any) return;
  const std::size_t orientations = scan_.orientation_count(), first = groups_.first(group);
  const std::size_t n = std::min(Groups::most, orientations - first);
  bits_of_tile_.resize((tile.size() * n + 63) / 64);
  in.get_runs(std::span(bits_of_tile_));
  each_row(tile, Tile::whole(scan_), [&](std::size_t k, std::size_t number, std::size_t length) {
    const std::size_t together = n == orientations ? length : 1;
    for (std::size_t i = 0; i < length; i += together)
      copy_marks(to.data(), (number + i) * orientations + first, bits_of_tile_.data(), (k + i) * n, together * n);
  });
}

}  // namespace pmreport::scan
