// What is proved of a motion, in words: of proofs made by hand.
#include <catch2/catch.hpp>

#include <reports/section/common/words/proof_words.hpp>

#include <vector>

using namespace pmreport;
using namespace pmreport::section;
using Catch::Contains;
using About = analysis::Claim::About;
using State = analysis::Claim::State;
using What = analysis::Meeting::What;

namespace {

// Three limbs, ball joints A1 and A2 that are limited.
Topology limbs() {
  Topology t;
  for (const char* n : {"1", "2", "3"})
    t.actuators.push_back({std::string("l") + n, std::string("length of limb ") + n, "m", 0, {0.5, 0.8}});
  for (const char* n : {"A1", "A2"}) t.joints.push_back({n, JointKind::spherical, 0, 1, {{0, 0.5}}});
  return t;
}

// Everything holds from 0 s to 10 s.
MotionProof holding() {
  MotionProof p;
  p.end = 10, p.intervals = 323, p.resolution = 1e-7;
  const auto claim = [&](About about, int index, Range range) {
    analysis::Claim c;
    c.about = about, c.index = index, c.range = range, c.state = State::holds;
    p.claims.push_back(c);
  };
  claim(About::assembled, 0, {0, 0});
  for (int i = 0; i < 3; ++i) claim(About::stroke, i, {0.5, 0.8});
  for (int i = 0; i < 2; ++i) claim(About::joint_limit, i, {0, 0.5});
  claim(About::regular, 0, {0, 0});
  return p;
}
constexpr std::size_t assembled = 0, l1 = 1, l2 = 2, l3 = 3, a1 = 4, a2 = 5, regular = 6;

analysis::Claim::Broken above(Bounds begin, Bounds end, double worst, double at) { return {begin, end, true, Bounds::exactly(worst), at}; }

struct Told {
  Topology topology = limbs();
  MotionProof proof = holding();
  bool singular_everywhere = false;

  Proved proved() const { return {proof, topology, singular_everywhere}; }
  analysis::Claim& operator[](std::size_t claim) { return proof.claims[claim]; }
  void breaks(std::size_t claim, std::vector<analysis::Claim::Broken> stretches) {
    proof.claims[claim].state = State::broken;
    proof.claims[claim].broken = std::move(stretches);
  }
  void leaves_open(std::size_t claim, std::vector<Bounds> times) {
    proof.claims[claim].state = State::undecided;
    proof.claims[claim].undecided = std::move(times);
  }
  std::string sentence() const { return motion_sentence(proved()); }
  std::string rest() const { return remaining_sentence(proved()); }
};

}  // namespace

TEST_CASE("what holds throughout is told in one sentence") {
  Told t;
  CHECK(t.sentence() == "Strokes, joint limits and regularity hold at every instant from 0 s to 10 s (proved, 323 intervals).");
  CHECK(t.rest() == t.sentence());
}

TEST_CASE("of what there is nothing to speak of, nothing is said") {
  Told t;
  std::erase_if(t.proof.claims, [](const analysis::Claim& c) { return c.about == About::joint_limit; });
  CHECK(t.sentence() == "Strokes and regularity hold at every instant from 0 s to 10 s (proved, 323 intervals).");
  t.singular_everywhere = true;
  CHECK(t.sentence() == "Strokes hold at every instant from 0 s to 10 s (proved, 323 intervals).");
  std::erase_if(t.proof.claims, [](const analysis::Claim& c) { return c.about == About::stroke; });
  CHECK(t.sentence() == "The mechanism can be assembled at every instant from 0 s to 10 s (proved, 323 intervals).");
}

TEST_CASE("a stroke that is left is told from when to when, with the decimals that the bounds allow, and by how much at most") {
  Told t;
  t.breaks(l3, {above({1.20310001, 1.20310099}, {1.842029, 1.842031}, 0.8023, 1.64)});
  CHECK(t.sentence() ==
        "Joint limits and regularity hold at every instant from 0 s to 10 s (proved, 323 intervals); l3 leaves its stroke from t = "
        "1.203101 s "
        "to 1.84203 s, at most by 2.3 mm (802.3 mm at t = 1.64 s, its stroke ends at 800 mm).");
  CHECK(t.rest() == "Joint limits and regularity hold at every instant from 0 s to 10 s (proved, 323 intervals).");
}

TEST_CASE("a lower end is a beginning, and what lasts to the end of the motion is told to its last instant") {
  Told t;
  analysis::Claim::Broken b = above({9.5, 9.5000004}, Bounds::exactly(10), 0.499, 10);
  b.above = false;
  t.breaks(l1, {b});
  CHECK_THAT(t.sentence(),
             Contains("l1 leaves its stroke from t = 9.500000 s to 10 s, at most by 1 mm (499 mm at t = 10 s, its stroke begins "
                      "at 500 mm)."));
}

TEST_CASE("several stretches of one are listed, many are counted") {
  Told t;
  std::vector<analysis::Claim::Broken> stretches;
  for (int i = 0; i < 2; ++i) stretches.push_back(above(Bounds::exactly(i), Bounds::exactly(i + 0.25), 0.81, i + 0.1));
  t.breaks(l2, stretches);
  CHECK_THAT(t.sentence(), Contains("l2 leaves its stroke from t = 0 s to 0.25 s and from t = 1 s to 1.25 s, at most by 10 mm"));
  for (int i = 2; i < 6; ++i) stretches.push_back(above(Bounds::exactly(i), Bounds::exactly(i + 0.25), 0.81 + 0.01 * i, i + 0.1));
  t.breaks(l2, stretches);
  CHECK_THAT(t.sentence(),
             Contains("from t = 2 s to 2.25 s and 3 more times, the last from t = 5 s to 5.25 s, at most by 60 mm (860 mm at t = "
                      "5.1 s"));
}

TEST_CASE("alike ones that are left share a piece, which names the one that goes farthest") {
  Told t;
  t.breaks(l1, {above(Bounds::exactly(1), Bounds::exactly(2), 0.81, 1.5)});
  t.breaks(l2, {above(Bounds::exactly(0.5), Bounds::exactly(1), 0.83, 0.7), above(Bounds::exactly(3), Bounds::exactly(4), 0.82, 3.5)});
  CHECK_THAT(t.sentence(),
             Contains("l1 and l2 leave their strokes, 3 times in all, between t = 0.5 s and 4 s, at most l2 by 30 mm (830 mm at "
                      "t = 0.7 s, its stroke ends at 800 mm)."));
  t.breaks(a2, {above(Bounds::exactly(1), Bounds::exactly(2), 0.75, 1.5)});
  const auto pieces = broken_limits(t.proved());
  REQUIRE(pieces.size() == 2);  // joints are told apart from strokes, and these first: by half of their range
  CHECK(pieces[0] == "joint A2 leaves its limit from t = 1 s to 2 s, at most by 14.3° (42.97° at t = 1.5 s, its limit is 28.65°)");
}

TEST_CASE("what is not decided is told with its times, rounded outward") {
  Told t;
  t.leaves_open(l3, {{3.1200004, 3.1399991}});
  CHECK(t.sentence() ==
        "Joint limits and regularity hold at every instant from 0 s to 10 s (proved, 323 intervals); whether l3 keeps its stroke is not "
        "decided "
        "from t = 3.12 s to 3.14 s.");
  CHECK(t.rest() == t.sentence());
  t.leaves_open(l3, {Bounds::exactly(2.5)});
  CHECK_THAT(t.sentence(), Contains("whether l3 keeps its stroke is not decided at t = 2.5 s."));
  t.leaves_open(a1, {{1, 2}});
  t.leaves_open(a2, {{1, 2}});
  CHECK_THAT(t.sentence(), Contains("whether joints A1 and A2 keep their limits is not decided from t = 1 s to 2 s."));
  t.leaves_open(assembled, {{4, 5}});
  CHECK_THAT(t.sentence(), Contains("; whether the mechanism can be assembled is not decided from t = 4 s to 5 s;"));
}

TEST_CASE("a claim that is broken at one time and open at another is told as both") {
  Told t;
  t.breaks(l3, {above(Bounds::exactly(1), Bounds::exactly(2), 0.81, 1.5)});
  t[l3].undecided = {{7, 8}};
  CHECK_THAT(t.sentence(), Contains("l3 leaves its stroke from t = 1 s to 2 s") &&
                               Contains("whether l3 keeps its stroke is not decided from t = 7 s to 8 s."));
  CHECK_THAT(t.rest(), !Contains("leaves") && Contains("is not decided from t = 7 s to 8 s."));
}

TEST_CASE("what was not examined is told with its reason, and those of one reason together") {
  Told t;
  for (const std::size_t c : {a1, a2}) t[c].state = State::unexamined, t[c].reason = "the plugin has no program";
  CHECK(t.sentence() ==
        "Strokes and regularity hold at every instant from 0 s to 10 s (proved, 323 intervals); joint limits were not examined: the plugin "
        "has "
        "no program.");
  t[a1].state = State::holds;
  CHECK_THAT(t.sentence(), Contains("the joint limits of A2 were not examined: the plugin has no program."));
  t.proof.unexamined = "it follows from forces";
  CHECK(t.sentence() == "What holds between the samples was not examined: it follows from forces.");
}

TEST_CASE("crossings are told with their times: a touch and a G without bound are open") {
  Told t;
  t[regular].state = State::broken;
  t.proof.meetings = {{What::crossing, {3.1415924, 3.1415928}}, {What::crossing, {4.0, 4.0000004}}};
  CHECK_THAT(t.sentence(), Contains("; det G changes its sign at t = 3.141593 s and at t = 4.000000 s."));
  CHECK(broken_words(t.proved(), About::regular).size() == 1);
  t.proof.meetings = {{What::touch, {3.12, 3.14}}, {What::unbounded, {5, 6}}};
  t.leaves_open(regular, {{3.12, 3.14}, {8, 9}});
  CHECK_THAT(t.sentence(),
             Contains("det G touches zero, or comes so near that it is not decided whether it does, from t = 3.12 s to 3.14 s; "
                      "whether G stays finite is not decided from t = 5 s to 6 s; whether det G keeps its sign is not decided "
                      "from t = 8 s to 9 s."));
  CHECK(broken_words(t.proved(), About::regular).empty());
}

TEST_CASE("a mechanism that cannot be assembled on the way is told from when to when") {
  Told t;
  t.breaks(assembled, {{{1.25, 1.2500004}, {1.5, 1.5000004}, false, {}, 1.3}});
  CHECK_THAT(t.sentence(), Contains("; the mechanism cannot be assembled from t = 1.250000 s to 1.500000 s."));
}

TEST_CASE("a bound on intervals that was reached is told with what it left open") {
  Told t;
  t.proof.exhausted = true, t.proof.intervals = 20000;
  t.leaves_open(l1, {{0, 10}});
  CHECK_THAT(t.sentence(), Contains("is not decided from t = 0 s to 10 s; the bound on the number of intervals was reached at 20000."));
}
