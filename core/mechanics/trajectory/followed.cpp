#include <core/mechanics/trajectory/followed.hpp>

#include <core/mechanics/trajectory/singular_surface.hpp>
#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace pmreport::mechanics {

namespace {

std::string ending_of(Outcome outcome, double t, const std::string& why) {
  if (outcome == Outcome::singular && !why.empty())
    return fmt::format("ends at t = {} s: {}, and actuators that are prescribed cannot be followed in them", format_number(t, 6), why);
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
Path between(const Machine& machine, Drive drive, const std::vector<double>& times, FollowedMotion followed) {
  struct Way {
    Drive drive;
    std::vector<double> times;
    FollowedMotion samples;
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
    Follower follower(machine, way->drive);
    const Follower::Arrival a = follower.go(follower.waymark(*nearest, start), t, way->resolution);
    if (a.outcome != Outcome::good) return false;
    std::copy_n(a.at.value.data(), a.at.value.size(), value);
    std::copy_n(a.at.rate.data(), a.at.rate.size(), rate);
    std::copy_n(a.at.acceleration.data(), a.at.acceleration.size(), acceleration);
    return true;
  };
}

}  // namespace

Followed followed(const Machine& machine, Path actuators, std::vector<double> times, const SmallVector& start) {
  const Drive drive = [at = std::move(actuators)](double t, double* value, double* rate, double* acceleration) {
    at(t, value, rate, acceleration);
  };
  FollowedMotion way = follow(machine, drive, times, start);
  Followed out;
  out.reached = way.reached;
  out.outcome = way.outcome;
  out.trajectory.value = way.value;
  out.trajectory.rate = way.rate;
  out.trajectory.acceleration = way.acceleration;
  if (way.outcome != Outcome::good) out.trajectory.ending = ending_of(way.outcome, way.ending, way.why);
  out.trajectory.at = between(machine, drive, times, std::move(way));
  out.trajectory.time = std::move(times);
  return out;
}

}  // namespace pmreport::mechanics
