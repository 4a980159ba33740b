#include <core/analysis/proof/claims.hpp>

#include <core/mechanics/model/joint_motion.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <span>

namespace pmreport::analysis {

namespace {

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

// Marks of a run, by their places: broken at every instant from the first of them to the last, or at an instant of some.
struct Row {
  std::size_t first, last;
  bool throughout;
};
std::vector<Row> rows_of(std::span<const Mark> run) {
  std::vector<Row> out;
  for (std::size_t k = 0; k < run.size(); ++k) {
    if (!run[k].broken_within) continue;
    const bool throughout = run[k].what == Mark::What::broken, alike = !out.empty() && run[out.back().last].above == run[k].above;
    if (!alike)
      out.push_back({k, k, throughout});
    else if (throughout && !out.back().throughout)
      out.back() = {k, k, true};
    else if (throughout && out.back().last + 1 < k)
      out.push_back({k, k, true});
    else if (throughout || !out.back().throughout)
      out.back().last = k;
  }
  return out;
}

// The stretch of a row. `beside`: it, and the undecided marks on either side of it.
Claim::Broken stretch(std::span<const Mark> row, std::span<const Mark> beside, bool throughout) {
  Claim::Broken out;
  out.above = row.front().above;
  // The farthest value is at least what is certain at some instant, and at most what bounds all of them.
  double certain = -infinity, bound = -infinity;  // beyond, counted away from the range
  for (const Mark& m : beside) {
    const double at_least = out.above ? m.value_at.low : -m.value_at.high, at_most = out.above ? m.value.high : -m.value.low;
    if (m.broken_within && m.above == out.above && at_least > certain) certain = at_least, out.at = m.at;
    bound = std::max(bound, at_most);
  }
  out.worst = out.above ? Bounds{certain, bound} : Bounds{-bound, -certain};
  out.begin = {beside.front().time.low, throughout ? row.front().time.low : out.at};
  out.end = {throughout ? row.back().time.high : out.at, beside.back().time.high};
  return out;
}

}  // namespace

std::vector<OpenClaim> claims_of(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const Quantities& quantities) {
  const Topology& t = machine.topology();
  std::vector<OpenClaim> out{{{Claim::About::assembled, 0, 0, {0, infinity}, Claim::State::holds, "", {}, {}}, 0}};
  for (std::size_t i = 0; i < t.actuators.size(); ++i)
    out.push_back(
        {{Claim::About::stroke, static_cast<int>(i), 0, t.actuators[i].stroke, Claim::State::holds, "", {}, {}}, quantities.actuators[i]});
  for (std::size_t k = 0; k < program.joints.size(); ++k) {
    const auto& [joint, limit, output] = program.joints[k];
    const Joint& j = t.joints[static_cast<std::size_t>(joint)];
    Range range = j.limits[static_cast<std::size_t>(limit)];
    const bool below = mechanics::binds(j, range, false), above = mechanics::binds(j, range, true);  // of the range as it is declared
    if (!below) range.min = -infinity;
    if (!above) range.max = infinity;
    out.push_back({{Claim::About::joint_limit, joint, limit, range, Claim::State::holds, "", {}, {}}, quantities.joints[k]});
  }
  for (const std::string& name : program.left_out) {
    const auto joint = std::ranges::find(t.joints, name, &Joint::name);
    for (std::size_t k = 0; k < joint->limits.size(); ++k)
      if (mechanics::binds(*joint, joint->limits[k], false) || mechanics::binds(*joint, joint->limits[k], true))
        out.push_back({{Claim::About::joint_limit,
                        static_cast<int>(joint - t.joints.begin()),
                        static_cast<int>(k),
                        joint->limits[k],
                        Claim::State::unexamined,
                        "it counts from a slender body, whose spin the geometry leaves open",
                        {},
                        {}},
                       -1});
  }
  out.push_back({{Claim::About::regular, 0, 0, {0, 0}, Claim::State::holds, "", {}, {}}, -1});
  return out;
}

Judgement judge(const OpenClaim& c, const SpanFacts& span, const Instants& instants) {
  if (c.claim.about == Claim::About::regular) return span.placed && span.regular ? Judgement::holds : Judgement::open;
  const auto q = static_cast<std::size_t>(c.quantity);
  const Bounds &value = span.value[q], &at_middle = instants.middle.value[q];
  const Range& range = c.claim.range;
  if (c.claim.about == Claim::About::assembled) {
    if (value.bounded() && value.low >= 0 && span.placed) return Judgement::holds;
    if (value.bounded() && value.high < 0) return Judgement::broken;
    return Judgement::open;
  }
  if (!value.bounded()) return Judgement::open;
  if (range.min <= value.low && value.high <= range.max) return Judgement::holds;
  if (leaves_range(value, range)) return Judgement::broken;
  // Rounding alone is left when the value at no instant is known better than over all of the span; at one alone it may jump.
  const bool met = (at_middle.low <= range.max && range.max < at_middle.high) || (at_middle.low < range.min && range.min <= at_middle.high);
  const double narrowest = std::min({at_middle.width(), instants.begin.value[q].width(), instants.end.value[q].width()});
  return met && value.width() <= 4 * narrowest ? Judgement::hopeless : Judgement::open;
}

Mark mark(const OpenClaim& c, Judgement judged, const SpanFacts& span, const Instants& instants) {
  Mark out;
  out.time = span.time;
  out.what = judged == Judgement::broken ? Mark::What::broken : Mark::What::undecided;
  out.at = instants.middle.time;
  if (c.claim.about == Claim::About::regular) {
    if (!span.finite_wrenches) out.what = Mark::What::unbounded;
    return out;
  }
  const auto q = static_cast<std::size_t>(c.quantity);
  const Range& range = c.claim.range;
  out.value = span.value[q];
  out.value_at = instants.middle.value[q];
  out.broken_within = judged == Judgement::broken;
  // Of the instants at which it is broken for certain the farthest beyond counts.
  double farthest = 0;
  for (const InstantFacts* f : {&instants.middle, &instants.begin, &instants.end}) {
    const Bounds& x = f->value[q];
    if (!(f->assembled || c.claim.about == Claim::About::assembled) || !leaves_range(x, range)) continue;
    const double beyond = std::max(x.low - range.max, range.min - x.high);
    out.broken_within = true;
    if (beyond > farthest) farthest = beyond, out.at = f->time, out.value_at = x;
  }
  const Bounds& told = out.broken_within ? out.value_at : out.value;
  out.above = out.broken_within ? told.low > range.max : told.high > range.max;
  return out;
}

void conclude(Claim& claim, std::vector<Mark> marks) {
  for (const std::vector<Mark>& run : runs_of(std::move(marks))) {
    const std::vector<Row> rows = rows_of(run);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::size_t from = r > 0 ? rows[r - 1].last + 1 : 0, to = r + 1 < rows.size() ? rows[r + 1].first : run.size();
      const std::span<const Mark> all(run);
      claim.broken.push_back(
          stretch(all.subspan(rows[r].first, rows[r].last - rows[r].first + 1), all.subspan(from, to - from), rows[r].throughout));
    }
    if (rows.empty()) claim.undecided.push_back({run.front().time.low, run.back().time.high});
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
