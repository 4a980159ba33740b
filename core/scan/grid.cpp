#include <core/scan/grid.hpp>

#include <core/scan/checkpoint_file.hpp>
#include <core/scan/grid_size.hpp>
#include <core/scan/judge/walk.hpp>
#include <core/scan/pace.hpp>

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace pmreport::scan {

namespace {

constexpr std::size_t group = 4096;                // orientations that are prepared at a time
constexpr std::uint64_t most_of_a_tile = 1 << 21;  // poses, and no fewer points than are worth it
constexpr std::size_t fewest_points = 512;
constexpr std::size_t most_at_once = 1024;  // walks between two looks at the watch
constexpr double between_looks = 0.1;       // [s]

// A count in equal steps: all tiles at one group of orientations after the other. Its numbers are sums of whole numbers, so the order in
// which walks end does not matter.
class Count {
 public:
  Count(const PoseSet& set, const Scan& scan, const GridOptions& options)
      : scan_(scan),
        plan_(set, scan, options.reasons, options.sign),
        tiling_(scan, points_of_a_tile(scan)),
        groups_((scan.orientation_count() + group - 1) / group),
        walks_([this, prune = options.prune] { return Walk(plan_, prune, bits()); }) {
    out_.tally = empty_tally(set.size(), options.reasons);
    out_.accepted_at.resize(scan.point_count());
    if (set.late.every > 0) out_.by_others_at.resize(scan.point_count());
    const std::size_t words = options.keep_poses ? (poses_of(scan) + 63) / 64 : 0;
    out_.accepted_poses.resize(words);
    if (options.sign != nullptr) out_.positive_poses.resize(words), out_.negative_poses.resize(words);
  }

  std::size_t steps() const { return groups_ * tiling_.size(); }
  std::size_t done() const { return done_; }
  // All that it needs to go on, between two steps.
  ScanState state() {
    ScanState out;
    const auto add_number = [&](std::uint64_t& n) { out.push_back(std::as_writable_bytes(std::span(&n, 1))); };
    for (std::uint64_t* n : {&done_, &out_.tally.poses, &out_.tally.accepted, &out_.tally.on_a_limit, &out_.positive, &out_.negative})
      add_number(*n);
    for (auto* numbers : {&out_.tally.first, &out_.tally.any, &out_.accepted_poses, &out_.positive_poses, &out_.negative_poses})
      add_to(out, *numbers);
    for (auto* counts : {&out_.accepted_at, &out_.by_others_at}) add_to(out, *counts);
    return out;
  }
  // Of what decides the meaning of the state.
  std::uint64_t form() const {
    std::uint64_t h = 1;  // of the order of steps and of the numbers
    for (const std::uint64_t x :
         {std::uint64_t{steps()}, std::uint64_t{tiling_.size()}, poses_of(scan_), std::uint64_t{plan_.set.size()},
          std::uint64_t{plan_.reasons}, std::uint64_t{!out_.accepted_poses.empty()}, std::uint64_t{!plan_.sign.outputs().empty()}})
      h = (h ^ x) * 0x9E3779B97F4A7C15u + 1;
    return h;
  }
  GridCounts& counts() { return out_; }

  // Steps from where it stands, of one group, for about as long as there is between two looks.
  void go_on() {
    const std::size_t g = done_ / tiling_.size(), first = done_ % tiling_.size();
    if (!orientations_ || prepared_ != g) prepare(g);
    const std::size_t last =
        std::min({tiling_.size(), first + pace_.steps(), first + std::max<std::size_t>(1, most_at_once / parts_.size())});
    found_.resize((last - first) * parts_.size());
    tiles_.resize(last - first);
    for (std::size_t t = first; t < last; ++t) tiles_[t - first] = tiling_.tile(t);
    pace_.run([&] {
      tbb::parallel_for(std::size_t{0}, found_.size(), [&](std::size_t k) {
        found_[k] = walks_.local().run(tiles_[k / parts_.size()], *orientations_, parts_[k % parts_.size()]);
      });
    });
    for (std::size_t k = 0; k < found_.size(); ++k) add(tiles_[k / parts_.size()], found_[k]);
    done_ += last - first;
  }

 private:
  PoseBits bits() {
    const auto words = [](std::vector<std::uint64_t>& v) { return v.empty() ? nullptr : v.data(); };
    return {words(out_.accepted_poses), words(out_.positive_poses), words(out_.negative_poses)};
  }
  static std::size_t points_of_a_tile(const Scan& scan) {
    // A small grid in some hundred tiles, so that no thread waits long for another.
    const std::uint64_t most = std::clamp<std::uint64_t>(poses_of(scan) / 256, group, most_of_a_tile);
    return std::max<std::size_t>(fewest_points, most / std::min(group, scan.orientation_count()));
  }

  void prepare(std::size_t g) {
    const std::size_t first = g * group;
    orientations_ = std::make_unique<Orientations>(plan_, first, std::min(group, scan_.orientation_count() - first));
    prepared_ = g;
    parts_.clear();
    part(0, std::max<std::uint64_t>(1, std::clamp<std::uint64_t>(poses_of(scan_) / 256, group, most_of_a_tile) / tiling_.tile(0).size()));
  }
  // Parts of the group of no more than so many orientations.
  void part(int node, std::uint64_t most) {
    const Orientations::Node& n = orientations_->node(node);
    if (n.end - n.begin <= most || n.children == 0) {
      parts_.push_back(node);
      return;
    }
    part(n.children, most);
    part(n.children + 1, most);
  }

  void add(const Tile& tile, const Found& found) {
    out_.tally += found.tally;
    out_.positive += found.positive;
    out_.negative += found.negative;
    each_point(tile, [&](std::size_t k, std::span<const std::size_t> at) {
      std::size_t number = 0;
      for (std::size_t a = 0; a < at.size(); ++a) number = number * scan_.points[a].count + at[a];
      out_.accepted_at[number] += found.accepted[k];
      if (!found.by_others.empty()) out_.by_others_at[number] += found.by_others[k];
    });
  }

  const Scan& scan_;
  const Plan plan_;
  const Tiling tiling_;
  const std::size_t groups_;
  Pace pace_;
  std::uint64_t done_ = 0;
  std::size_t prepared_ = 0;
  std::unique_ptr<Orientations> orientations_;
  std::vector<int> parts_;
  std::vector<Tile> tiles_;
  std::vector<Found> found_;
  tbb::enumerable_thread_specific<Walk> walks_;
  GridCounts out_;
};

// A point at which an orientation keeps all other margins and not those that must hold at every one has none that is accepted.
void demand_every(GridCounts& counts) {
  for (std::size_t k = 0; k < counts.by_others_at.size(); ++k)
    if (counts.accepted_at[k] < counts.by_others_at[k]) counts.accepted_at[k] = 0;
}

// Ends and centre of the accepted poses on each axis, from how many are accepted at each of its values: whole numbers, whose order does not
// matter.
void place_ends(const Scan& scan, GridCounts& counts) {
  const auto accepted = std::accumulate(counts.accepted_at.begin(), counts.accepted_at.end(), std::uint64_t{0});
  if (accepted == 0) return;
  std::vector<std::vector<std::uint64_t>> at;
  for (const Axis& a : scan.points) at.emplace_back(a.count, 0);
  Tile whole{std::vector<std::size_t>(scan.points.size(), 0), {}};
  for (const Axis& a : scan.points) whole.end.push_back(a.count);
  each_point(whole, [&](std::size_t k, std::span<const std::size_t> places) {
    if (counts.accepted_at[k] == 0) return;
    for (std::size_t a = 0; a < at.size(); ++a) at[a][places[a]] += counts.accepted_at[k];
  });
  for (std::size_t a = 0; a < at.size(); ++a) {
    const auto some = [](std::uint64_t n) { return n > 0; };
    const auto first = static_cast<std::size_t>(std::ranges::find_if(at[a], some) - at[a].begin());
    const auto last = at[a].size() - 1 - static_cast<std::size_t>(std::find_if(at[a].rbegin(), at[a].rend(), some) - at[a].rbegin());
    const Axis& axis = scan.points[a];
    counts.low.push_back(std::min(axis.value(first), axis.value(last)));
    counts.high.push_back(std::max(axis.value(first), axis.value(last)));
    double sum = 0;
    for (std::size_t k = first; k <= last; ++k) sum += static_cast<double>(at[a][k]) * axis.value(k);
    counts.centroid.push_back(sum / static_cast<double>(accepted));
  }
}

}  // namespace

GridCounts count_grid(const PoseSet& set, const Scan& scan, const GridOptions& options, const Watch& watch) try {
  poses_of(scan);
  Count count(set, scan, options);
  std::optional<CheckpointFile> file;
  if (options.checkpoint) file.emplace(*options.checkpoint, count.form());
  if (file) file->load(count.state());
  bool kept = true;
  try {
    while (count.done() < count.steps()) {
      watch.stop_if_asked();
      count.go_on();
      kept = false;
      watch.done(static_cast<double>(count.done()) / static_cast<double>(count.steps()));
      if (file && file->due()) file->save(count.state()), kept = true;
    }
  } catch (const CheckpointError&) {
    throw;
  } catch (...) {
    if (file && !kept) file->save(count.state());
    throw;
  }
  demand_every(count.counts());
  place_ends(scan, count.counts());
  return std::move(count.counts());
} catch (const std::bad_alloc&) {
  throw std::length_error(
      fmt::format("the counts of this grid need {} MiB of memory, which cannot be had; take fewer points, or do not keep "
                  "which poses are accepted",
                  memory_needed(set, scan, options) / (1024 * 1024)));
}

}  // namespace pmreport::scan
