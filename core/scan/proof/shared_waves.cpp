#include <core/scan/proof/shared_waves.hpp>

#include <core/chunks/agreed.hpp>
#include <core/scan/proof/refined_bytes.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <mutex>
#include <shared_mutex>
#include <utility>

namespace pmreport::scan {

namespace {

// Chunks that are done together, for 10 ms and more, far longer than it takes to ask for them and to keep what is found. Fewer than so many
// times that are done by everyone sooner than by one for all.
constexpr std::size_t together = 16, least_to_share = 4;

}  // namespace

SharedWaves::SharedWaves(chunks::Work work, const chunks::Sharing& sharing, const BoxedMargins& margins, const Watch& watch)
    : work_(std::move(work)), sharing_(sharing), margins_(margins) {
  only_stops_.stop_if_asked = watch.stop_if_asked;
}

bool SharedWaves::shares(const Wave& wave) const { return shared() && wave.chunks() >= least_to_share * together; }

void SharedWaves::run(const Wave& wave, const OpenBoxes& from, const MarginSets& sets, const Refine& refined,
                      const std::function<void(Refined&)>& take) {
  const chunks::Work work{fmt::format("{}, wave {}", work_.name, ++waves_), meaning_of(wave, from),
                          (wave.chunks() + together - 1) / together, true};
  const auto for_each = [&](std::size_t stretch, auto&& f) {
    for (std::size_t i = stretch * together; i < std::min((stretch + 1) * together, wave.chunks()); ++i) f(i);
  };
  // Answers that nobody has kept are computed while others are taken.
  std::shared_mutex taken;
  const auto compute = [&](std::size_t stretch) {
    const std::shared_lock lock(taken);
    chunks::Writer w;
    for_each(stretch, [&](std::size_t i) { put(*refined(wave.chunk(i)), w); });
    return w.take();
  };
  const auto take_all = [&](std::size_t stretch, std::span<const std::byte> answers) {
    const std::unique_lock lock(taken);
    chunks::Reader r(answers);
    for_each(stretch, [&](std::size_t) {
      Refined found(margins_.axes().size(), margins_.margins());
      get(r, margins_.orientations(), sets.size(), found);
      take(found);
    });
    r.end();
  };
  chunks::run(work, sharing_, compute, take_all, only_stops_);
}

bool SharedWaves::agreed(const std::function<bool()>& decide) {
  return chunks::agreed(sharing_, fmt::format("{}, decision {}", work_.name, ++decisions_), work_.meaning, decide, only_stops_);
}

// With the boxes themselves: a machine that had found others would not take what comes of them for its own. Word by word, for they are
// many.
std::uint64_t SharedWaves::meaning_of(const Wave& wave, const OpenBoxes& from) const {
  std::uint64_t h = work_.meaning;
  const auto mix = [&](std::uint64_t word) {
    h = (h ^ word) * 0xbf58476d1ce4e5b9;
    h ^= h >> 31;
  };
  for (const std::uint32_t k : wave.all()) {
    for (const program::Bounds& side : from.sides(k)) {
      mix(std::bit_cast<std::uint64_t>(side.low));
      mix(std::bit_cast<std::uint64_t>(side.high));
    }
    mix(std::uint64_t{from.state(k).sure} << 16 | from.state(k).split);
    for (const OpenOrientation& o : from.open(k)) mix(std::uint64_t{o.orientation} << 32 | o.set);
  }
  return h;
}

}  // namespace pmreport::scan
