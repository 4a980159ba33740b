#include <core/analysis/study/drive_balance.hpp>

#include <core/analysis/samples/motion_probe.hpp>
#include <core/analysis/samples/smooth_rate.hpp>
#include <core/analysis/samples/stretch.hpp>
#include <core/mechanics/dynamics/drive.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

using mechanics::DriveTrain;
using mechanics::EfficiencyConvention;

namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
}

bool has_motor(const Analysis& a, std::size_t i) { return a.has(column_of(a.machine().topology().actuators[i], OfActuator::motor_torque)); }

double driven_back(const Analysis& a, const Actuator& actuator) {
  int back = 0, all = 0;
  for (const double p : a.column(column_of(actuator, OfActuator::power)))
    if (std::isfinite(p)) ++all, back += p < 0 ? 1 : 0;
  return all > 0 ? static_cast<double>(back) / all : nan;
}

DriveBalance drive_balance(const Analysis& a) {
  const std::vector<Actuator>& actuators = a.machine().topology().actuators;
  double gained = 0, power = 0, left_over = nan, smooth_scale = 0;
  bool divides = false;
  MotionProbe probe(a.trajectory(), a.scenario().load, a.machine());
  const std::vector<double> knots = knots_along(a.trajectory(), a.scenario().load);
  for (std::size_t i = 0; i < actuators.size(); ++i) {
    const Actuator& actuator = actuators[i];
    const DriveTrain& drive = a.scenario().drives.at(i);
    divides = divides || drive.convention == EfficiencyConvention::always_divides;
    const std::vector<double>&in = a.column(column_of(actuator, OfActuator::drive_power)),
          &out = a.column(column_of(actuator, OfActuator::power));
    for (std::size_t k = 0; k < in.size(); ++k)
      if (std::isfinite(in[k])) gained = std::max(gained, out[k] - in[k]), power = std::max(power, std::abs(in[k]));
    if (!has_motor(a, i)) continue;
    const ColumnId motor_power = column_of(actuator, OfActuator::motor_power);
    const std::vector<double>& motor = a.column(motor_power);
    smooth_scale = std::max(smooth_scale, a.largest({motor_power}));
    const auto rotor_energy = [&](double t) {
      if (!probe.go(t)) return nan;
      const double speed = drive.ratio * probe.state().actuators[i].rate;
      return drive.inertia * speed * speed / 2;
    };
    constexpr int wanted = 16;
    for (int n = 0; n < std::min(wanted, a.samples()); ++n) {
      const auto k = static_cast<std::size_t>((n + 0.5) * a.samples() / std::min(wanted, a.samples()));
      const double rest = motor[k] - in[k];
      if (!std::isfinite(rest)) continue;
      const auto [begin, end] = stretch_at(knots, a.time()[k], a.time().front(), a.time().back());
      const auto rate = smooth_rate(rotor_energy, a.time()[k], begin, end);
      if (rate && rate->change <= 1e-9 * smooth_scale) left_over = std::fmax(left_over, std::abs(rest - rate->value));
    }
  }
  DriveBalance out;
  if (!divides) out.gained = relative(gained, power);
  if (std::isfinite(left_over)) out.left_over = relative(left_over, smooth_scale);
  return out;
}

}  // namespace pmreport::analysis
