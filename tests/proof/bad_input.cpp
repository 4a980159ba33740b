// Motions and mechanisms that nothing good can be said of: told so, and never without end.
#include <tests/proof/attack.hpp>
#include <tests/proof/probe.hpp>
#include <tests/proof/probed.hpp>

#include <catch2/catch.hpp>

#include <chrono>
#include <limits>
#include <random>

using namespace pmreport;
using namespace pmreport::analysis;
using namespace pmreport::test;

namespace {

using ClaimState = Claim::State;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

const Pieces slide = Cubic{0, {-0.3, 0.05, 0, 0}};

// A slow slide of ten seconds, whose bounds are changed on the way.
template <class Change>
MotionProof proof_with(Change&& change, const ProofOptions& options = {}) {
  const auto machine = probe();
  mechanics::Trajectory motion = pieces_motion({slide, 0.1}, 0, 10);
  const mechanics::Enclosure sound = motion.over;
  motion.over = [&](Bounds time, mechanics::Bounded* out) {
    const bool known = sound(time, out);
    return change(time, out) && known;
  };
  return prove_motion(*machine, motion, {}, options);
}

bool within_budget(const MotionProof& p, const ProofOptions& options = {}) { return p.evaluations <= 2 * options.most_intervals; }

long undecided(const MotionProof& p) { return std::ranges::count(p.claims, ClaimState::undecided, &Claim::state); }

}  // namespace

TEST_CASE("a motion without bounds about an instant is undecided there, and decided elsewhere") {
  const MotionProof p = proof_with([](Bounds time, mechanics::Bounded* out) {
    if (time.has(3.3)) out[0] = {};
    return true;
  });
  const Claim& stroke = p.claims[1];
  CHECK(stroke.state == ClaimState::undecided);
  REQUIRE(stroke.undecided.size() == 1);
  CHECK(stroke.undecided[0].has(3.3));
  CHECK(stroke.undecided[0].width() < 1e-6);
  CHECK(p.claims[2].state == ClaimState::holds);  // the turn has nothing to do with it
  CHECK(p.claims.back().state == ClaimState::undecided);
  CHECK_FALSE(p.exhausted);
  CHECK(within_budget(p));
  CHECK_FALSE(p.extreme(ColumnId::named("q"))->largest.bounded());
}

TEST_CASE("a motion without bounds for a second does not cost what is decided elsewhere") {
  const MotionProof p = proof_with([](Bounds time, mechanics::Bounded* out) {
    if (time.high > 3 && time.low < 4) out[0] = {};
    return true;
  });
  REQUIRE(p.claims[1].undecided.size() == 1);
  CHECK(p.claims[1].undecided[0].low == Approx(3).margin(1e-6));
  CHECK(p.claims[1].undecided[0].high == Approx(4).margin(1e-6));
  CHECK_FALSE(p.exhausted);
  CHECK(p.evaluations < 10000);
}

TEST_CASE("no bounds at all: all is undecided, and soon") {
  const auto nothing = [](Bounds, mechanics::Bounded*) { return false; };
  const auto no_numbers = [](Bounds, mechanics::Bounded* out) {
    for (int i = 0; i < 2; ++i) out[i] = {{not_a_number, not_a_number}, {not_a_number, not_a_number}, {not_a_number, not_a_number}};
    return true;
  };
  const auto reversed = [](Bounds, mechanics::Bounded* out) {
    for (int i = 0; i < 2; ++i) std::swap(out[i].value.low, out[i].value.high), out[i].value.low += 1;
    return true;
  };
  for (const MotionProof& p : {proof_with(nothing), proof_with(no_numbers), proof_with(reversed)}) {
    CHECK(undecided(p) == static_cast<long>(p.claims.size()));
    CHECK(within_budget(p));
    for (const Extreme& e : p.extremes)
      if (e.column == ColumnId::named("q")) CHECK_FALSE((e.least.bounded() || e.largest.bounded()));
  }
}

TEST_CASE("bounds that come and go prove nothing false") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  const MotionProof p = proof_with([&](Bounds, mechanics::Bounded* out) {
    const double what = share(random);
    if (what < 0.2) return false;
    if (what < 0.3) out[0].rate = {not_a_number, 1};
    if (what > 0.9) out[1].value = {};
    return true;
  });
  CHECK(within_budget(p));
  CHECK(joined(contradictions(*probe(), p, law_of({slide, 0.1}), {.dense = 500})) == "");
}

TEST_CASE("the bound on intervals is kept, and told where it stops the proof") {
  // A hundred thousand turns, each beyond a limit.
  std::vector<Cubic> turns;
  constexpr int many = 100'000;
  for (int k = 0; k < many; ++k)
    turns.push_back({10.0 * k / many, {k % 2 == 0 ? 0.49 : 0.51, (k % 2 == 0 ? 0.02 : -0.02) * many / 10, 0, 0}});
  const auto machine = probe();
  const mechanics::Trajectory motion = pieces_motion({Pieces(turns, 1), 0.1}, 0, 10);
  for (const int most : {100, 2000, 20000}) {
    const auto begin = std::chrono::steady_clock::now();
    ProofOptions options;
    options.most_intervals = most;
    const MotionProof p = prove_motion(*machine, motion, {}, options);
    CHECK(p.exhausted);
    CHECK(within_budget(p, options));
    CHECK(p.claims[1].state == ClaimState::broken);
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
    CHECK(joined(contradictions(*machine, p, law_of({Pieces(turns, 1), 0.1}), {.dense = 500})) == "");
  }
}

TEST_CASE("a motion of a hundred thousand knots that hardly moves is proved at the cost of a smooth one") {
  std::vector<Cubic> pieces;
  constexpr int many = 100'000;
  for (int k = 0; k < many; ++k) pieces.push_back({10.0 * k / many, {0.1, 0, 1e-3, 0}});
  const auto machine = probe();
  const MotionProof p = prove_motion(*machine, pieces_motion({Pieces(pieces, 0), 0.1}, 0, 10), {});
  CHECK(p.claims[1].state == ClaimState::holds);
  CHECK(within_budget(p));
}

namespace {

// The probe with another recording.
template <class Record>
MotionProof proof_of_recording(Record record) {
  pm_mechanism table = contract::mechanism<Probe>;
  table.record = record;
  const mechanics::Machine machine(table, mechanics::default_values(mechanics::describe(table)));
  return prove_motion(machine, pieces_motion({slide, 0.1}, 0, 10), {});
}

// Which changes one of its steps.
template <class Change>
pm_status changed(const pm_instance* instance, pm_recording* list, pm_text* text, Change&& change) {
  const pm_status status = contract::mechanism<Probe>.record(instance, list, text);
  for (std::size_t k = 0; k < list->count && k < list->capacity; ++k) change(list->steps[k]);
  return status;
}

}  // namespace

TEST_CASE("a plugin that records nothing, or nonsense, is not examined, and the reason is told") {
  const auto none = proof_of_recording(nullptr);
  const auto fails = proof_of_recording([](const pm_instance*, pm_recording*, pm_text*) noexcept -> pm_status { return PM_FAILED; });
  const auto no_number = proof_of_recording([](const pm_instance* i, pm_recording* list, pm_text* text) noexcept -> pm_status {
    return changed(i, list, text, [](pm_step& s) { s.constant = not_a_number; });
  });
  const auto no_operation = proof_of_recording([](const pm_instance* i, pm_recording* list, pm_text* text) noexcept -> pm_status {
    return changed(i, list, text, [](pm_step& s) { s.operation = 1000; });
  });
  const auto ahead = proof_of_recording([](const pm_instance* i, pm_recording* list, pm_text* text) noexcept -> pm_status {
    return changed(i, list, text, [](pm_step& s) { s.a += 1 << 20; });
  });
  for (const MotionProof& p : {none, fails, no_number, no_operation, ahead}) {
    CHECK(p.unexamined != "");
    CHECK(p.claims.empty());
  }
}

TEST_CASE("a plugin that records another geometry than its own is found out") {
  CHECK(proof_of_recording(contract::mechanism<Probe>.record).recording < 1e-14);
  const auto lies = proof_of_recording([](const pm_instance* i, pm_recording* list, pm_text* text) noexcept -> pm_status {
    return changed(i, list, text, [](pm_step& s) {
      if (s.operation == PM_OP_COS) s.operation = PM_OP_SIN;
    });
  });
  CHECK(!(lies.recording < 1e-3));
}
