// Prescribed actuators, proved: real mechanisms against Newton's method in extended precision.
#include <tests/analysis/proof_followed.hpp>

#include <core/analysis/proof/followed_krawczyk.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <tests/plugins/plugin.hpp>

#include <cfenv>
#include <thread>

using namespace trial;
using Catch::Contains;

namespace {

std::unique_ptr<Machine> machine_of(const std::string& plugin) {
  const pm_mechanism& table = test::plugin(plugin);
  return std::make_unique<Machine>(table, mechanics::default_values(mechanics::describe(table)));
}

// Each actuator its own sine about home: `share` of the mechanism's size, or radians.
Sines sines_of(const Machine& machine, double share) {
  const double length = mechanics::characteristic_length(machine);
  Sines out;
  for (int i = 0; i < machine.dof(); ++i) {
    const double size = mechanics::size_of(machine.topology().actuators[static_cast<std::size_t>(i)].sense(), length);
    const double home = machine.home_pose().numbers[machine.layout().actuator(static_cast<std::size_t>(i))];
    out.of.push_back({home, share * size * (i % 2 == 0 ? 1 : -1), 2 * std::numbers::pi / 10 * (1 + i % 3), false});
  }
  return out;
}

struct SmallNumbers {
  double value[6], rate[6], acceleration[6];
};

void check_outside(const Outside& seen, int expected = 0) {
  CHECK(seen.looked_at > 0);
  CHECK(seen.value == expected);
  CHECK(seen.rate == expected);
  CHECK(seen.acceleration == expected);
}

// By how much bounds over a span exceed what is taken at 200 instants of it, which is less than all that is taken by a share of 1e-4 at
// most.
struct Excess {
  double value = 0, rate = 0;
};
Excess excess(const Followed& motion, const Enclosure& over, double from, double width) {
  std::vector<Bounded> b(static_cast<std::size_t>(motion.machine.dof()));
  REQUIRE(over({from, from + width}, b.data()));
  Eigen::VectorXd nearby = motion.at(from);
  Exact least = motion.oracle.at(from, nearby), most = least;
  for (int k = 1; k <= 200; ++k) {
    const Exact e = motion.oracle.at(from + width * k / 200, nearby);
    least.value = least.value.cwiseMin(e.value), most.value = most.value.cwiseMax(e.value);
    least.rate = least.rate.cwiseMin(e.rate), most.rate = most.rate.cwiseMax(e.rate);
    nearby = e.value.cast<double>();
  }
  Excess out;
  for (int i = 0; i < motion.machine.dof(); ++i) {
    const Bounded& x = b[static_cast<std::size_t>(i)];
    out.value = std::max(out.value, x.value.width() - static_cast<double>(most.value(i) - least.value(i)));
    out.rate = std::max(out.rate, x.rate.width() - static_cast<double>(most.rate(i) - least.rate(i)));
  }
  return out;
}

}  // namespace

TEST_CASE("coordinates that follow their actuators are within their bounds at every instant of every span") {
  struct Case {
    const char* plugin;
    double share;
  };
  const Case each =
      GENERATE(Case{"gough", 0.1}, Case{"delta", 0.1}, Case{"2q-spr", 0.05}, Case{"stewart", 0.02}, Case{"parallel-cross", 0.02},
               Case{"5pus-upu", 0.1}, Case{"4sps-spr", 0.02}, Case{"p2prpu-prps", 0.1}, Case{"par4", 0.1});
  CAPTURE(each.plugin);
  const auto machine = machine_of(each.plugin);
  const Followed motion(*machine, sines_of(*machine, each.share), 10);
  REQUIRE(motion.trajectory.ending.empty());
  const FollowedProof proof = motion.proof();
  CHECK(proof.reason == "");
  CHECK(proof.proved == Bounds{0, 10});
  CHECK(proof.spans > 0);
  REQUIRE(proof.over);
  check_outside(outside(motion, proof.over, proof.proved, 40, 1));
}

TEST_CASE("a mechanism that meets a singular surface is proved up to shortly before it") {
  const auto machine = machine_of("4sps-spr");
  const Followed motion(*machine, sines_of(*machine, 0.1), 10);
  REQUIRE_FALSE(motion.trajectory.ending.empty());
  const FollowedProof proof = motion.proof();
  REQUIRE(proof.over);
  SmallNumbers q;
  CHECK(motion.trajectory.at(proof.proved.high - 1e-9, q.value, q.rate, q.acceleration));
  CHECK_FALSE(motion.trajectory.at(proof.proved.high + 1e-5, q.value, q.rate, q.acceleration));
  CHECK_THAT(proof.reason, Contains("one pose: the motion comes too near to a singular surface"));
  check_outside(outside(motion, proof.over, proof.proved, 40, 8));
}

TEST_CASE("bounds of coordinates and of rates exceed what they take by the second order of the span") {
  const auto machine = machine_of("gough");
  const Followed motion(*machine, sines_of(*machine, 0.1), 10);
  const FollowedProof proof = motion.proof();
  for (const double from : {1.3, 6.7}) {
    CAPTURE(from);
    const Excess wide = excess(motion, proof.over, from, 0.01), half = excess(motion, proof.over, from, 0.005);
    CHECK(wide.value > 3 * half.value);  // 4 in the limit
    CHECK(wide.rate > 3 * half.rate);
  }
  std::vector<Bounded> instant(6);
  REQUIRE(proof.over(Bounds::exactly(4), instant.data()));
  for (const Bounded& b : instant) CHECK(b.value.width() < 1e-12);  // of the law's bounds, 1e-15, and of rounding
}

TEST_CASE("actuators whose rates jump are followed through the jump") {
  const auto machine = machine_of("gough");
  Sines law = sines_of(*machine, 0.05);
  law.of[2].folded = true;
  const Followed motion(*machine, law, 4, 201);
  const double fold = motion.trajectory.knots.front();
  const FollowedProof proof = motion.proof();
  CHECK(proof.reason == "");
  check_outside(outside(motion, proof.over, proof.proved, 60, 2));
  // Spans that hold the jump, or end at it.
  std::vector<Bounded> b(6);
  for (const double half : {0.1, 1e-3, 1e-6})
    for (const Bounds span : {Bounds{fold - half, fold + half}, Bounds{fold - half, fold}, Bounds{fold, fold + half}}) {
      CAPTURE(span.low, span.high);
      REQUIRE(proof.over(span, b.data()));
      for (const double t : {span.low, span.low + 0.3 * span.width(), span.high}) {
        const Exact exact = motion.oracle.at(t, motion.at(t));
        for (int i = 0; i < 6; ++i) {
          CHECK(b[static_cast<std::size_t>(i)].value.has(static_cast<double>(exact.value(i))));
          const Bounds rate = b[static_cast<std::size_t>(i)].rate;
          CHECK(rate.low <= exact.rate(i));
          CHECK(exact.rate(i) <= rate.high);
        }
      }
    }
}

TEST_CASE("spans are answered alike in any order and by any thread, and only where they were proved") {
  const auto machine = machine_of("delta");
  const Followed motion(*machine, sines_of(*machine, 0.1), 10);
  const FollowedProof proof = motion.proof();
  REQUIRE(proof.over);
  std::vector<Bounds> spans;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> time(0, 10);
  for (int k = 0; k < 40; ++k) {
    const double a = time(random), b = time(random);
    spans.push_back({std::min(a, b), std::max(a, b)});
  }
  spans.push_back({0, 10});
  using Answers = std::vector<std::array<Bounded, 6>>;
  const auto ask = [&](bool backwards) {
    Answers out(spans.size());
    for (std::size_t k = 0; k < spans.size(); ++k) {
      const std::size_t at = backwards ? spans.size() - 1 - k : k;
      if (!proof.over(spans[at], out[at].data())) out[at][0].value = {};
    }
    return out;
  };
  const Answers alone = ask(false);
  std::vector<Answers> answers(4);
  {
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < answers.size(); ++k) threads.emplace_back([&, k] { answers[k] = ask(k % 2 == 1); });
  }
  for (const Answers& a : answers)
    for (std::size_t k = 0; k < spans.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(a[k][i].value.bounded());
        CHECK(a[k][i].value == alone[k][i].value);
        CHECK(a[k][i].rate == alone[k][i].rate);
        CHECK(a[k][i].acceleration == alone[k][i].acceleration);
      }
  std::array<Bounded, 6> b;
  for (const Bounds beyond : {Bounds{-1e-9, 1}, Bounds{9, 10.000001}, Bounds{2, 1}, Bounds{}}) CHECK_FALSE(proof.over(beyond, b.data()));
  CHECK(proof.over({0, 0}, b.data()));
  CHECK(proof.over({10, 10}, b.data()));
}

TEST_CASE("the rounding mode is as before when coordinates were followed in bounds") {
  const auto machine = machine_of("p2prpu-prps");
  const Followed motion(*machine, sines_of(*machine, 0.1), 2, 21);
  std::array<Bounded, 6> b;
  for (const int mode : {FE_TONEAREST, FE_DOWNWARD}) {
    std::fesetround(mode);
    const FollowedProof proof = motion.proof();
    const bool known = proof.over && proof.over({0.5, 0.6}, b.data());
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    CHECK(known);
    CHECK(after == mode);
  }
}

TEST_CASE("a path that is not where the actuators lead is refused, from where it leaves on") {
  const auto machine = machine_of("gough");
  const Followed motion(*machine, sines_of(*machine, 0.1), 10);
  Followed wrong = motion;
  wrong.trajectory.value.array() += 1e-3;
  const FollowedProof none = wrong.proof();
  CHECK_FALSE(none.over);
  CHECK(none.spans == 0);
  CHECK(none.proved == Bounds{0, 0});
  CHECK_THAT(none.reason, Contains("is not where these actuators lead"));

  wrong.trajectory = motion.trajectory;
  wrong.trajectory.value.bottomRows(201).array() += 1e-3;  // from 6 s on
  const FollowedProof half = wrong.proof();
  REQUIRE(half.over);
  CHECK(half.proved.high < 6);
  CHECK(half.proved.high > 6 - 1e-6);
  CHECK_THAT(half.reason, Contains("from t = 6 s on the path that was followed is not where these actuators lead"));
  check_outside(outside(motion, half.over, half.proved, 20, 4));
}

TEST_CASE("an actuator that jumps ends what is proved, however short the jump") {
  const auto machine = machine_of("gough");
  Followed motion(*machine, sines_of(*machine, 0.05), 10);
  motion.trajectory.knots = {4};
  motion.trajectory.breaks = {{mechanics::Break::Of::value, "rho1", "m", 4, 1e-12}};
  const FollowedProof proof = motion.proof();
  CHECK(proof.proved.high < 4);
  CHECK(proof.proved.high > 4 - 1e-6);
  CHECK_THAT(proof.reason, Contains("from t = 4 s on a prescribed actuator jumps"));
}

TEST_CASE("the spans that are tried are bounded in number, and what they proved stays") {
  const auto machine = machine_of("gough");
  const Followed motion(*machine, sines_of(*machine, 0.1), 10);
  analysis::FollowedOptions options;
  options.most_spans = 5;
  const FollowedProof proof = motion.proof(options);
  CHECK(proof.spans >= 1);
  CHECK(proof.spans <= 5);
  CHECK(proof.proved.high < 10);
  CHECK_THAT(proof.reason, Contains("5 spans of time were tried"));
  check_outside(outside(motion, proof.over, proof.proved, 10, 5));
}

TEST_CASE("bounds of the actuators that are missing from a time on end what is proved") {
  const auto machine = machine_of("delta");
  const Followed motion(*machine, sines_of(*machine, 0.1), 10);
  const Enclosure law = motion.sines.over();
  const FollowedProof proof =
      prove_followed(*machine, motion.trajectory, [&](Bounds t, Bounded* out) { return t.high < 3 && law(t, out); });
  CHECK(proof.proved.high > 3 - 1e-6);
  CHECK_THAT(proof.reason, Contains("from t = 3 s on the prescribed actuators have no bounds"));
  const FollowedProof nothing = prove_followed(*machine, motion.trajectory, [](Bounds, Bounded*) { return false; });
  CHECK_FALSE(nothing.over);
  CHECK_FALSE(nothing.reason.empty());
}

// Planted errors: the checks above see them.

TEST_CASE("bounds of an actuator whose rate has the wrong sign prove nothing") {
  const auto machine = machine_of("gough");
  const Followed motion(*machine, sines_of(*machine, 0.1), 10);
  const Enclosure law = motion.sines.over();
  const FollowedProof proof = prove_followed(*machine, motion.trajectory, [&](Bounds t, Bounded* out) {
    law(t, out);
    out[1].rate = {-out[1].rate.high, -out[1].rate.low};
    return true;
  });
  CHECK(proof.spans == 0);
  CHECK_FALSE(proof.over);
  CHECK_FALSE(proof.reason.empty());
}

TEST_CASE("answers with rates of the wrong sign, or accelerations, are seen to be wrong") {
  const auto machine = machine_of("gough");
  const Followed motion(*machine, sines_of(*machine, 0.1), 10);
  const Enclosure law = motion.sines.over();
  Bounds Bounded::*turned = nullptr;
  const FollowedProof proof = prove_followed(*machine, motion.trajectory, [&](Bounds t, Bounded* out) {
    law(t, out);
    if (turned != nullptr) out[1].*turned = {-(out[1].*turned).high, -(out[1].*turned).low};
    return true;
  });
  REQUIRE(proof.reason.empty());
  check_outside(outside(motion, proof.over, proof.proved, 20, 6));
  turned = &Bounded::rate;
  CHECK(outside(motion, proof.over, proof.proved, 20, 6).rate > 0);
  turned = &Bounded::acceleration;
  CHECK(outside(motion, proof.over, proof.proved, 20, 6).acceleration > 0);
}

TEST_CASE("boxes that were not made large enough to hold the pose are seen not to hold it") {
  const auto machine = machine_of("gough");
  const Followed motion(*machine, sines_of(*machine, 0.1), 10);
  const Enclosure law = motion.sines.over();
  const analysis::ActuatorGeometry geometry(*machine->program(), machine->layout().actuator(0));
  const linear::SmallVector sizes = linear::SmallVector::Ones(6);
  analysis::FrameFinder frames(geometry, sizes);
  analysis::Krawczyk krawczyk(geometry, sizes);
  bool inflate = true;
  const Enclosure over = [&](Bounds t, Bounded* out) {
    std::array<Bounded, 6> actuators, at_middle;
    law(t, actuators.data());
    law(Bounds::exactly(t.middle()), at_middle.data());
    const auto frame = frames.at(t.middle(), at_middle.data(), motion.at(t.middle()));
    REQUIRE(frame);
    analysis::Offsets point, only, within;
    point.fill(Bounds::exactly(0));
    int rounds = 0;
    const analysis::Krawczyk::Prescribed prescribed{actuators.data(), at_middle.data(), true};
    REQUIRE(krawczyk.find(*frame, t, prescribed, point, only, within, rounds) == analysis::Krawczyk::Found::one);
    return krawczyk.enclose(*frame, t, prescribed, inflate ? within : point, out);
  };
  const auto short_spans = [&](Bounds t, Bounded* out) { return over({t.low, std::min(t.high, t.low + 0.02)}, out); };
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> time(0, 9.9);
  const auto misses = [&] {
    int out = 0;
    for (int k = 0; k < 20; ++k) {
      const double from = time(random);
      std::array<Bounded, 6> b;
      REQUIRE(short_spans({from, 10}, b.data()));
      const Exact exact = motion.oracle.at(from, motion.at(from));
      for (int i = 0; i < 6; ++i)
        out += exact.value(i) < b[static_cast<std::size_t>(i)].value.low || exact.value(i) > b[static_cast<std::size_t>(i)].value.high;
    }
    return out;
  };
  CHECK(misses() == 0);
  inflate = false;
  CHECK(misses() > 0);
}
