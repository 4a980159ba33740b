#include <core/scan/safe_poses.hpp>

#include <core/scan/proof/containment.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pmreport::scan {

namespace {

using program::Bounds;
using Kind = Containment::Answer::Kind;

// Proportions of the free axes.
std::vector<double> proportions_of(const std::vector<FreeAxis>& axes, const Scan& scan, const std::vector<double>& asked) {
  std::vector<double> out;
  if (!asked.empty() && asked.size() != scan.points.size())
    throw std::invalid_argument(
        fmt::format("{} proportions for {} scanned coordinates; one each is expected", asked.size(), scan.points.size()));
  for (const FreeAxis& axis : axes) {
    out.push_back(asked.empty() ? 0.5 * axis.range.width() : asked[axis.point_axis]);
    if (!(out.back() > 0 && std::isfinite(out.back())))
      throw std::invalid_argument(fmt::format("proportion {} is {}; a positive number is expected", axis.point_axis + 1, out.back()));
  }
  return out;
}

// Why nothing can be grown about the centre; empty: it can.
std::string refusal(Containment& containment, const Scan& scan, const std::vector<double>& centre) {
  for (std::size_t a = 0; a < scan.points.size(); ++a) {
    const Axis& axis = scan.points[a];
    if (!(std::min(axis.from, axis.to) <= centre[a] && centre[a] <= std::max(axis.from, axis.to)))
      return fmt::format("the centre lies outside the scanned range of coordinate {}", a + 1);
  }
  std::vector<Bounds> point;
  for (const FreeAxis& axis : containment.axes()) point.push_back(Bounds::exactly(centre[axis.point_axis]));
  const Containment::Answer answer = containment.ask(point);
  if (answer.kind == Kind::outside) return fmt::format("margin {} is negative there", answer.margin);
  if (answer.kind == Kind::open) return fmt::format("margin {} could not be decided there", answer.margin);
  return {};
}

// The greatest x between `from`, which is well, and `to` that is found well, to `close_enough`(x); and the answer at the least that is not.
struct Limit {
  double reached = 0;
  Containment::Answer beyond;  // inside: all of it is well
};
template <class F, class G>
Limit farthest(double from, double to, F&& ask, G&& close_enough) {
  Limit limit{to, ask(to)};
  if (limit.beyond.kind == Kind::inside) return limit;
  limit.reached = from;
  while (std::abs(to - limit.reached) > close_enough(limit.reached)) {
    const double x = limit.reached + 0.5 * (to - limit.reached);
    if (x == limit.reached || x == to) break;
    const Containment::Answer answer = ask(x);
    if (answer.kind == Kind::inside)
      limit.reached = x;
    else
      to = x, limit.beyond = answer;
  }
  return limit;
}

}  // namespace

// A face is moved over poses that are asked for alone: what it left behind is known to belong to the set. Where it stops it stays, however
// the others move later: they only add poses to those beyond it. So one turn over the faces is enough.
SafeBox safe_box(const PoseSet& set, const Scan& scan, const std::vector<double>& centre, const SafeOptions& options, const Watch& watch) {
  Containment containment(set, scan, options.boxes, watch);
  const std::vector<FreeAxis>& axes = containment.axes();
  const std::vector<double> proportions = proportions_of(axes, scan, options.proportions);
  SafeBox out;
  out.why = refusal(containment, scan, centre);
  out.boxes = containment.boxes();
  if (!out.why.empty()) return out;

  std::vector<double> middle;
  double greatest = 0;
  for (std::size_t q = 0; q < axes.size(); ++q) {
    const double c = middle.emplace_back(centre[axes[q].point_axis]);
    greatest = std::max({greatest, (c - axes[q].range.low) / proportions[q], (axes[q].range.high - c) / proportions[q]});
  }
  const auto box_of = [&](double scale) {
    std::vector<Bounds> sides;
    for (std::size_t q = 0; q < axes.size(); ++q)
      sides.push_back({std::max(axes[q].range.low, middle[q] - scale * proportions[q]),
                       std::min(axes[q].range.high, middle[q] + scale * proportions[q])});
    return sides;
  };
  const Limit whole = farthest(
      0.0, greatest, [&](double scale) { return containment.ask(box_of(scale)); },
      [&](double scale) { return options.accuracy * std::max(scale, options.accuracy * greatest); });
  std::vector<Bounds> sides = whole.reached > 0 ? box_of(whole.reached) : std::vector<Bounds>();
  if (sides.empty())
    for (const double c : middle) sides.push_back(Bounds::exactly(c));

  const std::size_t all = scan.points.size();
  out.low_margin.assign(all, -1), out.high_margin.assign(all, -1);
  out.low_sharp.assign(all, false), out.high_sharp.assign(all, false);
  for (const bool upper : {false, true})
    for (std::size_t q = 0; q < axes.size(); ++q) {
      const double from = upper ? sides[q].high : sides[q].low, to = upper ? axes[q].range.high : axes[q].range.low;
      if (from == to) continue;
      const auto beyond = [&](double x) {
        std::vector<Bounds> added = sides;
        added[q] = {std::min(from, x), std::max(from, x)};
        return containment.ask(added);
      };
      const Limit limit = farthest(from, to, beyond, [&](double x) {
        return options.accuracy * std::max(std::abs(x - middle[q]), options.accuracy * axes[q].range.width());
      });
      (upper ? sides[q].high : sides[q].low) = limit.reached;
      if (limit.beyond.kind == Kind::inside) continue;
      const std::size_t a = axes[q].point_axis;
      (upper ? out.high_margin : out.low_margin)[a] = limit.beyond.margin;
      (upper ? out.high_sharp : out.low_sharp)[a] = limit.beyond.kind == Kind::outside;
    }

  out.boxes = containment.boxes();
  for (const double c : centre) out.sides.push_back(Bounds::exactly(c));
  for (std::size_t q = 0; q < axes.size(); ++q) out.sides[axes[q].point_axis] = sides[q];
  out.found = true;
  return out;
}

SafeBall safe_ball(const PoseSet& set, const Scan& scan, const std::vector<double>& centre, const SafeOptions& options,
                   const Watch& watch) {
  Containment containment(set, scan, options.boxes, watch);
  const std::vector<FreeAxis>& axes = containment.axes();
  Ball ball{{}, proportions_of(axes, scan, options.proportions), 0};
  SafeBall out;
  out.why = refusal(containment, scan, centre);
  out.boxes = containment.boxes();
  if (!out.why.empty()) return out;

  double greatest = std::numeric_limits<double>::infinity();  // that stays within the scanned range
  for (std::size_t q = 0; q < axes.size(); ++q) {
    const double c = ball.centre.emplace_back(centre[axes[q].point_axis]);
    greatest = std::min({greatest, (c - axes[q].range.low) / ball.proportions[q], (axes[q].range.high - c) / ball.proportions[q]});
  }
  if (axes.empty()) greatest = 0;
  const auto ask = [&](double radius) {
    ball.radius = radius;
    std::vector<Bounds> sides;
    for (std::size_t q = 0; q < axes.size(); ++q) {
      // A hair wider than the ball, so that rounding leaves nothing of it out.
      const double half = radius * ball.proportions[q] * (1 + 1e-15) + 1e-15 * std::abs(ball.centre[q]);
      sides.push_back({ball.centre[q] - half, ball.centre[q] + half});
    }
    return containment.ask(sides, ball);
  };
  const Limit limit = farthest(0.0, greatest, ask, [&](double r) { return options.accuracy * std::max(r, options.accuracy * greatest); });
  out.found = true;
  out.radius = limit.reached;
  out.boxes = containment.boxes();
  if (limit.beyond.kind == Kind::inside) return out;
  out.margin = limit.beyond.margin;
  out.sharp = limit.beyond.kind == Kind::outside;
  return out;
}

}  // namespace pmreport::scan
