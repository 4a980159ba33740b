// Section `drives`.
#include <core/numbers.hpp>
#include <reports/section/common/force_plots.hpp>
#include <reports/section/drives/drives.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pmreport::section {

using mechanics::DriveTrain;

namespace {

// What no drive train may do, and what its motor must.
document::Proof evidence(const Analysis& a) {
  document::Proof p;
  const analysis::DriveBalance balance = analysis::drive_balance(a);
  if (std::isfinite(balance.gained))
    p.lines.push_back(
        {"No drive gives more than it takes",
         "largest excess, at any sample, of the power that leaves a drive over the power that enters it, relative to the largest",
         balance.gained, 1e-12, ""});
  if (std::isfinite(balance.left_over))
    p.lines.push_back({"Motor power becomes drive power and spin",
                       "what motors give beyond what the drives take, against eighth-order differences of the energy of rotor and screw, "
                       "relative to the largest motor power",
                       balance.left_over, 1e-8, ""});
  return p;
}

std::vector<document::Value> values_of(const Analysis& a) {
  std::vector<document::Value> out;
  for (const auto& [name, what, unit] : {std::tuple{"peak_torque", OfActuator::motor_torque, "N*m"},
                                         {"peak_speed", OfActuator::motor_speed, "rad/s"},
                                         {"peak_power", OfActuator::motor_power, "W"}}) {
    double largest = nan;
    for (const Trace& c : of_actuators(a, what)) largest = std::fmax(largest, std::abs(peak(a, c.column).value));
    if (std::isfinite(largest)) out.push_back({"drives", name, unit, largest});
  }
  return out;
}

}  // namespace

const std::vector<Actuator>& actuators(const Analysis& a) { return a.machine().topology().actuators; }

const DriveTrain& train(const Analysis& a, std::size_t i) { return a.scenario().drives.at(i); }

bool any_motor(const Analysis& a) {
  for (std::size_t i = 0; i < actuators(a).size(); ++i)
    if (has_motor(a, i)) return true;
  return false;
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
