// A motion in blocks: the same numbers whoever computes them, all at once, by several processes, or again after an interruption.
#include <core/analysis/analysis.hpp>
#include <core/analysis/samples/evenly.hpp>
#include <core/analysis/samples/motion_blocks.hpp>
#include <core/chunks/chunk_folder.hpp>
#include <tests/given/gantry.hpp>
#include <tests/given/only.hpp>
#include <tests/host/fixtures/temporary.hpp>

#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

namespace fs = std::filesystem;
using namespace pmreport;
using analysis::Analysis;
using analysis::Measure;

namespace {

// The gantry on rails that end at 48 mm, before the motion does; where `fails`, its plugin breaks down there.
template <bool fails>
struct Short : gantry::Gantry {
  static constexpr const char *name = "short", *title = "short rails";
  explicit Short(const Parameters& p) : gantry::Gantry(p) {}
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    if constexpr (!fails)
      at.require(0.048 - abs(q[0]), "the rails end");
    else if (value_of(q[0]) > 0.048)
      throw std::runtime_error("a rail breaks");
    gantry::Gantry::place(q, at);
  }

 private:
  static double value_of(double x) { return x; }
  static double value_of(const Jet<double>& x) { return x.value; }
  template <class T>
  static double value_of(const T&) {
    return 0;
  }
};

constexpr int samples = 10'000;  // two blocks and a part of one

struct Motion {
  explicit Motion(const scenario::MechanismSource& source)
      : loaded(scenario::load_text(R"toml(title = "Short rails"
[mechanism]
use = "short"
[motion]
duration = "2 s"
samples = 10000
x = "50 mm * sin(4*pi*t/2 s)"
[load]
force = ["5 N", "400 N * cos(pi*t/1 s)", "0 N"]
[drive]
lead = "10 mm"
inertia = "2e-5 kg*m^2"
[[element]]
name = "first"
joint = "P1"
radial = "100 N/um"
[[element]]
name = "second"
joint = "P2"
radial = "300 N/um"
[[section]]
kind = "velocity"
[[section]]
kind = "dynamics"
[[section]]
kind = "drives"
[[section]]
kind = "reactions"
[[section]]
kind = "stiffness"
)toml",
                                   "short.toml", source, section::kinds())) {}

  Analysis analysis(const chunks::Sharing& sharing = {}, int threads = 2) const { return analysis(all(), sharing, threads); }
  Analysis analysis(analysis::Asked asked, const chunks::Sharing& sharing, int threads) const {
    asked.singularities = false;
    analysis::Progress progress;
    progress.sharing = sharing;
    return tbb::task_arena(threads).execute([&] { return Analysis(loaded.scenario, loaded.trajectory, *loaded.machine, asked, progress); });
  }
  analysis::Asked all() const { return analysis::asked_by(loaded.scenario); }

  scenario::Loaded loaded;
};

// All that an analysis says of its samples, to the last bit.
struct Said {
  std::vector<std::uint64_t> numbers;
  std::vector<std::string> sentences;
  bool operator==(const Said&) const = default;
};
Said said_by(const Analysis& a) {
  Said out;
  const auto add = [&](double x) { out.numbers.push_back(std::bit_cast<std::uint64_t>(x)); };
  for (analysis::ColumnList* list :
       {analysis::displacement_columns, analysis::velocity_columns, analysis::acceleration_columns, analysis::statics_columns,
        analysis::dynamics_columns, analysis::drive_columns, analysis::reaction_columns, analysis::stiffness_columns})
    for (const analysis::Column& c : a.columns_of(list))
      for (const double x : a.column(c)) add(x);
  for (int k = 0; k < a.samples(); ++k) {
    add(static_cast<double>(a.outcome(k)));
    const analysis::HoldingWrenches& w = a.wrenches(k);
    for (const double x : {static_cast<double>(w.side), w.determinant, w.condition, w.amplification}) add(x);
    out.sentences.push_back(a.why(k));
  }
  for (std::size_t m = 0; m < static_cast<std::size_t>(Measure::count); ++m)
    for (const double tolerance : {1e-18, 1e-9, std::numeric_limits<double>::infinity()}) {
      const analysis::Worst w = a.worst(static_cast<Measure>(m), tolerance);
      for (const double x : {w.value, w.poorest}) add(x);
      for (const int x : {w.sample, w.compared, w.poorly_known, w.undecided}) add(x);
    }
  const analysis::ElasticReactions& e = a.elastic_reactions();
  for (const auto* joints : {&a.indeterminate(), &e.settled})
    for (const auto x : *joints) add(x);
  for (const int x : {a.self_stresses(), e.stresses, e.open, e.force_joint, e.force_sample, e.moment_joint, e.moment_sample}) add(x);
  add(e.force), add(e.moment);
  for (const mechanics::Matrix6d& c : a.compliances())
    for (const double x : c.reshaped()) add(x);
  return out;
}

}  // namespace

TEST_CASE("a motion comes to the same bytes by two threads, by shards of one thread each that are put together, and resumed") {
  const Motion motion(test::only<Short<false>>());
  const Analysis at_once = motion.analysis();
  const Said expected = said_by(at_once);

  // It has something of everything.
  CHECK(at_once.count(analysis::Outcome::unreachable) > 100);
  CHECK(at_once.why(1250) == "the rails end");
  CHECK(at_once.why(0).empty());
  CHECK(at_once.unreachable().size() == 4);
  CHECK(at_once.self_stresses() == 4);
  CHECK(at_once.indeterminate()[0] != 0);
  CHECK(at_once.elastic_reactions().force > 0);
  CHECK(at_once.worst(Measure::free_body).compared == at_once.count(analysis::Outcome::good));
  CHECK(at_once.worst(Measure::elastic_work).compared > 4);
  CHECK(at_once.worst(Measure::power_balance).compared > 0);

  const TemporaryFolder folder;
  chunks::Account account;
  chunks::Sharing sharing{.folder = folder.path(), .of_run = 3, .known = true, .account = &account, .keep_after = 0};
  for (std::size_t index = 0; index < 3; ++index) {
    chunks::Shard shard(index, 3);
    chunks::Sharing of_shard = sharing;
    of_shard.dealer = &shard;
    CHECK_THROWS_AS(motion.analysis(of_shard, 1), chunks::Elsewhere);
    CHECK(account.computed == index + 1);
  }
  sharing.computes = false;
  CHECK(said_by(motion.analysis(sharing)) == expected);
  CHECK(account.computed == 3);
  CHECK(account.found == 3);

  fs::remove(fs::directory_iterator(folder.path())->path() / "1");
  CHECK_THROWS_AS(motion.analysis(sharing), chunks::ChunkError);
  sharing.computes = true;
  CHECK(said_by(motion.analysis(sharing)) == expected);
  CHECK(account.computed == 4);
}

TEST_CASE("blocks of another load are not taken for those of this one") {
  Motion motion(test::only<Short<false>>());
  const TemporaryFolder folder;
  chunks::Account account;
  const chunks::Sharing sharing{.folder = folder.path(), .known = true, .account = &account, .keep_after = 0};
  motion.analysis({}, sharing, 2);
  motion.loaded.scenario.load.force.back().x() += 1;  // as of a file that has changed, which the scenario only names
  motion.analysis({}, sharing, 2);
  CHECK(account.computed == 6);
  CHECK(account.found == 0);
}

TEST_CASE("of samples at which the plugin breaks down the first is told, whatever the threads do") {
  const Motion motion(test::only<Short<true>>());
  for (const int threads : {1, 2})
    CHECK_THROWS_WITH(motion.analysis({}, {}, threads), Catch::Matchers::Contains("sample 1026: a rail breaks"));
}

TEST_CASE("a motion is asked within its blocks whether to stop") {
  const Motion motion(test::only<Short<false>>());
  analysis::Asked asked;
  asked.singularities = false;
  struct Stop {};
  analysis::Progress progress;
  std::atomic<int> asked_for = 0;
  progress.stop_if_asked = [&] {
    if (++asked_for == 100) throw Stop();
  };
  CHECK_THROWS_AS(Analysis(motion.loaded.scenario, motion.loaded.trajectory, *motion.loaded.machine, asked, progress), Stop);
}

TEST_CASE("blocks that each know their share of evenly spread samples have together those of the whole motion") {
  using analysis::evenly, analysis::evenly_before;
  constexpr std::size_t wanted = 16, block = analysis::MotionBlocks::size;
  for (const std::size_t n : {1u, 15u, 16u, 17u, 4096u, 4097u, 10'000u, 100'001u}) {
    CAPTURE(n);
    std::vector<std::size_t> all(n);
    std::iota(all.begin(), all.end(), std::size_t{0});
    const std::vector<std::size_t> chosen = evenly(all, wanted);
    CHECK(chosen.size() == std::min(n, wanted));
    CHECK(std::ranges::adjacent_find(chosen, std::greater_equal()) == chosen.end());
    for (std::size_t first = 0; first < n; first += block)
      CHECK(evenly_before(first + block, n, wanted) - evenly_before(first, n, wanted) ==
            static_cast<std::size_t>(std::ranges::count_if(chosen, [&](std::size_t k) { return k >= first && k < first + block; })));
  }
  CHECK(evenly(std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8}, 3) == std::vector<int>{1, 4, 7});
}
