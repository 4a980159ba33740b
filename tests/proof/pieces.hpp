// Motions whose every instant is known by hand: cubics one after the other, with kinks and jumps where they meet, and bounds over spans.
#pragma once

#include <core/mechanics/trajectory/trajectory.hpp>
#include <tests/proof/law.hpp>

#include <array>
#include <vector>

namespace pmreport::test {

struct Cubic {
  double from = 0;               // [s]
  std::array<double, 4> c = {};  // c0 + c1 s + c2 s^2 + c3 s^3, s = t - from
};
struct Pieces {
  std::vector<Cubic> cubics;  // rising; each to the next; the first counts before it too
  int continuous = 2;         // derivatives that are where two meet, the value for the first of them: 0 where it jumps, 1 at a kink

  Pieces(double constant) : cubics{{0, {constant, 0, 0, 0}}} {}
  Pieces(Cubic one) : cubics{one} {}
  Pieces(std::vector<Cubic> all, int derivatives) : cubics(std::move(all)), continuous(derivatives) {}
};

Law law_of(std::vector<Pieces> coordinates);
// From `begin` to `end` [s]; knots where pieces meet.
mechanics::Trajectory pieces_motion(std::vector<Pieces> coordinates, double begin, double end, int samples = 101);

}  // namespace pmreport::test
