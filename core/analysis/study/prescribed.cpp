#include <core/analysis/study/prescribed.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

PrescribedDeviation prescribed_deviation(const Analysis& a) {
  const mechanics::Trajectory& motion = a.trajectory();
  const Topology& t = a.machine().topology();
  const auto unit = [&](const std::string& name) { return name == "m" ? a.length() : 1.0; };
  const std::size_t dof = t.actuators.size();
  std::vector<double> value(dof), rate(dof), acceleration(dof);
  PrescribedDeviation worst;
  for (int k = 0; k < a.samples(); ++k) {
    if (!motion.value.row(k).allFinite()) continue;
    const auto sample = static_cast<std::size_t>(k);
    a.scenario().motion->prescribed(a.time()[sample], value.data(), rate.data(), acceleration.data());
    double fastest = 0, hardest = 0;
    for (std::size_t i = 0; i < dof; ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const double q_unit = unit(t.coordinates[i].unit), l_unit = unit(t.actuators[i].unit);
      fastest = std::max({fastest, std::abs(motion.rate(k, column)) / q_unit, std::abs(rate[i]) / l_unit});
      hardest = std::max({hardest, std::abs(motion.acceleration(k, column)) / q_unit, std::abs(acceleration[i]) / l_unit});
    }
    hardest = std::max(hardest, fastest * fastest);
    for (std::size_t i = 0; i < dof; ++i) {
      const Actuator& actuator = t.actuators[i];
      const double l_unit = unit(actuator.unit);
      const auto deviation = [&](OfMotion what, double prescribed, double scale) {
        const double d = std::abs(a.column(column_of(actuator, what))[sample] - prescribed) / l_unit;
        return scale > 0 ? d / scale : d;
      };
      const auto take = [](double& into, double d) { into = std::isnan(d) || std::isnan(into) ? NAN : std::max(into, d); };
      take(worst.value, deviation(OfMotion::value, value[i], 1));
      take(worst.rate, deviation(OfMotion::rate, rate[i], fastest));
      take(worst.acceleration, deviation(OfMotion::acceleration, acceleration[i], hardest));
    }
  }
  return worst;
}

}  // namespace pmreport::analysis
