#include <core/mechanics/trajectory/singular_surface.hpp>

#include <core/mechanics/displacement/displacement.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <Eigen/LU>
#include <limits>

namespace pmreport::mechanics {

namespace {

// det G at a time; NaN where there is no pose.
double determinant_at(const Path& path, const Machine& machine, double t) {
  const int dof = machine.dof();
  SmallVector q(dof), rate(dof), acceleration(dof);
  if (!path(t, q.data(), rate.data(), acceleration.data())) return std::numeric_limits<double>::quiet_NaN();
  const Pose pose = machine.pose({q.data(), static_cast<std::size_t>(dof)});
  if (pose.status != PM_OK) return std::numeric_limits<double>::quiet_NaN();
  double g[36];
  machine.jacobian(PM_VALUE, 1, pose.numbers.data(), g);
  return Eigen::Map<const Matrix6d>(g).determinant();  // of the transpose, which has the same
}

}  // namespace

std::optional<FirstSurface> first_singular_surface(const Trajectory& trajectory, const Machine& machine) {
  const std::vector<double>& t = trajectory.time;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < t.size(); ++k) {
    const double here = determinant_at(trajectory.at, machine, t[k]);
    if (!(before * here <= 0)) {
      before = here;
      continue;
    }
    // The sign at `left` is that before; at `right` it is not, or there is no pose.
    double left = t[k - 1], right = t[k];
    const double resolution = resolution_of_span * (t.back() - t.front());
    while (right - left > resolution) {
      const double middle = 0.5 * (left + right);
      (determinant_at(trajectory.at, machine, middle) * before > 0 ? left : right) = middle;
    }
    return FirstSurface{k, left};
  }
  return std::nullopt;
}

std::size_t end_at_singular_surface(Trajectory& trajectory, const Machine& machine) {
  const auto met = first_singular_surface(trajectory, machine);
  if (!met) return trajectory.time.size();
  trajectory.ending =
      fmt::format("meets a singular surface at t = {} s: there the actuators do not hold the platform", format_number(met->time, 6));
  return met->before;
}

}  // namespace pmreport::mechanics
