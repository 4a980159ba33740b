// The tables of the section `drives`.
#include <core/mechanics/model/effort.hpp>
#include <core/numbers.hpp>
#include <reports/section/common/force_plots.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/drives/drives.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

// Integral of the negative part of a power by straight lines between the samples, cut where they cross zero; as a positive number [J].
double given_back(const Analysis& a, const ColumnId& column) {
  const std::vector<double>&p = a.column(column), &t = a.time();
  double sum = 0;
  for (std::size_t k = 0; k + 1 < p.size(); ++k) {
    if (!std::isfinite(p[k]) || !std::isfinite(p[k + 1])) continue;
    const double low = std::min(p[k], p[k + 1]), high = std::max(p[k], p[k + 1]);
    if (low >= 0) continue;
    const double share = high > 0 ? low / (low - high) : 1;  // of the interval, below zero
    sum -= share * (low + std::min(high, 0.0)) / 2 * (t[k + 1] - t[k]);
  }
  return sum;
}

// Columns of a table are given as numbers, so that each takes the unit that reads best for it.
struct Numbers {
  std::string title, unit;
  std::vector<double> values;
};

document::Table table_of(const Analysis& a, const std::string& caption, const std::vector<std::string>& names,
                         const std::vector<Numbers>& columns) {
  document::Table table{caption, {"actuator"}, {false}, std::vector<std::vector<std::string>>(names.size())};
  for (std::size_t r = 0; r < names.size(); ++r) table.rows[r].push_back(names[r]);
  for (const Numbers& n : columns) {
    const bool share = n.unit == "%", speed = n.unit == "rpm";
    const TableColumn column(a, n.title, share || speed ? "" : n.unit, n.values);
    table.headings.push_back(share || speed ? fmt::format("{} [{}]", n.title, n.unit) : column.heading());
    table.numeric.push_back(true);
    for (std::size_t r = 0; r < names.size(); ++r)
      table.rows[r].push_back(!std::isfinite(n.values[r]) ? "–"
                              : share                     ? format_number(100 * n.values[r], 3)
                              : speed                     ? typeset(format_number(n.values[r] * rpm, 4))
                                                          : column.cell(n.values[r]));
  }
  return table;
}

std::string word_of(const std::string& unit) { return mechanics::unit_of_inertia(sense_of(unit)); }

// A number of each actuator of a unit; NaN where it has none.
template <class F>
std::vector<double> each(const Analysis& a, const std::string& unit, F&& f) {
  std::vector<double> out;
  for (std::size_t i = 0; i < actuators(a).size(); ++i)
    if (actuators(a)[i].unit == unit) out.push_back(f(i, actuators(a)[i]));
  return out;
}

double peak_value(const Analysis& a, const ColumnId& column) {
  const Peak p = peak(a, column);
  return p.sample >= 0 ? p.value : nan;
}

std::vector<std::string> names_of(const Analysis& a, const std::string& unit) {
  std::vector<std::string> out;
  for (const Actuator& x : actuators(a))
    if (x.unit == unit) out.push_back(symbol(x.name));
  return out;
}

}  // namespace

std::vector<document::Table> drive_tables(const Analysis& a) {
  std::vector<document::Table> out;
  for (const std::string unit : {"m", "rad"}) {
    const std::vector<std::string> names = names_of(a, unit);
    if (names.empty()) continue;
    // Of a column of each, where the run has it.
    const auto reduced = [&](OfActuator what, auto&& reduce) {
      return each(a, unit, [&](std::size_t, const Actuator& x) {
        const ColumnId column = column_of(x, what);
        return a.has(column) ? reduce(column) : nan;
      });
    };
    const auto of = [&](OfActuator what) { return reduced(what, [&](const ColumnId& column) { return peak_value(a, column); }); };
    const auto roots = [&](OfActuator what) { return reduced(what, [&](const ColumnId& column) { return rms(a, column); }); };
    const auto back = [&](OfActuator what) { return reduced(what, [&](const ColumnId& column) { return given_back(a, column); }); };
    out.push_back(table_of(
        a,
        fmt::format(
            "Drives: largest {} and power by magnitude, root mean square, energy that comes back through the drive, share of the samples "
            "in which it is driven back.",
            effort(unit)),
        names,
        {{"peak " + effort(unit), effort_unit(unit), of(OfActuator::drive_force)},
         {"RMS", effort_unit(unit), roots(OfActuator::drive_force)},
         {"peak power", "W", of(OfActuator::drive_power)},
         {"regenerated", "J", back(OfActuator::drive_power)},
         {"driven back", "%", each(a, unit, [&](std::size_t, const Actuator& x) { return driven_back(a, x); })}}));
    const auto inertia = [&](bool largest) {
      return each(a, unit, [&](std::size_t, const Actuator& actuator) {
        double out = nan;
        for (const double x : a.column(column_of(actuator, OfActuator::reflected_inertia)))
          out = largest ? std::fmax(out, x) : std::fmin(out, x);
        return out;
      });
    };
    std::vector<Numbers> reflected{{"least", word_of(unit), inertia(false)}, {"most", word_of(unit), inertia(true)}};
    if (any_motor(a)) {
      out.push_back(table_of(
          a, "Motors: largest torque, speed and power by magnitude, root mean square of the torque, energy that comes back.", names,
          {{"peak torque", "N*m", of(OfActuator::motor_torque)},
           {"RMS torque", "N*m", roots(OfActuator::motor_torque)},
           {"peak speed", "rpm", of(OfActuator::motor_speed)},
           {"peak power", "W", of(OfActuator::motor_power)},
           {"regenerated", "J", back(OfActuator::motor_power)}}));
      const auto at_motor = [&](std::size_t i, const Actuator& actuator) {
        double most = nan;
        for (const double x : a.column(column_of(actuator, OfActuator::reflected_inertia))) most = std::fmax(most, x);
        return has_motor(a, i) ? most / (train(a, i).ratio * train(a, i).ratio) : nan;
      };
      const auto rotor = [&](std::size_t i, const Actuator&) { return has_motor(a, i) ? train(a, i).inertia : nan; };
      reflected.push_back({"most, at the motor", "kg*m^2", each(a, unit, at_motor)});
      reflected.push_back({"rotor and screw", "kg*m^2", each(a, unit, rotor)});
      reflected.push_back({"load to rotor", "", each(a, unit, [&](std::size_t i, const Actuator& actuator) {
                             const double own = rotor(i, actuator);
                             return own > 0 ? at_motor(i, actuator) / own : nan;
                           })});
    }
    out.push_back(
        table_of(a, "Inertia of the mechanism that each actuator feels along the motion, the other actuators held.", names, reflected));
  }
  return out;
}

}  // namespace pmreport::section
