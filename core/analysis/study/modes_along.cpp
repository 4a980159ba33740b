#include <core/analysis/study/modes_along.hpp>

#include <algorithm>

namespace pmreport::analysis {

namespace {

constexpr double at_home_again = 1e-7;  // of the characteristic length: the motion ends where it began

}  // namespace

ModesAlong modes_along(const Analysis& a, const mechanics::AssemblyModes& found, int sample, const mechanics::AssemblyOptions& options) {
  const mechanics::Trajectory& motion = a.trajectory();
  const mechanics::PoseAt pose = [&](double t) {
    Eigen::VectorXd q(a.machine().dof()), rate(q.size()), acceleration(q.size());
    if (!motion.at(t, q.data(), rate.data(), acceleration.data())) return mechanics::Pose{};
    return a.machine().pose({q.data(), static_cast<std::size_t>(q.size())});
  };
  // Both ends that have a pose, and three times between.
  int first = 0, last = a.samples() - 1;
  while (first < sample && a.outcome(first) == Outcome::unreachable) ++first;
  while (last > sample && a.outcome(last) == Outcome::unreachable) --last;
  std::vector<mechanics::LookedAt> looked{{first, options}, {last, options}};
  mechanics::AssemblyOptions quick = options;
  quick.quiet_arrivals = 60;
  quick.most_starts = 300;
  quick.joint_starts = 0;
  for (const int quarter : {2, 1, 3}) looked.push_back({first + (last - first) * quarter / 4, quick});
  std::vector<mechanics::LookedAt> unlike;
  for (const mechanics::LookedAt& l : looked)
    if (l.sample != sample && std::ranges::none_of(unlike, [&](const auto& u) { return u.sample == l.sample; })) unlike.push_back(l);
  ModesAlong out;
  out.tracks = mechanics::follow_assembly_modes(found, a.time(), pose, sample, unlike, a.length());
  out.closed = last > first && mechanics::distance(a.machine(), a.pose(first), a.pose(last), a.length()) < at_home_again * a.length();
  // As the table of the modes found has them; those found later go on from there.
  out.numbers.assign(out.tracks.tracks.size(), 0);
  for (std::size_t k = 0; k < found.modes.size(); ++k)
    if (const std::size_t track = out.tracks.of_found[k]; track < out.numbers.size()) out.numbers[track] = k + 1;
  std::size_t next = found.modes.size();
  for (std::size_t& n : out.numbers)
    if (n == 0) n = ++next;
  return out;
}

}  // namespace pmreport::analysis
