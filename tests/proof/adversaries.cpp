// Motions made to be hard: limits that are only just met, left or touched, surfaces that are touched or met twice at once, kinks, jumps
// and cuts.
#include <tests/proof/probed.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace pmreport;
using namespace pmreport::analysis;
using namespace pmreport::test;

namespace {

using State = Claim::State;
constexpr double microsecond = 1e-6, limit = 0.5;  // of the slide

// A parabola with its peak `peak` at `at`.
Cubic parabola(double peak, double at, double bend) { return {at, {peak, 0, -bend, 0}}; }

bool enclosed(const Bounds& b, double truth, double width) { return b.low <= truth && truth <= b.high && b.width() <= width; }

}  // namespace

TEST_CASE("a peak that passes its limit by a billionth of its range is broken, from when to when") {
  const double beyond = 1e-9, bend = 0.03;
  const Probed p = probed({}, parabola(limit + beyond, 5.3, bend), 0.1, 0, 10);
  const double half = std::sqrt(beyond / bend);
  REQUIRE(p.stroke(0).state == State::broken);
  REQUIRE(p.stroke(0).broken.size() == 1);
  const Claim::Broken& b = p.stroke(0).broken[0];
  CHECK(enclosed(b.begin, 5.3 - half, microsecond));
  CHECK(enclosed(b.end, 5.3 + half, microsecond));
  CHECK(b.above);
  CHECK(b.worst.has(limit + beyond));
  CHECK(b.worst.width() < beyond);
  CHECK(p.stroke(0).undecided.empty());
  CHECK(p.found == "");
}

TEST_CASE("a peak that stays inside its limit by a billionth of its range holds") {
  const Probed p = probed({}, parabola(limit - 1e-9, 5.3, 0.03), 0.1, 0, 10);
  CHECK(p.stroke(0).state == State::holds);
  CHECK_FALSE(p.proof.exhausted);
  CHECK(p.found == "");
}

TEST_CASE("a peak as near to its limit as rounding can tell is undecided, about when it is there") {
  const Probed p = probed({{"half_limit", 0.3}}, 0.1, parabola(0.3 - 1e-16, 5.3, 0.01), 0, 10);
  REQUIRE(p.turn().state == State::undecided);
  REQUIRE(p.turn().undecided.size() == 1);
  CHECK(p.turn().undecided[0].has(5.3));
  CHECK(p.turn().undecided[0].width() < 1e-5);  // 1e-16 / 0.01 is the square of 1e-7
  CHECK_FALSE(p.proof.exhausted);
  CHECK(p.found == "");
}

TEST_CASE("a slide that dwells exactly at its limit holds") {
  const Probed p = probed({}, Pieces({{0, {0.25, 0.125, 0, 0}}, {2, {0.5, 0, 0, 0}}, {5, {0.5, -0.125, 0, 0}}}, 1), 0.1, 0, 8);
  CHECK(p.stroke(0).state == State::holds);
  CHECK(p.found == "");
}

TEST_CASE("a joint that dwells at its limit as far as rounding tells is undecided, at little cost") {
  const Probed p =
      probed({{"half_limit", 0.3}}, 0.1, Pieces({{0, {0.1, 0.1, 0, 0}}, {2, {0.3, 0, 0, 0}}, {5, {0.3, -0.1, 0, 0}}}, 1), 0, 7);
  CHECK(p.turn().state == State::undecided);
  REQUIRE(p.turn().undecided.size() == 1);
  CHECK(enclosed(Bounds{p.turn().undecided[0].low, 2}, 2, microsecond));
  CHECK(enclosed(Bounds{5, p.turn().undecided[0].high}, 5, microsecond));
  CHECK(p.proof.evaluations < 5000);
  CHECK_FALSE(p.proof.exhausted);
  CHECK(p.found == "");
}

TEST_CASE("a motion that begins at its limit and goes inside holds: one that begins outside is broken from the beginning") {
  const Probed inside = probed({}, Cubic{0, {limit, -0.1, 0, 0}}, 0.1, 0, 3);
  CHECK(inside.stroke(0).state == State::holds);
  CHECK(inside.found == "");
  const Probed outside = probed({}, Cubic{0, {limit + 0.1, -0.1, 0, 0}}, 0.1, 0, 3);
  REQUIRE(outside.stroke(0).broken.size() == 1);
  CHECK(outside.stroke(0).broken[0].begin == Bounds::exactly(0));
  CHECK(enclosed(outside.stroke(0).broken[0].end, 1, microsecond));
  CHECK(outside.found == "");
  const Probed leaves = probed({}, Cubic{0, {limit - 0.2, 0.1, 0, 0}}, 0.1, 0, 3);
  REQUIRE(leaves.stroke(0).broken.size() == 1);
  CHECK(enclosed(leaves.stroke(0).broken[0].begin, 2, microsecond));
  CHECK(leaves.stroke(0).broken[0].end == Bounds::exactly(3));
  CHECK(leaves.found == "");
}

TEST_CASE("a slide that leaves either end of its stroke is broken above and below, apart") {
  const Probed p = probed({}, Pieces({{0, {0.6, -0.4, 0, 0}}, {3, {-0.6, 0.4, 0, 0}}}, 1), 0.1, 0, 6);
  REQUIRE(p.stroke(0).broken.size() == 3);
  CHECK(p.stroke(0).broken[0].above);
  CHECK_FALSE(p.stroke(0).broken[1].above);
  CHECK(enclosed(p.stroke(0).broken[1].begin, 2.75, microsecond));
  CHECK(enclosed(p.stroke(0).broken[1].end, 3.25, microsecond));
  CHECK(p.found == "");
}

TEST_CASE("a slide that jumps from one end of its stroke to beyond the other is broken from the jump on") {
  const Probed p = probed({}, Pieces({{0, {-0.4, 0, 0, 0}}, {1.7, {0.6, -0.1, 0, 0}}}, 0), 0.1, 0, 2);
  REQUIRE(p.stroke(0).broken.size() == 1);
  CHECK(enclosed(p.stroke(0).broken[0].begin, 1.7, microsecond));
  CHECK(p.stroke(0).broken[0].end == Bounds::exactly(2));
  CHECK(enclosed(p.extreme("q").largest, 0.6, 1e-6));
  CHECK(enclosed(p.extreme("q").least, -0.4, 1e-6));
  CHECK_FALSE(p.extreme("q_rate").largest.bounded());
  CHECK(p.found == "");
}

TEST_CASE("a determinant that touches zero is a touch, and one that crosses it is a crossing") {
  const std::map<std::string, double> x{{"determinant", 1}};
  const Probed touch = probed(x, Cubic{4.3, {0, 0, 0.02, 0}}, 0.1, 0, 10);
  REQUIRE(touch.proof.meetings.size() == 1);
  CHECK(touch.proof.meetings[0].what == Meeting::What::touch);
  CHECK(touch.proof.meetings[0].time.has(4.3));
  CHECK(touch.proof.meetings[0].time.width() < 1e-3);
  CHECK(touch.regular().state == State::undecided);
  CHECK(touch.found == "");
  const Probed crossing = probed(x, Cubic{4.3, {0, 0.02, 0, 0}}, 0.1, 0, 10);
  REQUIRE(crossing.proof.meetings.size() == 1);
  CHECK(crossing.proof.meetings[0].what == Meeting::What::crossing);
  CHECK(enclosed(crossing.proof.meetings[0].time, 4.3, microsecond));
  CHECK(crossing.regular().state == State::broken);
  CHECK(crossing.found == "");
}

TEST_CASE("a determinant that comes near zero keeps its sign") {
  const Probed p = probed({{"determinant", 1}}, Cubic{4.3, {1e-8, 0, 0.02, 0}}, 0.1, 0, 10);
  CHECK(p.regular().state == State::holds);
  CHECK(p.found == "");
}

TEST_CASE("two crossings within a ten-thousandth of a second are found, apart") {
  const double half = 0.5e-4, bend = 0.04;
  const Probed p = probed({{"determinant", 1}}, parabola(bend * half * half, 6.1, bend), 0.1, 0, 10);
  REQUIRE(p.proof.meetings.size() == 2);
  for (const int k : {0, 1}) {
    CHECK(p.proof.meetings[static_cast<std::size_t>(k)].what == Meeting::What::crossing);
    CHECK(enclosed(p.proof.meetings[static_cast<std::size_t>(k)].time, 6.1 + (k == 0 ? -half : half), microsecond));
  }
  CHECK(p.found == "");
}

TEST_CASE("a determinant that is zero for a second is one meeting, at little cost") {
  const Probed p = probed({{"determinant", 1}}, Pieces({{0, {0.3, -0.1, 0, 0}}, {3, {0, 0, 0, 0}}, {4, {0, -0.1, 0, 0}}}, 1), 0.1, 0, 7);
  REQUIRE(p.proof.meetings.size() == 1);
  CHECK(p.proof.meetings[0].what == Meeting::What::crossing);
  CHECK(enclosed(Bounds{p.proof.meetings[0].time.low, 3}, 3, microsecond));
  CHECK(enclosed(Bounds{4, p.proof.meetings[0].time.high}, 4, microsecond));
  CHECK(p.proof.evaluations < 5000);
  CHECK(p.found == "");
}

TEST_CASE("a motion that begins singular touches there") {
  const Probed p = probed({{"determinant", 1}}, Cubic{0, {0, 0.1, 0, 0}}, 0.1, 0, 3);
  REQUIRE(p.proof.meetings.size() == 1);
  CHECK(p.proof.meetings[0].what == Meeting::What::touch);
  CHECK(p.proof.meetings[0].time.low == 0);
  CHECK(p.proof.meetings[0].time.width() < microsecond);
  CHECK(p.found == "");
}

TEST_CASE("where G has a pole it is unbounded, and where it jumps its determinant changes sign") {
  const Probed pole = probed({{"determinant", 2}}, Cubic{2.2, {0, 0.1, 0, 0}}, 0.1, 0, 3);
  REQUIRE(pole.proof.meetings.size() == 1);
  CHECK(pole.proof.meetings[0].what == Meeting::What::unbounded);
  CHECK(enclosed(pole.proof.meetings[0].time, 2.2, microsecond));
  CHECK(pole.found == "");
  const Probed sign = probed({{"determinant", 3}}, Cubic{2.2, {0, 0.1, 0, 0}}, 0.1, 0, 3);
  REQUIRE(sign.proof.meetings.size() == 1);
  CHECK(sign.proof.meetings[0].what == Meeting::What::crossing);
  CHECK(enclosed(sign.proof.meetings[0].time, 2.2, microsecond));
  CHECK(sign.found == "");
}

TEST_CASE("out of reach on the way: from when to when, and nothing else is judged there") {
  // x = 0.45 - 0.01 (t - 5)^2 is beyond 0.41 from 3 s to 7 s; phi passes 2 there, and its own stroke with it.
  const Probed p = probed({{"reach", 0.41}}, parabola(0.45, 5, 0.01), parabola(2.4, 5, 0.15), 0, 10);
  REQUIRE(p.assembled().broken.size() == 1);
  CHECK(p.assembled().state == State::broken);
  CHECK(enclosed(p.assembled().broken[0].begin, 3, microsecond));
  CHECK(enclosed(p.assembled().broken[0].end, 7, microsecond));
  CHECK(p.stroke(1).state == State::holds);
  CHECK(p.regular().state == State::holds);
  CHECK(p.found == "");
}

TEST_CASE("a mechanism that may be out of reach for a moment proves nothing of that moment") {
  // The reach touches zero at 5 s, and there alone the stroke of the turn may be left: not proved to be kept.
  const Probed p = probed({{"reach", 0.4}}, parabola(0.4, 5, 0.01), parabola(2 + 1e-13, 5, 0.15), 0, 10);
  CHECK(p.assembled().state != State::broken);
  CHECK(p.stroke(1).state != State::holds);
  CHECK(p.found == "");
}

TEST_CASE("an angle that passes half a turn jumps: its rate has no bound there, and its limit is left") {
  const double pi = std::numbers::pi;
  const Probed p = probed({{"turn", 1}, {"half_limit", 3}}, 0.1, Cubic{0, {pi - 1, 0.5, 0, 0}}, 0, 4);
  REQUIRE(p.turn().broken.size() == 2);  // beyond 3, and then beyond -3
  CHECK(p.turn().broken[0].above);
  CHECK_FALSE(p.turn().broken[1].above);
  CHECK(enclosed(p.turn().broken[0].begin, 2 * (4 - pi), microsecond));
  CHECK(enclosed(p.turn().broken[0].end, 2, microsecond));
  CHECK(enclosed(p.turn().broken[1].begin, 2, microsecond));
  CHECK(enclosed(p.turn().broken[1].end, 2 * (pi - 2), microsecond));
  CHECK(p.extreme("psi").largest.has(pi));
  CHECK(p.extreme("psi").largest.width() < 1e-5);
  CHECK_FALSE(p.extreme("psi_rate").largest.bounded());
  CHECK(p.found == "");
}

TEST_CASE("an actuator that jumps by a choice has both values in its bracket, and no bound of its rate") {
  const Probed p = probed({{"turn", 2}}, Cubic{1.3, {0, 0.1, 0, 0}}, Cubic{0, {0.1, 0.2, 0, 0}}, 0, 3);
  CHECK(enclosed(p.extreme("psi").largest, 0.1 + 0.2 * 1.3 + 1, 1e-5));
  CHECK(enclosed(p.extreme("psi").least, 0.1 + 0.2 * 1.3, 1e-5 + 0.26));
  CHECK_FALSE(p.extreme("psi_rate").largest.bounded());
  CHECK(p.found == "");
}

TEST_CASE("kinks of the geometry are met as they are: rates from both sides, and no bound of accelerations") {
  // |phi|, min(phi, x) and max(phi, x), x constant, phi falls through it faster and faster: rates jump by themselves.
  for (const double turn : {3, 4, 5}) {
    const double x = turn == 3 ? 0 : 0.3;
    const Probed p = probed({{"turn", turn}}, x, Cubic{0, {0.8, -0.2, -0.1, 0}}, 0, 3);
    INFO("turn " << turn);
    CHECK(p.found == "");
    CHECK(p.extreme("psi_rate").largest.bounded());
    CHECK_FALSE(p.extreme("psi_acceleration").largest.bounded());
    // phi' = -0.2 - 0.2 t; phi = x at t, 0.1 t^2 + 0.2 t = 0.8 - x
    const double at = -1 + std::sqrt(1 + 10 * (0.8 - x)), rate = 0.2 + 0.2 * at;
    const double fastest = turn == 3 ? 0.8 : turn == 4 ? 0 : 0, slowest = turn == 3 ? -rate : turn == 4 ? -0.8 : -rate;
    CHECK(enclosed(p.extreme("psi_rate").largest, fastest, 1e-5));
    CHECK(enclosed(p.extreme("psi_rate").least, slowest, 1e-5));
  }
}

TEST_CASE("a kink of the motion at a limit") {
  // |t - 1.7| / 10 from above and from below, about the limit.
  const Pieces up({{0, {limit - 0.17, 0.1, 0, 0}}, {1.7, {limit, -0.1, 0, 0}}}, 1),
      beyond({{0, {limit - 0.17 + 1e-7, 0.1, 0, 0}}, {1.7, {limit + 1e-7, -0.1, 0, 0}}}, 1);
  const Probed at = probed({}, up, 0.1, 0, 3);
  CHECK(at.stroke(0).state != State::broken);
  CHECK(at.found == "");
  const Probed out = probed({}, beyond, 0.1, 0, 3);
  REQUIRE(out.stroke(0).broken.size() == 1);
  CHECK(enclosed(out.stroke(0).broken[0].begin, 1.7 - 1e-6, microsecond));
  CHECK(enclosed(out.stroke(0).broken[0].end, 1.7 + 1e-6, microsecond));
  CHECK(enclosed(out.extreme("q_rate").largest, 0.1, 1e-9));
  CHECK(out.found == "");
}

TEST_CASE("nothing moves: everything holds, at the cost of the first look") {
  const Probed p = probed({}, 0.1, 0.1, 0, 10);
  for (const Claim& c : p.proof.claims) CHECK(c.state == State::holds);
  CHECK(p.extreme("q").least == Bounds::exactly(0.1));
  CHECK(p.proof.evaluations < 200);
  CHECK(p.found == "");
}

TEST_CASE("short motions and long ones are told by their own length") {
  for (const double duration : {1e-3, 1e5}) {
    INFO(duration);
    const double speed = 1 / duration;
    const Probed p = probed({{"determinant", 1}}, Cubic{0, {-0.3, speed, 0, 0}}, 0.1, 0, duration);
    REQUIRE(p.stroke(0).broken.size() == 1);
    CHECK(enclosed(p.stroke(0).broken[0].begin, 0.8 * duration, std::min(1e-6, 1e-6 * duration)));
    REQUIRE(p.proof.meetings.size() == 1);
    CHECK(enclosed(p.proof.meetings[0].time, 0.3 * duration, std::min(1e-6, 1e-6 * duration)));
    CHECK(p.found == "");
  }
}

TEST_CASE("two samples are a motion, one is none") {
  const auto machine = probe();
  const auto two = prove_motion(*machine, pieces_motion({Cubic{0, {0, 0.4, 0, 0}}, 0.1}, 0, 1, 2), {});
  CHECK(two.unexamined.empty());
  CHECK(two.claims.size() == 5);
  mechanics::Trajectory one = pieces_motion({0.1, 0.1}, 0, 1, 2);
  one.time.resize(1);
  CHECK_FALSE(prove_motion(*machine, one, {}).unexamined.empty());
}
