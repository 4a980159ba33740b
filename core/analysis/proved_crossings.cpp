#include <core/analysis/proved_crossings.hpp>

#include <core/analysis/motion_search.hpp>

#include <algorithm>

namespace pmreport::analysis {

namespace {

bool of_the_surface(const Crossing& c) { return c.what == Crossing::What::surface || c.what == Crossing::What::pole; }

// Bisection tells a time to the rounding of det G, which is worth some of the last digits of the time.
constexpr double rounding = 1e-9;  // of the motion's duration

}  // namespace

void match_with_proof(std::vector<Crossing>& crossings, const MotionProof& proof, const mechanics::Trajectory& trajectory) {
  if (!proof.unexamined.empty() || trajectory.samples() == 0) return;
  const double slack = std::max(proof.resolution, rounding * (proof.end - proof.begin));
  PosesInTime motion(trajectory, static_cast<int>(trajectory.value.cols()));
  const std::vector<double>& t = trajectory.time;
  for (const Meeting& m : proof.meetings) {
    const auto found = std::ranges::find_if(crossings, [&](const Crossing& c) {
      return of_the_surface(c) && (!c.proved || c.lasts()) && c.until >= m.time.low - slack && c.time <= m.time.high + slack;
    });
    if (found != crossings.end()) {
      found->proved = found->proved ? hull(*found->proved, m.time) : m.time;
      continue;
    }
    if (m.what != Meeting::What::crossing) continue;
    const double time = m.time.middle();
    const auto after = std::ranges::upper_bound(t, time);
    const int before = std::max(0, static_cast<int>(after - t.begin()) - 1);
    crossings.push_back({before, time, time, motion.at(time), Crossing::What::surface, false, m.time, true});
  }
  // A pair that is nearer than the samples' search resolves looks to it like one touch.
  const std::vector<Crossing> all = crossings;
  std::erase_if(crossings, [&](const Crossing& c) {
    return of_the_surface(c) && c.touches && !c.proved && !c.lasts() &&
           std::ranges::count_if(all, [&](const Crossing& other) { return other.unseen && other.before == c.before; }) > 1;
  });
  std::ranges::stable_sort(crossings, {}, &Crossing::time);
}

}  // namespace pmreport::analysis
