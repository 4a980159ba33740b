#include <core/scan/proof/ball.hpp>

#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>

#include <algorithm>

namespace pmreport::scan {

using program::Bounds, program::Interval;

BallAndBox relation(const Ball& ball, std::span<const Bounds> sides) {
  std::vector<double> middle;
  for (const Bounds& side : sides) middle.push_back(side.middle());
  return program::round_upward([&] {
    Interval over(0.0), at_middle(0.0), nearest(0.0);
    for (std::size_t q = 0; q < sides.size(); ++q) {
      const Interval proportion(ball.proportions[q]);
      const auto away = [&](const Interval& x) { return (x - ball.centre[q]) / proportion; };
      const Interval way = away(Interval(sides[q]));
      over += square(way);
      at_middle += square(away(Interval(middle[q])));
      nearest += square(Interval(std::clamp(ball.centre[q], sides[q].low, sides[q].high)) - ball.centre[q]) / square(proportion);
    }
    const Interval limit = square(Interval(ball.radius));
    return BallAndBox{over.bounded() && limit.high < over.low(), at_middle.bounded() && at_middle.high <= limit.low(),
                      nearest.bounded() && nearest.high <= limit.low()};
  });
}

}  // namespace pmreport::scan
