#include <core/mechanics/singularity/end_of_reach.hpp>

#include <core/mechanics/model/effort.hpp>

#include <cmath>
#include <limits>

namespace pmreport::mechanics {

std::optional<EndOfReach> end_of_reach(const Machine& machine, const SmallVector& coordinates, double length) {
  const Topology& t = machine.topology();
  const auto dof = static_cast<std::size_t>(machine.dof());
  const std::size_t components = 1 + dof, first = machine.layout().actuator(0);
  std::vector<double> partials(machine.layout().size() * components), jets(machine.layout().size() * 3), along(3 * dof);
  if (machine.place(PM_PARTIALS, 1, coordinates.data(), partials.data()) != PM_OK) return std::nullopt;
  std::vector<double> distances(dof, std::numeric_limits<double>::infinity());
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < dof; ++i) {
    double steepness = 0;
    for (std::size_t k = 0; k < dof; ++k) {
      const double unit = size_of(t.coordinates[k].sense(), length) / length;  // of a coordinate, for a way of one metre
      along[3 * k + 1] = partials[(first + i) * components + 1 + k] * unit;
      steepness += along[3 * k + 1] * along[3 * k + 1];
    }
    steepness = std::sqrt(steepness);
    if (!(steepness > 0)) continue;
    for (std::size_t k = 0; k < dof; ++k) {
      const double unit = size_of(t.coordinates[k].sense(), length) / length;
      along[3 * k] = coordinates(static_cast<Eigen::Index>(k));
      along[3 * k + 1] *= unit / steepness;
      along[3 * k + 2] = 0;
    }
    if (machine.place(PM_JET, 1, along.data(), jets.data()) != PM_OK) continue;
    const double slope = jets[3 * (first + i) + 1], bend = jets[3 * (first + i) + 2];
    if (bend != 0) distances[i] = std::abs(slope / (2 * bend));
    nearest = std::min(nearest, distances[i]);
  }
  if (!(nearest < near_end * length)) return std::nullopt;
  EndOfReach out{nearest, {}};
  for (std::size_t i = 0; i < dof; ++i)
    if (distances[i] <= 2 * nearest) out.actuators.push_back(static_cast<int>(i));
  return out;
}

}  // namespace pmreport::mechanics
