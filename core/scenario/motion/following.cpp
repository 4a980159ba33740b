#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <core/mechanics/displacement/follow.hpp>
#include <core/scenario/parts.hpp>
#include <core/text/text.hpp>
#include <limits>
#include <memory>

namespace pmreport::scenario {
namespace {

using mechanics::Outcome;
using mechanics::SmallVector;

constexpr double resolution_of_span = 1e-10;  // of the whole motion: how exactly the time of an ending is found

std::string ending_of(Outcome outcome, double t, const std::string& why) {
  if (outcome == Outcome::singular)
    return fmt::format(
        "meets a singular surface at t = {} s: there the actuators no longer determine the pose, and beyond it no pose of this assembly "
        "mode "
        "has the actuator values that are asked for",
        format_number(t, 6));
  return fmt::format(
      "runs out of reach at t = {} s: beyond it no pose of this assembly and working mode has the actuator values that are asked for{}",
      format_number(t, 6), why.empty() ? "" : " (" + printable(why) + ")");
}

// At any time the coordinates are followed from the sample nearest to it.
Path between(const mechanics::Machine& machine, mechanics::Drive drive, const std::vector<double>& times,
             mechanics::FollowedMotion followed) {
  struct Way {
    mechanics::Drive drive;
    std::vector<double> times;
    mechanics::FollowedMotion samples;
    double resolution;
  };
  const double resolution = resolution_of_span * (times.back() - times.front());
  const auto way = std::make_shared<const Way>(Way{std::move(drive), times, std::move(followed), resolution});
  return [way, &machine](double t, double* value, double* rate, double* acceleration) {
    const auto& times = way->times;
    if (t > way->samples.ending || t < times.front()) return false;
    const auto reached = times.begin() + static_cast<std::ptrdiff_t>(way->samples.reached);
    auto nearest = std::lower_bound(times.begin(), reached, t);
    if (nearest == reached || (nearest != times.begin() && t - *(nearest - 1) < *nearest - t)) --nearest;
    const SmallVector start = way->samples.value.row(nearest - times.begin());
    mechanics::Follower follower(machine, way->drive);
    const mechanics::Follower::Arrival a = follower.go(follower.waymark(*nearest, start), t, way->resolution);
    if (a.outcome != Outcome::good) return false;
    std::copy_n(a.at.value.data(), a.at.value.size(), value);
    std::copy_n(a.at.rate.data(), a.at.rate.size(), rate);
    std::copy_n(a.at.acceleration.data(), a.at.acceleration.size(), acceleration);
    return true;
  };
}

// det G at a time; NaN where there is no pose.
double determinant_at(const Path& path, const mechanics::Machine& machine, double t) {
  const int dof = machine.dof();
  SmallVector q(dof), rate(dof), acceleration(dof);
  if (!path(t, q.data(), rate.data(), acceleration.data())) return std::numeric_limits<double>::quiet_NaN();
  const mechanics::Pose pose = machine.pose({q.data(), static_cast<std::size_t>(dof)});
  if (pose.status != PM_OK) return std::numeric_limits<double>::quiet_NaN();
  double g[36];
  machine.jacobian(PM_VALUE, 1, pose.numbers.data(), g);
  return Eigen::Map<const mechanics::Matrix6d>(g).determinant();  // of the transpose, which has the same
}

}  // namespace

bool cut_off(Motion& m, std::size_t samples, Place place, Diagnostics& diagnostics) {
  if (samples < 2) {
    diagnostics.add(place, fmt::format("the motion has no second sample: it {}", m.ending), "take more samples, or another motion");
    return false;
  }
  m.time.resize(samples);
  const auto rows = static_cast<Eigen::Index>(samples);
  for (Eigen::MatrixXd* part : {&m.value, &m.rate, &m.acceleration}) part->conservativeResize(rows, Eigen::NoChange);
  return true;
}

std::optional<Motion> followed(Motion drive, const mechanics::Machine& machine, bool until_singularity, Place place,
                               Diagnostics& diagnostics) {
  const mechanics::Drive prescribed = [at = drive.at](double t, double* value, double* rate, double* acceleration) {
    at(t, value, rate, acceleration);
  };
  const mechanics::Approach start = mechanics::approach(machine, machine.home(), drive.value.row(0).transpose());
  if (start.outcome != Outcome::good) {
    std::string home;
    const SmallVector values = mechanics::actuators_at(machine, machine.home());
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
  mechanics::FollowedMotion way = mechanics::follow(machine, prescribed, drive.time, start.coordinates);
  Motion out = std::move(drive);
  out.by_actuators = true;
  out.actuators = out.at;
  out.value = way.value;
  out.rate = way.rate;
  out.acceleration = way.acceleration;
  const std::size_t reached = way.reached;
  if (way.outcome != Outcome::good) out.ending = ending_of(way.outcome, way.ending, way.why);
  const bool cut = until_singularity && way.outcome == Outcome::singular;
  out.until_singularity = until_singularity;
  out.at = between(machine, prescribed, out.time, std::move(way));
  if (cut && !cut_off(out, reached, place, diagnostics)) return std::nullopt;
  return out;
}

bool end_at_singularity(Motion& motion, const mechanics::Machine& machine, Place place, Diagnostics& diagnostics) {
  motion.until_singularity = true;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < motion.time.size(); ++k) {
    const double here = determinant_at(motion.at, machine, motion.time[k]);
    if (!(before * here <= 0)) {
      before = here;
      continue;
    }
    // The sign at `left` is that before; at `right` it is not, or there is no pose.
    double left = motion.time[k - 1], right = motion.time[k];
    const double resolution = resolution_of_span * (motion.time.back() - motion.time.front());
    while (right - left > resolution) {
      const double middle = 0.5 * (left + right);
      (determinant_at(motion.at, machine, middle) * before > 0 ? left : right) = middle;
    }
    motion.ending =
        fmt::format("meets a singular surface at t = {} s: there the actuators do not hold the platform", format_number(left, 6));
    return cut_off(motion, k, place, diagnostics);
  }
  return true;
}

}  // namespace pmreport::scenario
