#include <core/analysis/study/given_forces.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

double given_against_found(const Analysis& a) {
  const std::vector<Actuator>& actuators = a.machine().topology().actuators;
  std::vector<mechanics::Scalar> x(actuators.size());
  std::vector<double> given(actuators.size());
  double deviation = nan, scale = 0;
  for (const Actuator& actuator : actuators)
    for (const OfActuator share : {OfActuator::load_force, OfActuator::gravity_force, OfActuator::inertia_force})
      scale = std::max(scale, a.largest({column_of(actuator, share)}));
  for (int k = 0; k < a.samples(); ++k) {
    const auto sample = static_cast<std::size_t>(k);
    if (!std::isfinite(a.column(column_of(OfMachine::total_power))[sample])) continue;
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = {a.column(column_of(actuators[i]))[sample], a.column(column_of(actuators[i], OfMotion::rate))[sample], 0};
    a.scenario().motion->forces(a.time()[sample], x, given.data());
    for (std::size_t i = 0; i < x.size(); ++i)
      deviation = std::fmax(deviation, std::abs(given[i] - a.column(column_of(actuators[i], OfActuator::dynamic_force))[sample]));
  }
  return scale > 0 ? deviation / scale : deviation;
}

}  // namespace pmreport::analysis
