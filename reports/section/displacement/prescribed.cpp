#include <reports/section/displacement/prescribed.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

// Largest deviation, relative: of values to the mechanism's size, of rates and accelerations to the largest that the motion brings about,
// in sizes or radians a second. Next to a singular surface coordinates move much faster than the actuators, which then are small
// differences of large numbers.
struct Deviations {
  double value = 0, rate = 0, acceleration = 0;
};

Deviations deviations(const Analysis& a) {
  const scenario::Motion& motion = a.scenario().motion;
  const Topology& t = a.machine().topology();
  const auto unit = [&](const std::string& name) { return name == "m" ? a.length() : 1.0; };
  const std::size_t dof = t.actuators.size();
  std::vector<double> value(dof), rate(dof), acceleration(dof);
  Deviations worst;
  for (int k = 0; k < a.samples(); ++k) {
    if (!motion.value.row(k).allFinite()) continue;
    const auto sample = static_cast<std::size_t>(k);
    motion.actuators(a.time()[sample], value.data(), rate.data(), acceleration.data());
    double fastest = 0, hardest = 0;
    for (std::size_t i = 0; i < dof; ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const double q_unit = unit(t.coordinates[i].unit), l_unit = unit(t.actuators[i].unit);
      fastest = std::max({fastest, std::abs(motion.rate(k, column)) / q_unit, std::abs(rate[i]) / l_unit});
      hardest = std::max({hardest, std::abs(motion.acceleration(k, column)) / q_unit, std::abs(acceleration[i]) / l_unit});
    }
    hardest = std::max(hardest, fastest * fastest);
    for (std::size_t i = 0; i < dof; ++i) {
      const std::string& name = t.actuators[i].name;
      const double l_unit = unit(t.actuators[i].unit);
      const auto deviation = [&](const std::string& column, double prescribed, double scale) {
        const double d = std::abs(a.column(column)[sample] - prescribed) / l_unit;
        return scale > 0 ? d / scale : d;
      };
      const auto take = [](double& into, double d) { into = std::isnan(d) || std::isnan(into) ? NAN : std::max(into, d); };
      take(worst.value, deviation(name, value[i], 1));
      take(worst.rate, deviation(name + "_rate", rate[i], fastest));
      take(worst.acceleration, deviation(name + "_acceleration", acceleration[i], hardest));
    }
  }
  return worst;
}

}  // namespace

std::vector<document::Evidence> prescribed_evidence(const Analysis& a) {
  if (!a.scenario().motion.by_actuators) return {};
  const Deviations d = deviations(a);
  return {{"The actuators have the prescribed values", "inverse displacement of the pose found, relative to the mechanism's size", d.value,
           1e-11, ""},
          {"The actuators have the prescribed rates", "by differentiation along the rates found, relative to the largest rate", d.rate,
           1e-9, ""},
          {"The actuators have the prescribed accelerations",
           "by differentiation along the accelerations found, relative to the largest acceleration", d.acceleration, 1e-9, ""}};
}

}  // namespace pmreport::section
