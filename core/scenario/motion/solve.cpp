#include <core/scenario/motion/solve.hpp>

#include <fmt/format.h>

#include <cmath>
#include <core/mechanics/trajectory/followed.hpp>
#include <core/mechanics/trajectory/forced.hpp>
#include <core/mechanics/trajectory/singular_surface.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

using mechanics::Outcome;
using mechanics::Trajectory;

// Keeps the first samples of a motion. False, told, when they make none.
bool cut_off(Trajectory& m, std::size_t samples, Place place, Diagnostics& diagnostics) {
  if (samples < 2) {
    diagnostics.add(place, fmt::format("the motion has no second sample: it {}", m.ending), "take more samples, or another motion");
    return false;
  }
  mechanics::cut_off(m, samples);
  return true;
}

}  // namespace

namespace {

// No machine is that large; beyond it lengths and their squares lose each other in rounding, and reasons told for it mislead.
constexpr double beyond_reason = 1e9;  // m, rad

bool in_proportion(double value, const Law& law, double t, Diagnostics& diagnostics) {
  if (std::abs(value) <= beyond_reason) return true;
  diagnostics.add(law.place,
                  fmt::format("{} is {} {} at t = {} s, out of all proportion to a machine", law.name, format_number(value, 6), law.unit,
                              format_number(t, 6)),
                  "look at its unit, and at the exponents");
  return false;
}

}  // namespace

std::optional<Trajectory> sampled(const Laws& laws, const MotionRequest& request, std::vector<double> times, Diagnostics& diagnostics) {
  Trajectory out = mechanics::sampled(request.prescribed, std::move(times), static_cast<int>(laws.laws.size()));
  bool sound = true;
  for (Eigen::Index j = 0; j < out.value.cols(); ++j)
    for (Eigen::Index i = 0; i < out.value.rows(); ++i) {
      const Law& law = laws.laws[static_cast<std::size_t>(j)];
      const Jet<double> x(out.value(i, j), out.rate(i, j), out.acceleration(i, j));
      const double t = out.time[static_cast<std::size_t>(i)];
      if (finite(x, t, law.place, law.name, diagnostics) && in_proportion(x.value, law, t, diagnostics)) continue;
      sound = false;
      break;
    }
  return sound ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<Trajectory> end_at_singularity(Trajectory trajectory, const mechanics::Machine& machine, Place place,
                                             Diagnostics& diagnostics) {
  const std::size_t before = mechanics::end_at_singular_surface(trajectory, machine);
  if (before < trajectory.time.size() && !cut_off(trajectory, before, place, diagnostics)) return std::nullopt;
  return trajectory;
}

std::optional<Trajectory> followed(const MotionRequest& request, const Trajectory& actuators, const mechanics::Machine& machine,
                                   Place place, Diagnostics& diagnostics) {
  const mechanics::Approach start = mechanics::approach(machine, machine.home(), actuators.value.row(0).transpose());
  if (start.outcome != Outcome::good) {
    std::string home;
    const mechanics::SmallVector values = mechanics::actuators_at(machine, machine.home());
    for (int i = 0; i < values.size(); ++i) {
      const Actuator& a = machine.topology().actuators[static_cast<std::size_t>(i)];
      const DisplayUnit unit = display_unit(a.unit, std::abs(values(i)));
      home += fmt::format("{}{} = {} {}", i > 0 ? ", " : "", a.name, format_number(values(i) * unit.per_si, 6), unit.label);
    }
    diagnostics.add(place,
                    fmt::format("the actuators cannot be brought from home to their first values: {} of the way there is {}{}",
                                format_number(100 * start.share, 3) + " %",
                                start.outcome == Outcome::singular ? "a singular surface" : "the edge of reach",
                                start.why.empty() ? "" : " (" + printable(start.why) + ")"),
                    "start nearer to home, where " + home);
    return std::nullopt;
  }
  mechanics::Followed way = mechanics::followed(machine, request.prescribed, actuators.time, start.coordinates);
  const bool cut = request.until_singularity && way.outcome == Outcome::singular;
  if (cut && !cut_off(way.trajectory, way.reached, place, diagnostics)) return std::nullopt;
  return std::move(way.trajectory);
}

std::optional<Trajectory> forced(const Forces& forces, const MotionRequest& request, const Load& load, std::vector<double> times,
                                 const mechanics::Machine& machine, Diagnostics& diagnostics) {
  if (!finite_at_start(forces, machine, times.front(), diagnostics)) return std::nullopt;
  mechanics::ForwardProblem problem;
  problem.actuator_forces = request.forces;
  problem.load = load.at;
  problem.gravity = load.gravity;
  problem.start = forces.start;
  problem.start_rate = forces.start_rate;
  problem.times = std::move(times);
  mechanics::Forced way;
  try {
    way = mechanics::forced(machine, problem);
  } catch (const mechanics::MechanismError& e) {
    if (e.status != PM_BAD_ARGUMENT) throw;
    diagnostics.add(forces.place, fmt::format("the motion cannot begin: {}", printable(e.what())));
    return std::nullopt;
  }
  const bool allowed = (way.outcome == mechanics::Outcome::singular && forces.until_singularity) ||
                       (way.outcome == mechanics::Outcome::at_limit && forces.until_limit);
  if (allowed && !cut_off(way.trajectory, way.reached, forces.place, diagnostics)) return std::nullopt;
  return std::move(way.trajectory);
}

}  // namespace pmreport::scenario
