#include <core/analysis/proof/claims.hpp>

#include <core/mechanics/model/joint_motion.hpp>

#include <algorithm>
#include <limits>
#include <span>

namespace pmreport::analysis {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Marks that touch one another make one run.
std::vector<std::vector<Mark>> runs_of(std::vector<Mark> marks) {
  std::ranges::sort(marks, {}, [](const Mark& m) { return m.time.low; });
  std::vector<std::vector<Mark>> out;
  for (const Mark& m : marks) {
    if (out.empty() || out.back().back().time.high < m.time.low) out.emplace_back();
    out.back().push_back(m);
  }
  return out;
}

bool leaves_range(const Bounds& value, const Range& range) { return value.bounded() && (value.low > range.max || value.high < range.min); }

// A stretch from mark `first` to mark `last` of a run, all broken alike; `from` to `to`: the marks that are not decided on either side of
// it are in.
Claim::Broken stretch(std::span<const Mark> marks, double from, double to) {
  const Mark &first = marks.front(), &last = marks.back();
  Claim::Broken out;
  out.above = first.above;
  out.begin = {from, first.what == Mark::What::broken ? first.time.low : first.at};
  out.end = {last.what == Mark::What::broken ? last.time.high : last.at, to};
  // The farthest value is at least what is certain at some instant, and at most what bounds all of them.
  double certain = -infinite, bound = -infinite;  // beyond, counted away from the range
  for (const Mark& m : marks) {
    const double at_least = m.above ? m.value_at.low : -m.value_at.high, at_most = m.above ? m.value.high : -m.value.low;
    if (at_least > certain) certain = at_least, out.at = m.at;
    bound = std::max(bound, at_most);
  }
  out.worst = out.above ? Bounds{certain, bound} : Bounds{-bound, -certain};
  return out;
}

}  // namespace

std::vector<OpenClaim> claims_of(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const Quantities& quantities) {
  const Topology& t = machine.topology();
  std::vector<OpenClaim> out{{{}, 0}};
  out[0].claim.range = {0, infinite};
  for (std::size_t i = 0; i < t.actuators.size(); ++i)
    out.push_back(
        {{Claim::About::stroke, static_cast<int>(i), 0, t.actuators[i].stroke, Claim::State::holds, "", {}, {}}, quantities.actuators[i]});
  for (std::size_t k = 0; k < program.joints.size(); ++k) {
    const auto& [joint, limit, output] = program.joints[k];
    const Joint& j = t.joints[static_cast<std::size_t>(joint)];
    Range range = j.limits[static_cast<std::size_t>(limit)];
    if (!mechanics::binds(j, range, false)) range.min = -infinite;
    if (!mechanics::binds(j, range, true)) range.max = infinite;
    out.push_back({{Claim::About::joint_limit, joint, limit, range, Claim::State::holds, "", {}, {}}, quantities.joints[k]});
  }
  out.push_back({{Claim::About::regular, 0, 0, {0, 0}, Claim::State::holds, "", {}, {}}, -1});
  return out;
}

Judgement judge(const OpenClaim& c, const SpanFacts& span, const InstantFacts& middle) {
  if (c.claim.about == Claim::About::regular) {
    if (!span.placed) return Judgement::open;
    if (span.regular) return Judgement::holds;
    return Judgement::open;
  }
  const auto q = static_cast<std::size_t>(c.quantity);
  const Bounds &value = span.value[q], &at_middle = middle.value[q];
  const Range& range = c.claim.range;
  if (c.claim.about == Claim::About::assembled) {
    if (value.bounded() && value.low >= 0 && span.placed) return Judgement::holds;
    if (value.bounded() && value.high < 0) return Judgement::broken;
    return Judgement::open;
  }
  if (!value.bounded()) return Judgement::open;
  if (range.min <= value.low && value.high <= range.max) return Judgement::holds;
  if (leaves_range(value, range)) return Judgement::broken;
  // Rounding alone is left when the value at an instant is not known better than over all of the span.
  const bool met = (at_middle.low <= range.max && range.max < at_middle.high) || (at_middle.low < range.min && range.min <= at_middle.high);
  if (met && value.width() <= 4 * at_middle.width()) return Judgement::hopeless;
  return Judgement::open;
}

Mark mark(const OpenClaim& c, Judgement judged, const SpanFacts& span, const InstantFacts& middle) {
  Mark out;
  out.time = span.time;
  out.what = judged == Judgement::broken ? Mark::What::broken : Mark::What::undecided;
  out.at = middle.time;
  if (c.claim.about == Claim::About::regular) {
    if (!span.finite_wrenches) out.what = Mark::What::unbounded;
    return out;
  }
  const auto q = static_cast<std::size_t>(c.quantity);
  out.value = span.value[q];
  out.value_at = middle.value[q];
  out.broken_within = judged == Judgement::broken || leaves_range(out.value_at, c.claim.range);
  const Bounds& told = out.broken_within ? out.value_at : out.value;
  out.above = out.broken_within ? told.low > c.claim.range.max : told.high > c.claim.range.max;
  return out;
}

void conclude(Claim& claim, std::vector<Mark> marks) {
  for (const std::vector<Mark>& run : runs_of(std::move(marks))) {
    bool any = false;
    const auto alike = [&](std::size_t i, std::size_t k) {
      return run[i].broken_within && run[k].broken_within && run[i].above == run[k].above;
    };
    for (std::size_t first = 0; first < run.size(); ++first) {
      if (!run[first].broken_within || (first > 0 && alike(first - 1, first))) continue;
      std::size_t last = first, before = first, after;
      while (last + 1 < run.size() && alike(last, last + 1)) ++last;
      while (before > 0 && !run[before - 1].broken_within) --before;
      after = last;
      while (after + 1 < run.size() && !run[after + 1].broken_within) ++after;
      claim.broken.push_back(stretch(std::span(run).subspan(first, last - first + 1), run[before].time.low, run[after].time.high));
      any = true;
    }
    if (!any) claim.undecided.push_back({run.front().time.low, run.back().time.high});
  }
  claim.state = !claim.broken.empty() ? Claim::State::broken : !claim.undecided.empty() ? Claim::State::undecided : Claim::State::holds;
}

std::vector<Meeting> meetings_of(std::vector<Mark> marks) {
  std::vector<Meeting> out;
  for (const std::vector<Mark>& run : runs_of(std::move(marks))) {
    const int before = run.front().side_before, after = run.back().side_after;
    const bool unbounded = std::ranges::any_of(run, [](const Mark& m) { return m.what == Mark::What::unbounded; });
    const Bounds time{run.front().time.low, run.back().time.high};
    out.push_back({unbounded ? Meeting::What::unbounded : before * after < 0 ? Meeting::What::crossing : Meeting::What::touch, time});
  }
  return out;
}

}  // namespace pmreport::analysis
