// All poses of a block of a grid, judged: as one where intervals decide, else by halves, at last pose by pose.
#pragma once

#include <core/program/intervals/boxes.hpp>
#include <core/scan/judge/judge.hpp>
#include <core/scan/judge/orientations.hpp>
#include <core/scan/judge/pose_bits.hpp>
#include <core/scan/judge/tile.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace pmreport::scan {

// What a walk found, and of each point of its tile, the last axis fastest, how many orientations are accepted.
struct Found {
  Tally tally;
  std::vector<std::uint32_t> accepted;
  std::vector<std::uint32_t> by_others;      // accepted but for margins that must hold at every orientation; empty where there are none
  std::uint64_t positive = 0, negative = 0;  // accepted poses by the sign

  Found& operator+=(const Found& more);  // of the same tile
};

// Keeps its buffers: one a thread. The counts are the same with and without pruning: intervals contain what is computed for each pose, and
// a margin is decided by them only where all of it is beyond its rounding.
class Walk {
 public:
  // `stop_if_asked` is asked every few thousand poses.
  Walk(const Plan& plan, bool prune, std::function<void()> stop_if_asked);
  Walk(const Walk&) = delete;  // its judge knows where it is
  Walk& operator=(const Walk&) = delete;

  // `bits`: where accepted poses are marked, pose p n + k of point p of the tile at orientation k of these n, as they are listed. After a
  // walk that threw another may be run.
  Found run(const Tile& tile, const Orientations& orientations, int node, PoseBits bits = {});

 private:
  struct Block {
    Tile tile;
    int node;
    std::vector<MarginVerdict> verdicts;
  };
  std::size_t poses(const Block& b) const { return b.tile.size() * turned(b); }
  std::size_t turned(const Block& b) const;
  void decide(std::span<Block> blocks);
  void bound(std::span<const Block> blocks, std::size_t stage);
  bool finish(const Block& block);
  void accept(const Block& block);
  int widest(const Block& block) const;
  void halve(Block block);
  void judge(const Block& block);
  void pose_points(const Tile& tile);
  void take(const Accepted& accepted);
  void ask(std::size_t judged);

  const Plan& plan_;
  const bool prune_;
  const std::function<void()> stop_if_asked_;
  std::size_t judged_ = 0;  // poses since it was asked
  Judge judge_;
  std::vector<program::Boxes> boxes_;        // of each stage
  std::vector<std::vector<int>> inputs_of_;  // of each stage: inputs that it reads
  std::vector<std::vector<double>> values_;  // of each point axis

  const Orientations* orientations_ = nullptr;
  const Tile* root_ = nullptr;
  PoseBits bits_;
  bool each_ = false;  // accepted poses are looked at one by one
  Found found_;
  std::vector<Block> open_;
  std::vector<program::Bounds> in_, out_;
  std::optional<Tile> posed_;  // whose points stand in points_, told by their places within the root tile
  PointBlock points_;
};

}  // namespace pmreport::scan
