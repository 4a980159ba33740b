#include <core/analysis/study/drive_balance.hpp>

#include <core/analysis/samples/motion_probe.hpp>
#include <core/analysis/samples/smooth_rate.hpp>
#include <core/analysis/samples/stretch.hpp>
#include <core/analysis/study/instant.hpp>
#include <core/mechanics/dynamics/drive.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace pmreport::analysis {

using mechanics::DriveTrain;
using mechanics::EfficiencyConvention;

namespace {

// Where motor power is held against differences: a sample, or, where one lies on a knot of the motion or close to it, the middle of the
// stretch that begins there.
struct Spot {
  std::size_t sample;
  double time;
  Stretch stretch;
  std::unique_ptr<Instant> between;  // the run at `time`, where that is no sample

  double value(const Analysis& a, const ColumnId& column) const { return between ? between->value(column) : a.column(column)[sample]; }
};

// Spread evenly.
std::vector<Spot> spots(const Analysis& a, int wanted) {
  constexpr double room = 1.0 / 8;  // to either end of a stretch, of its length, that differences need
  const std::vector<double> knots = knots_along(a.trajectory(), a.scenario().load);
  std::vector<Spot> out;
  const int count = std::min(wanted, a.samples());
  for (int n = 0; n < count; ++n) {
    const auto k = static_cast<std::size_t>((n + 0.5) * a.samples() / count);
    const double first = a.time().front(), last = a.time().back(), t = a.time()[k];
    Spot spot{k, t, stretch_at(knots, t, first, last), nullptr};
    const double margin = room * (spot.stretch.end - spot.stretch.begin);
    if ((spot.stretch.begin > first && t - spot.stretch.begin < margin) || (spot.stretch.end < last && spot.stretch.end - t < margin)) {
      spot.time = 0.5 * (spot.stretch.begin + spot.stretch.end);
      spot.between = std::make_unique<Instant>(a, spot.time);
    }
    out.push_back(std::move(spot));
  }
  return out;
}

}  // namespace

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
  bool motors = false;
  for (std::size_t i = 0; i < actuators.size(); ++i) motors = motors || has_motor(a, i);
  const std::vector<Spot> compared = spots(a, motors ? 16 : 0);
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
    smooth_scale = std::max(smooth_scale, a.largest({motor_power}));
    const auto rotor_energy = [&](double t) {
      if (!probe.go(t)) return nan;
      const double speed = drive.ratio * probe.state().actuators[i].rate;
      return drive.inertia * speed * speed / 2;
    };
    for (const Spot& spot : compared) {
      const double rest = spot.value(a, motor_power) - spot.value(a, column_of(actuator, OfActuator::drive_power));
      if (!std::isfinite(rest)) continue;
      const auto rate = smooth_rate(rotor_energy, spot.time, spot.stretch.begin, spot.stretch.end);
      if (rate && rate->change <= 1e-9 * smooth_scale) left_over = std::fmax(left_over, std::abs(rest - rate->value));
    }
  }
  DriveBalance out;
  if (!divides) out.gained = relative(gained, power);
  if (std::isfinite(left_over)) out.left_over = relative(left_over, smooth_scale);
  return out;
}

}  // namespace pmreport::analysis
