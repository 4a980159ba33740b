#include <core/analysis/samples/motion_probe.hpp>

namespace pmreport::analysis {

bool MotionProbe::go(double t) {
  time_ = t;
  if (!trajectory_.at(t, value_.data(), rate_.data(), acceleration_.data())) return false;
  evaluate(machine_, value_.data(), rate_.data(), acceleration_.data(), state_);
  return state_.status == PM_OK;
}

double MotionProbe::energy() const { return kinetic_energy(machine_, state_) + potential_energy(machine_, state_, load_.gravity); }

void MotionProbe::powers(std::vector<double>& out) const {
  const mechanics::Loading loading{load_.at(time_), load_.gravity};
  const mechanics::SmallVector forces = virtual_work(machine_, state_, tangent(machine_, state_), loading).total();
  out.clear();
  for (std::size_t i = 0; i < state_.actuators.size(); ++i) out.push_back(forces(static_cast<Eigen::Index>(i)) * state_.actuators[i].rate);
  out.push_back(loading.platform.dot(state_.bodies[static_cast<std::size_t>(machine_.topology().platform)].twist()));
}

}  // namespace pmreport::analysis
