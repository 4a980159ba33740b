#include <core/mechanics/trajectory/forced.hpp>

#include <core/text/text.hpp>

#include <algorithm>

namespace pmreport::mechanics {

Forced forced(const Machine& machine, const ForwardProblem& problem) {
  ForwardMotion way = forward_dynamics(machine, problem);
  Forced out;
  out.outcome = way.outcome;
  out.reached = static_cast<std::size_t>(std::upper_bound(problem.times.begin(), problem.times.end(), way.ended) - problem.times.begin());
  Trajectory& t = out.trajectory;
  t.time = problem.times;
  t.value = std::move(way.value);
  t.rate = std::move(way.rate);
  t.acceleration = std::move(way.acceleration);
  t.at = std::move(way.at);
  t.ending = printable(way.ending);
  t.work = way.work[out.reached - 1];
  t.energy_drift = way.drift;
  t.energy_drift_share = way.drift_share;
  return out;
}

}  // namespace pmreport::mechanics
