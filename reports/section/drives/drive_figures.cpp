// The figures of the section `drives`.
#include <core/numbers.hpp>
#include <reports/section/common/force_plots.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/drives/drives.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

figure::Figure drive_figure(const Analysis& a) {
  figure::Figure f{
      "drives", "What the drives must give at their actuators' ends: force, and power.", "data/drives.csv", figure::Width::full, 2, {}};
  for (const std::string unit : {"m", "rad"})
    if (const std::vector<Trace> curves = of_actuators(a, OfActuator::drive_force, unit); !curves.empty())
      f.panels.push_back(panel(a, "drive " + effort(unit), effort(unit), effort_unit(unit), curves));
  f.panels.push_back(panel(a, "drive power", "power", "W", of_actuators(a, OfActuator::drive_power)));
  return f;
}

figure::Panel in_rpm(figure::Panel p, const std::string& si) {
  const double scale = rpm / display_unit(si, 1).per_si;
  for (figure::Series& s : p.series)
    for (double& y : s.y) y *= scale;
  p.y.unit = "rpm";
  return p;
}

figure::Figure motor_figure(const Analysis& a) {
  figure::Figure f{"drives-motors", "Torque, speed and power of the motors.", "data/drives.csv", figure::Width::full, 2, {}};
  f.panels.push_back(panel(a, "motor torque", "torque", "N*m", of_actuators(a, OfActuator::motor_torque)));
  f.panels.push_back(in_rpm(panel(a, "motor speed", "speed", "rad/s", of_actuators(a, OfActuator::motor_speed)), "rad/s"));
  f.panels.push_back(panel(a, "motor power", "power", "W", of_actuators(a, OfActuator::motor_power)));
  return f;
}

// The torque that passes on to the drive; the rest accelerates rotor and screw.
std::vector<double> passed_on(const Analysis& a, std::size_t i) {
  std::vector<double> torque = a.column(column_of(actuators(a)[i], OfActuator::drive_force));
  for (double& x : torque) x /= train(a, i).ratio;
  return torque;
}

figure::Figure torque_figure(const Analysis& a) {
  figure::Figure f{
      "drives-torque",
      "What asks for the torque of each motor: the drive, and the inertia of rotor and screw; they sum to the black curve. Curves "
      "look alike in all panels.",
      "data/drives.csv",
      figure::Width::full,
      2,
      {}};
  for (std::size_t i = 0; i < actuators(a).size(); ++i) {
    if (!has_motor(a, i) || !(train(a, i).inertia > 0)) continue;
    const ColumnId column = column_of(actuators(a)[i], OfActuator::motor_torque);
    const bool keys = f.panels.empty();
    figure::Panel p = share_panel(a, symbol(actuators(a)[i].name), "torque", "N*m",
                                  {{column, "drive", load_style}, {column, "rotor", inertia_style}, {column, "sum", total_style}}, keys);
    const double per_si = unit_of(a, "N*m", {{column, ""}}).per_si;
    const std::vector<double> drive = passed_on(a, i);
    for (std::size_t k = 0; k < drive.size(); ++k) {
      p.series[0].y[k] = drive[k] * per_si;
      p.series[1].y[k] = p.series[2].y[k] - p.series[0].y[k];
    }
    f.panels.push_back(std::move(p));
  }
  return f;
}

figure::Figure plane_figure(const Analysis& a) {
  figure::Figure f{"drives-operation",
                   "Operating points of the motors. Where torque and speed have one sign the motor drives; elsewhere it brakes.",
                   "data/drives.csv",
                   figure::Width::full,
                   1,
                   {}};
  const DisplayUnit torque = unit_of(a, "N*m", of_actuators(a, OfActuator::motor_torque));
  figure::Panel p;
  p.title = "torque against speed";
  p.x = {"motor speed", "rpm"};
  p.y = {"motor torque", torque.label};
  for (std::size_t i = 0; i < actuators(a).size(); ++i) {
    if (!has_motor(a, i)) continue;
    const Actuator& x = actuators(a)[i];
    figure::Series s{symbol(x.name), a.column(column_of(x, OfActuator::motor_speed)), a.column(column_of(x, OfActuator::motor_torque)),
                     static_cast<int>(i)};
    for (double& x : s.x) x *= rpm;
    for (double& y : s.y) y *= torque.per_si;
    p.series.push_back(std::move(s));
  }
  // Gaps that stand a little beyond the extremes: the curves turn round there and shall not touch the frame.
  double fastest = 0;
  for (const figure::Series& s : p.series)
    for (const double x : s.x)
      if (std::isfinite(x)) fastest = std::max(fastest, std::abs(x));
  p.series.push_back({"", {-1.06 * fastest, 1.06 * fastest}, {nan, nan}, 0});
  f.panels.push_back(std::move(p));
  return f;
}

}  // namespace

std::vector<figure::Figure> drive_figures(const Analysis& a) {
  std::vector<figure::Figure> out{drive_figure(a)};
  if (!any_motor(a)) return out;
  out.push_back(motor_figure(a));
  if (figure::Figure torque = torque_figure(a); !torque.panels.empty()) out.push_back(std::move(torque));
  out.push_back(plane_figure(a));
  return out;
}

}  // namespace pmreport::section
