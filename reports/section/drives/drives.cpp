// Section `drives`.
#include <core/analysis/motion_probe.hpp>
#include <core/analysis/smooth_rate.hpp>
#include <reports/section/common/force_plots.hpp>
#include <reports/section/drives/drives.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace pmreport::section {

using mechanics::DriveTrain;
using mechanics::EfficiencyConvention;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// What no drive train may do, and what its motor must.
document::Proof evidence(const Analysis& a) {
  document::Proof p;
  double gained = 0, power = 0, left_over = nan, smooth_scale = 0;
  bool divides = false;
  analysis::MotionProbe probe(a.scenario(), a.machine());
  for (std::size_t i = 0; i < actuators(a).size(); ++i) {
    const std::string& name = actuators(a)[i].name;
    const DriveTrain& drive = train(a, i);
    divides = divides || drive.convention == EfficiencyConvention::always_divides;
    const std::vector<double>&in = a.column(name + "_drive_power"), &out = a.column(name + "_power");
    for (std::size_t k = 0; k < in.size(); ++k)
      if (std::isfinite(in[k])) gained = std::max(gained, out[k] - in[k]), power = std::max(power, std::abs(in[k]));
    if (!has_motor(a, i)) continue;
    const std::vector<double>& motor = a.column(name + "_motor_power");
    smooth_scale = std::max(smooth_scale, a.largest({name + "_motor_power"}));
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
      const auto rate = analysis::smooth_rate(rotor_energy, a.time()[k], a.time().front(), a.time().back());
      if (rate && rate->change <= 1e-9 * smooth_scale) left_over = std::fmax(left_over, std::abs(rest - rate->value));
    }
  }
  const auto relative = [](double x, double scale) { return scale > 0 ? x / scale : x; };
  if (!divides)
    p.lines.push_back(
        {"No drive gives more than it takes",
         "largest excess, at any sample, of the power that leaves a drive over the power that enters it, relative to the largest",
         relative(gained, power), 1e-12, ""});
  if (std::isfinite(left_over))
    p.lines.push_back({"Motor power becomes drive power and spin",
                       "what motors give beyond what the drives take, against eighth-order differences of the energy of rotor and screw, "
                       "relative to the largest motor power",
                       relative(left_over, smooth_scale), 1e-8, ""});
  return p;
}

std::vector<document::Value> values_of(const Analysis& a) {
  std::vector<document::Value> out;
  for (const auto& [name, suffix, unit] :
       {std::tuple{"peak_torque", "_motor_torque", "N*m"}, {"peak_speed", "_motor_speed", "rad/s"}, {"peak_power", "_motor_power", "W"}}) {
    double largest = nan;
    for (const Curve& c : of_actuators(a, suffix)) largest = std::fmax(largest, std::abs(peak(a, c.column).value));
    if (std::isfinite(largest)) out.push_back({"drives", name, unit, largest});
  }
  return out;
}

}  // namespace

const std::vector<Actuator>& actuators(const Analysis& a) { return a.machine().topology().actuators; }

const DriveTrain& train(const Analysis& a, std::size_t i) { return a.scenario().drives.at(i); }

bool has_motor(const Analysis& a, std::size_t i) { return a.has(actuators(a)[i].name + "_motor_torque"); }

bool any_motor(const Analysis& a) {
  for (std::size_t i = 0; i < actuators(a).size(); ++i)
    if (has_motor(a, i)) return true;
  return false;
}

double driven_back(const Analysis& a, const std::string& actuator) {
  int back = 0, all = 0;
  for (const double p : a.column(actuator + "_power"))
    if (std::isfinite(p)) ++all, back += p < 0 ? 1 : 0;
  return all > 0 ? static_cast<double>(back) / all : nan;
}

Result drives_section(const Analysis& a) {
  document::Section s{"drives", "drives", "Drives", {}};
  for (document::Paragraph& p : drive_words(a)) s.blocks.push_back(std::move(p));
  for (figure::Figure& f : drive_figures(a)) s.blocks.push_back(std::move(f));
  for (document::Table& t : drive_tables(a)) s.blocks.push_back(std::move(t));
  if (document::Proof p = evidence(a); !p.lines.empty()) s.blocks.push_back(std::move(p));
  return {s, values_of(a), {}, {}};
}

}  // namespace pmreport::section
