// Boxes of poses of which it is not decided how much belongs to the set, in stretches of memory.
#pragma once

#include <core/program/intervals/bounds.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pmreport::scan {

// An orientation at which it is open whether a box belongs to the set, and the set of margins that are left of it.
struct OpenOrientation {
  std::uint32_t orientation = 0, set = 0;
};

// Of a box.
struct BoxState {
  std::uint32_t sure = 0;   // orientations at which all of it is known to belong to the set
  std::uint16_t split = 0;  // one bit an axis along which it is to be halved; none: it is as narrow as numbers are
  bool blind = false;       // a margin has no bounds over it
};

class OpenBoxes {
 public:
  explicit OpenBoxes(std::size_t axes) : axes_(axes) {}

  // `volume`: bounds of the volume that belongs to the set.
  void add(std::span<const program::Bounds> sides, program::Bounds volume, BoxState state, std::span<const OpenOrientation> open);
  void add(const OpenBoxes& from, std::size_t k) { add(from.sides(k), from.volume(k), from.state(k), from.open(k)); }
  void append(const OpenBoxes& more);
  void renumber(std::span<const std::uint32_t> sets);  // the new numbers of the sets

  std::size_t size() const { return volume_.size(); }
  std::span<const program::Bounds> sides(std::size_t k) const { return {sides_.data() + k * axes_, axes_}; }
  program::Bounds volume(std::size_t k) const { return volume_[k]; }
  std::span<const program::Bounds> volumes() const { return volume_; }
  double gap(std::size_t k) const { return volume_[k].high - volume_[k].low; }
  BoxState state(std::size_t k) const { return state_[k]; }
  std::span<const OpenOrientation> open(std::size_t k) const {
    const std::size_t from = k == 0 ? 0 : end_[k - 1];
    return {open_.data() + from, end_[k] - from};
  }
  std::size_t bytes() const;

 private:
  std::size_t axes_;
  std::vector<program::Bounds> sides_, volume_;
  std::vector<BoxState> state_;
  std::vector<std::size_t> end_;  // of each box, in open_
  std::vector<OpenOrientation> open_;
};

inline void OpenBoxes::add(std::span<const program::Bounds> sides, program::Bounds volume, BoxState state,
                           std::span<const OpenOrientation> open) {
  sides_.insert(sides_.end(), sides.begin(), sides.end());
  volume_.push_back(volume);
  state_.push_back(state);
  open_.insert(open_.end(), open.begin(), open.end());
  end_.push_back(open_.size());
}

inline void OpenBoxes::append(const OpenBoxes& more) {
  const std::size_t before = open_.size(), boxes = size();
  sides_.insert(sides_.end(), more.sides_.begin(), more.sides_.end());
  volume_.insert(volume_.end(), more.volume_.begin(), more.volume_.end());
  state_.insert(state_.end(), more.state_.begin(), more.state_.end());
  open_.insert(open_.end(), more.open_.begin(), more.open_.end());
  end_.insert(end_.end(), more.end_.begin(), more.end_.end());
  for (std::size_t k = boxes; k < end_.size(); ++k) end_[k] += before;
}

inline void OpenBoxes::renumber(std::span<const std::uint32_t> sets) {
  for (OpenOrientation& o : open_) o.set = sets[o.set];
}

inline std::size_t OpenBoxes::bytes() const {
  return size() * ((axes_ + 1) * sizeof(program::Bounds) + sizeof(BoxState) + sizeof(std::size_t)) + open_.size() * sizeof(OpenOrientation);
}

}  // namespace pmreport::scan
