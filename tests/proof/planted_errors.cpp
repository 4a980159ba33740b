// An attack that cannot find anything proves nothing: errors, each of a kind, and that they are found.
#include <core/analysis/proof/proof.hpp>
#include <core/analysis/proof/prover.hpp>
#include <core/program/derivative.hpp>
#include <tests/proof/attack.hpp>
#include <tests/proof/mechanisms.hpp>
#include <tests/proof/probed.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::analysis;
using namespace pmreport::test;

namespace {

// A motion that leaves two strokes and meets no singular surface, proved; and one that crosses.
struct Proved {
  std::unique_ptr<mechanics::Machine> machine;
  std::vector<Sine> sines;
  MotionProof proof;

  Proved(const std::string& name, double least_share, double largest_share, unsigned seed) : machine(mechanism_of_the_house(name)) {
    std::mt19937_64 random(seed);
    sines = random_sines(*machine, random, least_share, largest_share, 10);
    proof = prove_motion(*machine, sine_motion(sines, 10, 101), {});
  }
  std::string attacked() const { return joined(contradictions(*machine, proof, law_of(sines), {.dense = 2000})); }
};

// The proof of a motion with other bounds than its own.
MotionProof proof_with(const Proved& p, const mechanics::Enclosure& bounds) {
  mechanics::Trajectory motion = sine_motion(p.sines, 10, 101);
  motion.over = bounds;
  return prove_motion(*p.machine, motion, {});
}
MotionProof proof_with(const Proved& p, const mechanics::MotionProgram& program, const program::Program& moving) {
  const mechanics::Trajectory motion = sine_motion(p.sines, 10, 101);
  MotionProof out;
  out.begin = 0, out.end = 10;
  Prover(*p.machine, program, moving, motion.over, {0, 10}, motion.knots, {}).run(out);
  return out;
}

const Proved& small() {
  static const Proved out("gough", 0.2, 0.4, 3);
  return out;
}
const Proved& large() {
  static const Proved out("gough", 0.9, 1.2, 3);
  return out;
}

// Of each step, whether these need it.
std::vector<bool> needed_by(const std::vector<program::Step>& steps, const std::vector<int>& outputs) {
  std::vector<bool> out(steps.size());
  for (const int o : outputs) out[static_cast<std::size_t>(o)] = true;
  for (std::size_t k = steps.size(); k-- > 0;) {
    const int operands[] = {steps[k].a, steps[k].b, steps[k].c};
    for (int n = 0; out[k] && n < program::operands_of(steps[k].operation); ++n) out[static_cast<std::size_t>(operands[n])] = true;
  }
  return out;
}

Claim* broken_in(MotionProof& proof) {
  const auto at = std::ranges::find_if(proof.claims, [](const Claim& c) { return c.about == Claim::About::stroke && !c.broken.empty(); });
  return at == proof.claims.end() ? nullptr : &*at;
}

}  // namespace

TEST_CASE("nothing is found in proofs that are sound") {
  CHECK(small().attacked() == "");
  CHECK(large().attacked() == "");
}

TEST_CASE("a limit that is dropped from the claims is missed") {
  Proved p("gough", 0.2, 0.4, 3);
  const auto dropped = std::ranges::find(p.proof.claims, Claim::About::joint_limit, &Claim::about);
  REQUIRE(dropped != p.proof.claims.end());
  p.proof.claims.erase(dropped);
  CHECK(p.attacked() != "");
}

TEST_CASE("a claim about a wider range is found") {
  Proved p("gough", 0.2, 0.4, 3);
  p.proof.claims[1].range.max += 1e-3;
  CHECK(p.attacked() != "");
}

TEST_CASE("a claim that a broken limit holds is found") {
  Proved p("gough", 0.9, 1.2, 3);
  Claim* claim = broken_in(p.proof);
  REQUIRE(claim != nullptr);
  claim->state = Claim::State::holds;
  claim->broken.clear(), claim->undecided.clear();
  CHECK(p.attacked() != "");
}

TEST_CASE("a broken stretch that is shifted by a hundred microseconds is found") {
  for (const double by : {-1e-4, 1e-4}) {
    Proved p("gough", 0.9, 1.2, 3);
    Claim* claim = broken_in(p.proof);
    REQUIRE(claim != nullptr);
    for (Claim::Broken& b : claim->broken)
      for (Bounds* ends : {&b.begin, &b.end}) *ends = {ends->low + by, ends->high + by};
    CHECK(p.attacked() != "");
  }
}

TEST_CASE("a worst value that is not the worst is found") {
  Proved p("gough", 0.9, 1.2, 3);
  Claim* claim = broken_in(p.proof);
  REQUIRE(claim != nullptr);
  Claim::Broken& b = claim->broken.front();
  const double limit = b.above ? claim->range.max : claim->range.min, middle = 0.5 * (limit + b.worst.middle());
  (b.above ? b.worst.high : b.worst.low) = middle;
  CHECK(p.attacked() != "");
}

TEST_CASE("brackets that are a billionth of the range too narrow are found") {
  for (const bool upper : {false, true})
    for (const bool inner : {false, true}) {
      Proved p("gough", 0.2, 0.4, 3);
      for (Extreme& e : p.proof.extremes) {
        const double by = 1e-9 * (e.largest.low - e.least.high);
        if (upper)
          inner ? e.largest.low = e.largest.high + by : e.largest.high = e.largest.low - by;
        else
          inner ? e.least.high = e.least.low - by : e.least.low = e.least.high + by;
      }
      CHECK(p.attacked() != "");
    }
}

TEST_CASE("a meeting that is left out is found, and one that is said to be another") {
  const Pieces x = Cubic{4.3, {0, 0.02, 0, 0}}, phi = 0.1;
  Probed p = probed({{"determinant", 1}}, x, phi, 0, 10);
  const auto attacked = [&] { return joined(contradictions(*p.machine, p.proof, law_of({x, phi}), {.dense = 500})); };
  REQUIRE(p.proof.meetings.size() == 1);
  CHECK(attacked() == "");
  const MotionProof sound = p.proof;
  p.proof.meetings.clear();
  p.proof.claims.back().state = Claim::State::holds;
  CHECK(attacked() != "");
  p.proof = sound;
  p.proof.meetings[0].what = Meeting::What::touch;
  p.proof.claims.back().state = Claim::State::undecided;
  CHECK(attacked() != "");
  p.proof = sound;
  p.proof.meetings[0].time = {4.2, 4.21};
  CHECK(attacked() != "");
}

TEST_CASE("bounds of a motion that are too small by a millionth of their width are found") {
  const auto sound = sine_motion(small().sines, 10, 101).over;
  Proved p("gough", 0.2, 0.4, 3);
  p.proof = proof_with(p, [&sound](Bounds time, mechanics::Bounded* out) {
    if (!sound(time, out)) return false;
    for (std::size_t i = 0; i < 6; ++i)
      for (Bounds* b : {&out[i].value, &out[i].rate, &out[i].acceleration}) *b = {b->low + 1e-6 * b->width(), b->high - 1e-6 * b->width()};
    return true;
  });
  CHECK(p.attacked() != "");
}

TEST_CASE("a rate with the wrong sign in the bounds of a motion is found") {
  const auto sound = sine_motion(small().sines, 10, 101).over;
  Proved p("gough", 0.2, 0.4, 3);
  p.proof = proof_with(p, [&sound](Bounds time, mechanics::Bounded* out) {
    if (!sound(time, out)) return false;
    out[2].rate = {-out[2].rate.high, -out[2].rate.low};
    return true;
  });
  CHECK(p.attacked() != "");
}

TEST_CASE("a wrong sign in the geometry that is proved is found, wherever it is") {
  Proved p("gough", 0.2, 0.4, 3);
  const mechanics::MotionProgram sound = mechanics::motion_program(*p.machine).value();
  std::vector<program::Step> steps(sound.program.steps().begin(), sound.program.steps().end());
  std::vector<int> outputs(sound.program.outputs().begin(), sound.program.outputs().end());
  int planted = 0;
  for (std::size_t k = 0; k < steps.size(); k += 1 + steps.size() / 8) {
    std::size_t at = k;
    while (at < steps.size() && steps[at].operation != program::Operation::subtract) ++at;
    if (at == steps.size()) break;
    std::vector<program::Step> wrong = steps;
    wrong[at].operation = program::Operation::add;
    mechanics::MotionProgram other = sound;
    other.program = program::Program(wrong, sound.program.inputs(), outputs);
    p.proof = proof_with(p, other, program::in_time(other.program, 2));
    const std::string found = joined(contradictions(*p.machine, sound, p.proof, law_of(p.sines), {.dense = 500}));
    INFO("step " << at);
    CHECK(found != "");
    ++planted;
  }
  CHECK(planted > 3);
}

// One sign in the rates of the actuators, wherever it is: values still are what they were.
TEST_CASE("a derivative with one wrong sign is found") {
  Proved p("gough", 0.2, 0.4, 3);
  const mechanics::MotionProgram sound = mechanics::motion_program(*p.machine).value();
  const program::Program moving = program::in_time(sound.program, 2);
  const std::size_t values = sound.program.outputs().size(), first = values + p.machine->layout().actuator(0);
  const std::vector<int> rates{static_cast<int>(first), static_cast<int>(first + 1)};
  std::vector<program::Step> steps(moving.steps().begin(), moving.steps().end());
  const std::vector<int> outputs(moving.outputs().begin(), moving.outputs().end());
  std::vector<int> of_values(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(values)), of_rates;
  for (const int o : rates) of_rates.push_back(outputs[static_cast<std::size_t>(o)]);
  const std::vector<bool> in_values = needed_by(steps, of_values), in_rates = needed_by(steps, of_rates);
  int planted = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const bool sum = steps[k].operation == program::Operation::add || steps[k].operation == program::Operation::subtract;
    if (!sum || in_values[k] || !in_rates[k]) continue;
    if (planted++ % 4 != 0) continue;
    std::vector<program::Step> wrong = steps;
    wrong[k].operation = steps[k].operation == program::Operation::add ? program::Operation::subtract : program::Operation::add;
    p.proof = proof_with(p, sound, program::Program(wrong, moving.inputs(), outputs));
    INFO("step " << k);
    CHECK(joined(contradictions(*p.machine, sound, p.proof, law_of(p.sines), {.random = 200, .dense = 200})) != "");
  }
  CHECK(planted > 8);
}
