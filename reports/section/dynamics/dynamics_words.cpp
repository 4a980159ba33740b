#include <core/linear/eigenvalues.hpp>
#include <core/mechanics/model/effort.hpp>
#include <reports/section/dynamics/dynamics_words.hpp>

#include <core/analysis/samples/motion_probe.hpp>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;
using document::Table;

namespace {

// "cylinder" of "cylinder 3" and "cylinder B2"; a name without a number stays.
std::string kind_of(const std::string& name) {
  const std::size_t space = name.rfind(' ');
  const bool numbered = space != std::string::npos && name.find_first_of("0123456789", space) != std::string::npos;
  return numbered ? name.substr(0, space) : name;
}

double total_mass(const Topology& t) {
  double sum = 0;
  for (const Body& b : t.bodies) sum += b.inertia.mass;
  return sum;
}

// "kg·m" between a length and an angle, "kg" between two lengths.
std::string unit_of_mass(const Analysis& a) {
  bool length = false, angle = false;
  for (const Coordinate& c : a.machine().topology().coordinates) (c.sense() == Sense::linear ? length : angle) = true;
  if (length && angle) return "kg between lengths, kg·m between a length and an angle, kg·m² between angles";
  return length ? "kg" : "kg·m²";
}

std::string number(double x, double scale) { return typeset(format_number(std::abs(x) < 1e-13 * scale ? 0 : x, 4)); }

// With angles counted per characteristic length, so that all numbers are masses.
double condition_of(const Analysis& a, mechanics::SmallMatrix mass) {
  const std::vector<Coordinate>& c = a.machine().topology().coordinates;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (c[i].sense() == Sense::linear) continue;
    mass.row(static_cast<Eigen::Index>(i)) /= a.length();
    mass.col(static_cast<Eigen::Index>(i)) /= a.length();
  }
  const mechanics::SmallVector eigenvalues = linear::symmetric_eigenvalues(mass);
  return eigenvalues.maxCoeff() / eigenvalues.minCoeff();
}

Table equation_table(const Analysis& a, const std::string& time, const mechanics::EquationsOfMotion& e) {
  const std::vector<Coordinate>& coordinates = a.machine().topology().coordinates;
  Table table{fmt::format("Equations of motion at t = {}: row by row M, c and g in SI units. Condition number of M {}, with angles counted "
                          "per characteristic length {}.",
                          time, format_number(condition_of(a, e.mass), 4), show(a.length(), "m")),
              {"row"},
              {false},
              {}};
  for (const Coordinate& c : coordinates) table.headings.push_back(symbol(c.name) + "″");
  table.headings.insert(table.headings.end(), {"c", "g", "unit"});
  table.numeric.resize(table.headings.size() - 1, true);
  table.numeric.push_back(false);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    std::vector<std::string> row{symbol(coordinates[i].name)};
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
      const auto other = static_cast<Eigen::Index>(k);
      row.push_back(number(e.mass(at, other), std::sqrt(e.mass(at, at) * e.mass(other, other))));
    }
    row.push_back(number(e.coriolis(at), 1));
    row.push_back(number(e.gravity(at), 1));
    row.push_back(coordinates[i].sense() == Sense::linear ? "N" : "N·m");
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::string masses(const Topology& t) {
  struct Kind {
    std::string name;
    double mass;
    int count;
  };
  std::vector<Kind> kinds;
  std::string massless;
  for (std::size_t i = 1; i < t.bodies.size(); ++i) {
    const Body& b = t.bodies[i];
    const std::string name = kind_of(b.name);
    const auto same = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == name && k.mass == b.inertia.mass; });
    same != kinds.end() ? void(++same->count) : void(kinds.push_back({name, b.inertia.mass, 1}));
  }
  std::string out;
  for (const Kind& k : kinds) {
    std::string& list = k.mass > 0 ? out : massless;
    const std::string many = k.count > 1 ? fmt::format("{} × ", k.count) : "";
    list += fmt::format("{}{}{}{}", list.empty() ? "" : k.mass > 0 ? "; " : ", ", many, k.name, k.mass > 0 ? " " + show(k.mass, "kg") : "");
  }
  return massless.empty() ? out : fmt::format("{}{}without mass: {}", out, out.empty() ? "" : "; ", massless);
}

std::vector<Paragraph> dynamics_words(const Analysis& a) {
  const Topology& t = a.machine().topology();
  const auto has = [&](const char* unit) {
    return std::any_of(t.actuators.begin(), t.actuators.end(), [&](const Actuator& x) { return x.unit == unit; });
  };
  std::vector<Paragraph> out;
  out.push_back(
      {Paragraph::Tone::plain,
       fmt::format("Actuator {} by virtual work: over every displacement that the joints allow, the actuators give what the inertia of "
                   "all bodies takes, less what load and weights give, so that no joint reaction enters.{}{} The joints are taken as "
                   "free of friction{}.",
                   has("m") ? has("rad") ? "forces and torques" : "forces" : "torques",
                   has("m") ? " A positive force pushes: it acts to extend its actuator." : "",
                   has("rad") ? " A positive torque acts in the positive sense of its angle." : "",
                   a.scenario().drives.empty() ? "" : "; what the drives lose stands in their own section")});
  const Eigen::Vector3d& g = a.scenario().load.gravity;
  out.push_back({Paragraph::Tone::plain, fmt::format("In motion: {} in all ({}).", show(total_mass(t), "kg"), masses(t))});
  if (g.isZero())
    out.push_back({Paragraph::Tone::note, "The scenario gives no gravity: the bodies have inertia and no weight."});
  else
    out.push_back({Paragraph::Tone::plain, fmt::format("Gravity ({}, {}, {}) m/s² acts on all bodies.", typeset(format_number(g.x(), 4)),
                                                       typeset(format_number(g.y(), 4)), typeset(format_number(g.z(), 4)))});
  return out;
}

std::vector<document::Block> equations_of_motion(const Analysis& a, const std::vector<double>& times) {
  std::vector<document::Block> out;
  if (times.empty()) return out;
  out.push_back(Paragraph{
      Paragraph::Tone::plain,
      fmt::format(
          "In the independent coordinates q, M q″ + c + g = JᵀF + Kᵀw: M the mass matrix ({}), c the centrifugal and Coriolis terms, g "
          "those of the weights, JᵀF and Kᵀw what the actuators and the load on the platform give. What an actuator feels of M while the "
          "others are held, its "
          "reflected inertia, is the diagonal of J⁻ᵀ M J⁻¹.",
          unit_of_mass(a))});
  analysis::MotionProbe probe(a.trajectory(), a.scenario().load, a.machine());
  const std::vector<Actuator>& actuators = a.machine().topology().actuators;
  Table reflected{"Reflected inertia.", {"actuator"}, {false}, {}};
  for (const Actuator& x : actuators) reflected.rows.push_back({symbol(x.name)});
  for (const double t : times) {
    const std::string time = format_number(t, 6) + " s";
    const auto outcome = a.outcome(a.sample_at(t));
    if (!probe.go(t) || outcome != Outcome::good) {
      out.push_back(
          Paragraph{Paragraph::Tone::note, fmt::format("At t = {} the motion has no pose, or a singular one: no equations.", time)});
      continue;
    }
    const mechanics::Tangent tangent = mechanics::tangent(a.machine(), probe.state());
    if (!tangent.by_coordinates) {
      out.push_back(Paragraph{Paragraph::Tone::note,
                              fmt::format("At t = {} the coordinates are singular, and the machine is not: no equations in them.", time)});
      continue;
    }
    const mechanics::EquationsOfMotion e = mechanics::equations_of_motion(a.machine(), probe.state(), tangent, a.scenario().load.gravity);
    out.push_back(equation_table(a, time, e));
    const mechanics::SmallVector inertia = reflected_inertia(tangent, e.mass);
    reflected.headings.push_back("t = " + time);
    reflected.numeric.push_back(true);
    for (std::size_t i = 0; i < actuators.size(); ++i)
      reflected.rows[i].push_back(show(inertia(static_cast<Eigen::Index>(i)), mechanics::unit_of_inertia(actuators[i].sense())));
  }
  if (reflected.headings.size() > 1) out.push_back(std::move(reflected));
  return out;
}

}  // namespace pmreport::section
