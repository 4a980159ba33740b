// Proofs that two ranks of a job share: two threads, which see one folder.
#include <catch2/catch.hpp>
#include <core/scan/proof/refined_bytes.hpp>
#include <core/scan/proved_volume.hpp>
#include <tests/bench/six_ups.hpp>
#include <tests/chunks/two_ranks.hpp>
#include <tests/host/fixtures/temporary.hpp>
#include <tests/scan/closed_sets.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <limits>
#include <optional>
#include <thread>

using namespace pmreport;
using namespace pmreport::scan;

namespace {

struct Task {
  PoseSet set;
  Scan scan;
  VolumeOptions options;
};

Task six_legs(double gap) {
  Task t{bench::six_ups(), bench::six_ups_range(), {}};
  t.options.gap = gap;
  return t;
}

// Unit discs about (cos t, sin t), t the orientation; points that three of seven have.
Task turned_discs() {
  Task t;
  t.set = recorded_set(3, [](program::Recorder& r, std::vector<Recorded>& m) {
    const Recorded dx = r.input(0) - cos(r.input(2)), dy = r.input(1) - sin(r.input(2));
    m.push_back(Recorded(1.0) - dx * dx - dy * dy);
  });
  t.scan = {{0, 0, 0}, {{0, -2.1, 2.2, 1}, {1, 2.3, -2.1, 1}}, {2}, {}};
  for (int k = 0; k < 7; ++k) t.scan.orientations.push_back({0.3 * k});
  t.options.gap = 2e-7;
  t.options.need = 3;
  return t;
}

struct Shared {
  std::array<std::optional<ProvedVolume>, 2> of;  // nothing: it has left
  std::array<chunks::Account, 2> accounts;
  std::array<std::atomic<int>, 2> asked = {};  // whether to stop
};
// `begin` is told the rank, and asked how often it is to be asked whether to stop until it does.
template <class F>
void prove(const Task& t, Shared& out, F&& begin) {
  struct Stopped {};
  const TemporaryFolder here;
  chunks::TwoRanks().run([&](std::size_t rank, chunks::Dealer& dealer) {
    const chunks::Sharing sharing{.folder = here.path(), .known = true, .dealer = &dealer, .account = &out.accounts[rank]};
    const int most = begin(rank);
    Watch watch;
    watch.stop_if_asked = [&] {
      if (++out.asked[rank] > most) throw Stopped();
    };
    try {
      out.of[rank] = prove_volume(t.set, t.scan, t.options, watch, {"proof"}, sharing);
    } catch (const Stopped&) {
    } catch (const chunks::Elsewhere&) {
    }
  });
}
constexpr int never = std::numeric_limits<int>::max();

void check_same(const ProvedVolume& a, const ProvedVolume& b) {
  CHECK(a.volume == b.volume);
  CHECK(a.low == b.low);
  CHECK(a.high == b.high);
  CHECK(a.empty == b.empty);
  CHECK(a.enough == b.enough);
  CHECK(a.why == b.why);
  CHECK(a.boxes == b.boxes);
  CHECK(a.undecided == b.undecided);
}

}  // namespace

TEST_CASE("two ranks prove together what one proves alone, to the last bit") {
  Task few = six_legs(1e-9);  // of boxes, which end it before all are halved that were to be
  few.options.boxes = 250'000;
  for (const Task& task : {six_legs(2e-3), turned_discs(), few}) {
    const ProvedVolume alone = prove_volume(task.set, task.scan, task.options);
    CHECK(alone.boxes < task.options.boxes + 64 * (1024 + 8));  // a wave of one, whose chunks end with the parts of a box
    Shared shared;
    prove(task, shared, [](std::size_t) { return never; });
    for (const std::size_t rank : {0u, 1u}) {
      CAPTURE(rank, alone.boxes);
      REQUIRE(shared.of[rank]);
      check_same(*shared.of[rank], alone);
      CHECK(shared.accounts[rank].computed > 0);
      CHECK(shared.accounts[rank].found > shared.accounts[rank].computed);  // its own, and those of the other
    }
  }
}

TEST_CASE("a proof goes on alone when the other rank leaves in the middle") {
  const Task task = six_legs(2e-3);
  const ProvedVolume alone = prove_volume(task.set, task.scan, task.options);
  Shared whole;
  prove(task, whole, [](std::size_t) { return never; });
  Shared shared;
  prove(task, shared, [&](std::size_t rank) { return rank == 0 ? never : whole.asked[1].load() / 2; });
  CHECK_FALSE(shared.of[1]);
  REQUIRE(shared.of[0]);
  check_same(*shared.of[0], alone);
  CHECK(shared.accounts[0].computed > whole.accounts[0].computed);
}

TEST_CASE("time ends a proof at the same box on two ranks whose clocks differ") {
  Task task = six_legs(1e-9);
  task.options.seconds = 0.4;
  Shared shared;
  prove(task, shared, [](std::size_t rank) {
    // What they first do together ends when the time of the one is over, and that of the other has hardly begun.
    if (rank == 1) std::this_thread::sleep_for(std::chrono::milliseconds(400));
    return never;
  });
  REQUIRE(shared.of[0]);
  REQUIRE(shared.of[1]);
  check_same(*shared.of[0], *shared.of[1]);
  CHECK_THAT(shared.of[0]->why, Catch::Matchers::StartsWith("after 0.4 s"));
}

TEST_CASE("a shard leaves a proof to the merge") {
  chunks::Shard shard(0, 2);
  const Task task = six_legs(0.1);
  CHECK_THROWS_AS(prove_volume(task.set, task.scan, task.options, {}, {}, {.dealer = &shard}), chunks::Elsewhere);
}

TEST_CASE("what is found of boxes comes back from bytes as it was, and bytes that make no sense are told") {
  constexpr std::size_t axes = 2, margins = 70, orientations = 9;
  const auto fresh = [] { return Refined(axes, margins); };
  Refined refined = fresh();
  const std::array<std::array<std::uint64_t, 2>, 2> bits{{{5, 1}, {~std::uint64_t{0}, 3}}};
  for (const auto& b : bits) refined.examination.sets.add(b);
  refined.came_from = {Refined::nowhere, 4};
  const std::array<program::Bounds, axes> sides{{{-1, 0.5}, {2, 3}}};
  refined.open.add(sides, {0.25, 0.75}, {3, 2, true}, std::array<OpenOrientation, 2>{{{8, 1}, {2, 0}}});
  refined.open.add(sides, {0, 1}, {0, 0, false}, {});
  refined.filled = {1, 2};
  refined.ends[1].filled({-4, 7});
  refined.filled_count = 3;
  refined.boxes = 1000;
  const auto bytes_of = [](const Refined& r) {
    chunks::Writer w;
    put(r, w);
    return w.take();
  };
  const auto read = [&](std::span<const std::byte> from, std::size_t known_orientations, std::size_t sets, Refined& out) {
    chunks::Reader r(from);
    get(r, known_orientations, sets, out);
    r.end();
  };
  const chunks::Bytes bytes = bytes_of(refined);
  Refined back = fresh();
  read(bytes, orientations, 5, back);
  CHECK(bytes_of(back) == bytes);
  CHECK(back.open.size() == 2);
  CHECK(back.open.open(0)[1].orientation == 2);
  CHECK(back.open.open(1).empty());
  CHECK(back.open.state(0).blind);
  CHECK(std::ranges::equal(back.open.sides(1), sides));
  CHECK(back.open.volume(0) == program::Bounds{0.25, 0.75});
  CHECK(std::ranges::equal(back.examination.sets.bits(1), bits[1]));
  CHECK(back.came_from == refined.came_from);
  const Ends& ends = back.ends[1];
  CHECK(std::array{ends.least, ends.greatest, ends.low_at_most, ends.high_at_least} == std::array<double, 4>{-4, 7, -4, 7});
  CHECK(back.boxes == 1000);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Refined cut = fresh();
    CHECK_THROWS_AS(read(std::span(bytes).first(size), orientations, 5, cut), chunks::NotReadable);
  }
  Refined of_too_few = fresh();
  CHECK_THROWS_AS(read(bytes, 8, 5, of_too_few), chunks::NotReadable);
  Refined from_nowhere_known = fresh();
  CHECK_THROWS_AS(read(bytes, orientations, 4, from_nowhere_known), chunks::NotReadable);
}
