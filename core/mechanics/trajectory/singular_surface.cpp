#include <core/mechanics/trajectory/singular_surface.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/overall_jacobian.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

namespace pmreport::mechanics {

namespace {

// The side of the singular surface at a time: 0 on it; nothing where there is no pose.
class Along {
 public:
  Along(const Path& path, const Machine& machine)
      : path_(path), machine_(machine), length_(characteristic_length(machine)), q_(machine.dof()), unused_(machine.dof()) {}

  std::optional<int> side(double t) {
    if (!path_(t, q_.data(), unused_.data(), unused_.data())) return std::nullopt;
    const Pose pose = machine_.pose({q_.data(), static_cast<std::size_t>(q_.size())});
    if (pose.status != PM_OK) return std::nullopt;
    return side_of(machine_.jacobian(pose).matrix, length_);
  }

 private:
  const Path& path_;
  const Machine& machine_;
  double length_;
  SmallVector q_, unused_;
};

}  // namespace

std::optional<FirstSurface> first_singular_surface(const Trajectory& trajectory, const Machine& machine) {
  const std::vector<double>& t = trajectory.time;
  Along along(trajectory.at, machine);
  std::optional<int> before;  // at the sample before
  for (std::size_t k = 0; k < t.size(); ++k) {
    const std::optional<int> here = along.side(t[k]);
    if (!here || (before.value_or(*here) == *here && *here != 0)) {
      if (here) before = here;
      continue;
    }
    if (k == 0 || !before) return FirstSurface{k, t[k]};  // it begins there
    // The side at `left` is that before; at `right` it is not, or there is no pose.
    double left = t[k - 1], right = t[k];
    const double resolution = resolution_of_span * (t.back() - t.front());
    while (right - left > resolution) {
      const double middle = 0.5 * (left + right);
      (along.side(middle) == before ? left : right) = middle;
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
