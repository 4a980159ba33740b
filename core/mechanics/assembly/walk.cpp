#include <core/mechanics/assembly/walk.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pmreport::mechanics {

namespace {

constexpr std::size_t together = 16;  // poses: enough for every width of register, few enough for the cache

}  // namespace

AssemblyTarget::AssemblyTarget(std::span<const std::unique_ptr<Machine>> words, const Eigen::VectorXd& actuators)
    : words_(words), actuators_(actuators), actuator_scale_(actuators.size()), coordinate_scale_(actuators.size()) {
  const Machine& m = *words.front();
  const Topology& t = m.topology();
  double size = 0;
  for (int i = 0; i < static_cast<int>(t.joints.size()); ++i)
    size = std::max(size, (m.centre(m.home_pose(), i) - m.centre(m.home_pose(), 0)).norm());
  if (size > 0) size_ = size;
  for (std::size_t i = 0; i < t.coordinates.size(); ++i) {
    is_angle_.push_back(t.coordinates[i].sense() == Sense::rotary);
    is_turn_.push_back(t.actuators[i].sense() == Sense::rotary);
    coordinate_scale_(static_cast<Eigen::Index>(i)) = is_angle_.back() ? 1 : size_;
    actuator_scale_(static_cast<Eigen::Index>(i)) = is_turn_.back() ? 1 : size_;
  }
}

SmallVector AssemblyTarget::error(const SmallVector& actuators) const {
  SmallVector e = (actuators_ - actuators).cwiseQuotient(actuator_scale_);
  for (Eigen::Index i = 0; i < e.size(); ++i)
    if (is_turn_[static_cast<std::size_t>(i)]) e(i) = std::remainder(e(i), 2 * std::numbers::pi);
  return e;
}

void AssemblyPlacer::place(std::span<Site*> sites) {
  std::stable_sort(sites.begin(), sites.end(), [](const Site* a, const Site* b) { return a->word < b->word; });
  for (std::size_t i = 0; i < sites.size();) {
    std::size_t end = i;
    while (end < sites.size() && end < i + together && sites[end]->word == sites[i]->word) ++end;
    place_together(sites.subspan(i, end - i));
    i = end;
  }
}

void AssemblyPlacer::place_together(std::span<Site*> sites) {
  const Machine& machine = target_.machine(sites.front()->word);
  const Eigen::Index m = target_.dof();
  const std::size_t n = sites.size(), dof = static_cast<std::size_t>(m), components = 1 + dof;
  coordinates_.resize(dof * n);
  placements_.resize(machine.layout().size() * components * n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < dof; ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      coordinates_[i * n + k] = sites[k]->u(at) * target_.coordinate_scale(at);
    }
  const pm_status status = machine.place(PM_PARTIALS, n, coordinates_.data(), placements_.data());
  const double* actuators = placements_.data() + machine.layout().actuator(0) * components * n;
  SmallVector values(m);
  for (std::size_t k = 0; k < n; ++k) {
    Site& s = *sites[k];
    s.reached = status == PM_OK && placements_[k] >= 0;
    s.slope.resize(m, m);
    for (Eigen::Index i = 0; i < m; ++i) {
      const double* scalar = actuators + static_cast<std::size_t>(i) * components * n + k;
      values(i) = *scalar;
      for (Eigen::Index j = 0; j < m; ++j)
        s.slope(i, j) = scalar[static_cast<std::size_t>(1 + j) * n] * target_.coordinate_scale(j) / target_.actuator_scale(i);
    }
    s.error = target_.error(values);
    s.reached = s.reached && s.error.allFinite() && s.slope.allFinite();
  }
}

std::vector<double> AssemblyPlacer::misses(std::size_t word, std::span<const SmallVector> poses) {
  const Machine& machine = target_.machine(word);
  const std::size_t n = poses.size(), dof = static_cast<std::size_t>(target_.dof());
  coordinates_.resize(dof * n);
  placements_.resize(machine.layout().size() * n);
  for (std::size_t k = 0; k < n; ++k) {
    const SmallVector q = target_.coordinates(poses[k]);
    for (std::size_t i = 0; i < dof; ++i) coordinates_[i * n + k] = q(static_cast<Eigen::Index>(i));
  }
  std::vector<double> out(n, std::numeric_limits<double>::infinity());
  if (machine.place(PM_VALUE, n, coordinates_.data(), placements_.data()) != PM_OK) return out;
  SmallVector values(target_.dof());
  for (std::size_t k = 0; k < n; ++k) {
    if (!(placements_[k] >= 0)) continue;
    for (std::size_t i = 0; i < dof; ++i) values(static_cast<Eigen::Index>(i)) = placements_[(machine.layout().actuator(0) + i) * n + k];
    const double miss = target_.error(values).lpNorm<Eigen::Infinity>();
    if (std::isfinite(miss)) out[k] = miss;
  }
  return out;
}

}  // namespace pmreport::mechanics
