// Proofs of random motions of every mechanism, attacked.
#include <core/analysis/proof/proof.hpp>
#include <tests/proof/attack.hpp>
#include <tests/proof/mechanisms.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::analysis;
using namespace pmreport::test;

namespace {

long count(const MotionProof& proof, Claim::State state) { return std::ranges::count(proof.claims, state, &Claim::state); }

}  // namespace

TEST_CASE("what is proved of random motions of every mechanism holds at random instants, in extended precision and by the plugin") {
  int broken = 0, crossings = 0, held = 0, out_of_reach = 0;
  for (const std::string& name : names_of_the_house()) {
    const auto machine = mechanism_of_the_house(name);
    for (unsigned seed = 1; seed <= 4; ++seed) {
      std::mt19937_64 random(seed);
      const double share = std::array{0.3, 1.0, 2.0, 4.0}[seed - 1];  // of the box of coordinates
      const std::vector<Sine> sines = random_sines(*machine, random, 0.5 * share, share, 10);
      const MotionProof proof = prove_motion(*machine, sine_motion(sines, 10, 101), {});
      INFO(name << ", seed " << seed);
      REQUIRE(proof.unexamined.empty());
      const auto found = contradictions(*machine, proof, law_of(sines), {.random = 300, .dense = 2000, .seed = seed});
      CHECK(joined(found) == "");
      CHECK(joined(contradictions_by_plugin(*machine, proof, law_of(sines), 200, seed)) == "");
      broken += static_cast<int>(count(proof, Claim::State::broken));
      held += static_cast<int>(count(proof, Claim::State::holds));
      out_of_reach += proof.claims[0].state == Claim::State::broken;
      crossings += static_cast<int>(std::ranges::count(proof.meetings, Meeting::What::crossing, &Meeting::what));
    }
  }
  INFO(held << " held, " << broken << " broken, " << out_of_reach << " out of reach, " << crossings << " crossings");
  CHECK(held > 100);  // the attack saw all that it is about
  CHECK(broken > 20);
  CHECK(out_of_reach > 0);
  CHECK(crossings > 0);
}

TEST_CASE("random motions well inside are decided, and their brackets as near as they should be") {
  for (const std::string& name : names_of_the_house()) {
    const auto machine = mechanism_of_the_house(name);
    std::mt19937_64 random(7);
    const std::vector<Sine> sines = random_sines(*machine, random, 0.2, 0.4, 10);
    const ProofOptions options;
    const MotionProof proof = prove_motion(*machine, sine_motion(sines, 10, 101), {}, options);
    INFO(name);
    CHECK_FALSE(proof.exhausted);
    CHECK(proof.evaluations <= 2 * options.most_intervals);
    for (const Claim& c : proof.claims) CHECK(c.state != Claim::State::undecided);
    const Topology& t = machine->topology();
    // The bracket's share of what the widest of its like moves, which the narrow ones need not better.
    for (const OfMotion order : {OfMotion::value, OfMotion::rate}) {
      double widest = 0;
      for (const Actuator& a : t.actuators)
        widest = std::max(widest, proof.extreme(column_of(a, order))->largest.low - proof.extreme(column_of(a, order))->least.high);
      for (const Actuator& a : t.actuators) {
        const Extreme& e = *proof.extreme(column_of(a, order));
        CHECK(e.least.width() <= 1.01 * options.bracket * widest);
        CHECK(e.largest.width() <= 1.01 * options.bracket * widest);
      }
    }
  }
}
