// Boxes that are halved by several processes at once, all of which know the same boxes before and after.
#pragma once

#include <core/chunks/sharing.hpp>
#include <core/scan/proof/refine.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace pmreport::scan {

// Boxes in chunks, which depend on nothing but the boxes.
struct Wave {
  std::span<const std::uint32_t> boxes;
  std::span<const std::size_t> ends;  // of its chunks among the boxes; before them where the first one begins

  std::size_t chunks() const { return ends.size() - 1; }
  std::span<const std::uint32_t> chunk(std::size_t i) const { return boxes.subspan(ends[i], ends[i + 1] - ends[i]); }
  std::span<const std::uint32_t> all() const { return boxes.subspan(ends.front(), ends.back() - ends.front()); }
};

class SharedWaves {
 public:
  // `sharing` and `margins` must outlive it. `work`: its name, and the meaning of what decides what comes of a box.
  SharedWaves(chunks::Work work, const chunks::Sharing& sharing, const BoxedMargins& margins, const Watch& watch);

  bool shared() const { return sharing_.dealer != nullptr; }  // with anyone
  bool shares(const Wave& wave) const;                        // it is large enough for that

  // What comes of the chunks is taken in their order, by one thread at a time. `refined` is called by several threads, but by none while
  // `take` is: that may change what `refined` looks at, other than the boxes.
  using Refine = std::function<std::unique_ptr<Refined>(std::span<const std::uint32_t> boxes)>;
  void run(const Wave& wave, const OpenBoxes& from, const MarginSets& sets, const Refine& refined,
           const std::function<void(Refined&)>& take);

  // What `decide` says at one of them.
  bool agreed(const std::function<bool()>& decide);

 private:
  std::uint64_t meaning_of(const Wave& wave, const OpenBoxes& from) const;

  chunks::Work work_;  // of all waves
  const chunks::Sharing& sharing_;
  const BoxedMargins& margins_;
  Watch only_stops_;  // the share of a wave that is done is not that of the proof
  std::uint64_t waves_ = 0, decisions_ = 0;
};

}  // namespace pmreport::scan
