// Section `dynamics`.
#include <core/analysis/study/given_forces.hpp>
#include <core/analysis/study/motion_work.hpp>
#include <core/numbers.hpp>
#include <reports/section/common/force_plots.hpp>
#include <reports/section/common/words/singular_words.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/dynamics/dynamics.hpp>
#include <reports/section/dynamics/dynamics_words.hpp>
#include <reports/section/dynamics/energy.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;

namespace {

// The shares that the scenario has; the rest is zero throughout.
std::vector<Share> shares_of(const Analysis& a, const Actuator& actuator) {
  std::vector<Share> out;
  const auto add = [&](OfActuator share, const char* label, int style) {
    if (a.largest(columns_of(of_actuators(a, share))) > 0) out.push_back({column_of(actuator, share), label, style});
  };
  add(OfActuator::load_force, "load", load_style);
  add(OfActuator::gravity_force, "weights", gravity_style);
  add(OfActuator::inertia_force, "inertia", inertia_style);
  return out;
}

figure::Figure force_figure(const Analysis& a) {
  figure::Figure f{
      "dynamics", "What the actuators must exert for the mechanism to move as it does.", "data/dynamics.csv", figure::Width::full, 1, {}};
  for (const std::string unit : {"m", "rad"}) {
    const std::vector<Trace> curves = of_actuators(a, OfActuator::dynamic_force, unit);
    if (curves.empty()) continue;
    figure::Panel p = panel(a, "actuator " + effort(unit) + "s", effort(unit), effort_unit(unit), curves);
    add_limit_lines(p, a, a.scenario().limits.force, unit, unit_of(a, effort_unit(unit), curves).per_si);
    if (!p.lines.empty()) f.caption += " Lines: the limits of the scenario.";
    f.panels.push_back(std::move(p));
  }
  return f;
}

figure::Figure share_figure(const Analysis& a) {
  figure::Figure f{"dynamics-shares",
                   "What asks for the force of each actuator: the load on the platform, the weights of all bodies, their inertia; they sum "
                   "to the black curve. Curves look alike in all panels.",
                   "data/dynamics.csv",
                   figure::Width::full,
                   2,
                   {}};
  for (const Actuator& x : a.machine().topology().actuators) {
    std::vector<Share> shares = shares_of(a, x);
    if (shares.size() < 2) continue;
    shares.push_back({column_of(x, OfActuator::dynamic_force), "sum", total_style});
    f.panels.push_back(share_panel(a, symbol(x.name), effort(x.unit), effort_unit(x.unit), shares, f.panels.empty()));
  }
  return f;
}

figure::Figure power_figure(const Analysis& a) {
  figure::Figure f{
      "dynamics-power",
      "Mechanical power of the actuators, positive where they drive, negative where they are driven back; power of all of them "
      "and of the load; energy of all bodies.",
      "data/dynamics.csv",
      figure::Width::full,
      2,
      {}};
  const std::vector<Trace> powers = of_actuators(a, OfActuator::power);
  figure::Panel each = panel(a, "power of the actuators", "power", "W", powers);
  add_limit_lines(each, a, a.scenario().limits.power, "", unit_of(a, "W", powers).per_si);
  f.panels.push_back(std::move(each));
  std::vector<Share> sums{{column_of(OfMachine::total_power), "actuators", total_style}};
  if (const ColumnId load = column_of(OfMachine::load_power); a.largest({load}) > 0) sums.push_back({load, "load", load_style});
  f.panels.push_back(share_panel(a, "power of all", "power", "W", sums, true));
  std::vector<Share> energies{{column_of(OfMachine::kinetic_energy), "kinetic", inertia_style}};
  if (!a.scenario().load.gravity.isZero())
    energies.push_back({column_of(OfMachine::potential_energy), "potential, from its start", gravity_style});
  figure::Panel energy = share_panel(a, "energy", "energy", "J", energies, true);
  if (energies.size() > 1) {  // an offset that depends on the place of the origin alone
    std::vector<double>& potential = energy.series.back().y;
    const auto start = std::find_if(potential.begin(), potential.end(), [](double x) { return std::isfinite(x); });
    const double offset = start != potential.end() ? *start : 0;
    for (double& x : potential) x -= offset;
  }
  f.panels.push_back(std::move(energy));
  return f;
}

// Of the actuators of one unit; the sums below the last of these tables.
document::Table actuator_table(const Analysis& a, const std::optional<analysis::MotionWork>& work, const std::string& unit, bool sums) {
  struct Row {
    std::string name;
    Peak force, power;
    double rms, inertia, work, regenerated;
  };
  std::vector<Row> rows;
  const std::vector<Actuator>& actuators = a.machine().topology().actuators;
  for (std::size_t i = 0; i < actuators.size(); ++i) {
    const Actuator& actuator = actuators[i];
    if (actuator.unit != unit) continue;
    const ColumnId whole = column_of(actuator, OfActuator::dynamic_force);
    const Peak force = peak(a, whole);
    const double inertia =
        force.sample >= 0 && force.value != 0
            ? a.column(column_of(actuator, OfActuator::inertia_force))[static_cast<std::size_t>(force.sample)] / force.value
            : nan;
    rows.push_back({symbol(actuator.name), force, peak(a, column_of(actuator, OfActuator::power)), rms(a, whole), inertia,
                    work ? work->actuators[i] : nan, work ? work->regenerated[i] : nan});
  }
  if (sums) {
    double regenerated = 0;
    if (work)
      for (const double x : work->regenerated) regenerated += x;
    rows.push_back(
        {"all", {-1, nan}, peak(a, column_of(OfMachine::total_power)), nan, nan, work ? work->work() : nan, work ? regenerated : nan});
  }
  const auto column = [&](const std::string& title, const std::string& si, auto&& value) {
    std::vector<double> values;
    for (const Row& r : rows) values.push_back(value(r));
    return TableColumn(a, title, si, values);
  };
  const std::string word = effort(unit), si = effort_unit(unit);
  const TableColumn force = column("peak", si, [](const Row&r) { return r.force.value; }),
                    root = column("RMS", si, [](const Row&r) { return r.rms; }),
                    power = column("power", "W", [](const Row&r) { return r.power.value; }),
                    done = column("work", "J", [](const Row&r) { return r.work; }),
                    back = column("regained", "J", [](const Row&r) { return r.regenerated; });
  document::Table table{
      fmt::format("Actuators: largest {} by magnitude and how much of it inertia asks for, root mean square; largest power; work over the "
                  "motion, and what load and inertia give back of it.",
                  word),
      {"actuator", force.heading(), "at", "of inertia", root.heading(), power.heading(), "at", done.heading(), back.heading()},
      {false, true, true, true, true, true, true, true, true},
      {}};
  const auto when = [&](const Peak& p) { return p.sample < 0 ? std::string("–") : show_time(a, p.sample); };
  for (const Row& r : rows)
    table.rows.push_back({r.name, force.cell(r.force.value), when(r.force),
                          std::isfinite(r.inertia) ? typeset(format_number(100 * r.inertia, 3)) + " %" : "–", root.cell(r.rms),
                          power.cell(r.power.value), when(r.power), done.cell(r.work), back.cell(r.regenerated)});
  return table;
}

std::vector<document::Value> values_of(const Analysis& a, const std::optional<analysis::MotionWork>& work) {
  std::vector<document::Value> out;
  const auto largest = [&](const char* name, const char* si, const std::vector<Trace>& curves) {
    double value = nan;
    for (const Trace& c : curves)
      if (const Peak p = peak(a, c.column); p.sample >= 0) value = std::fmax(value, std::abs(p.value));
    if (std::isfinite(value)) out.push_back({"dynamics", name, si, value});
  };
  largest("peak_force", "N", of_actuators(a, OfActuator::dynamic_force, "m"));
  largest("peak_torque", "N*m", of_actuators(a, OfActuator::dynamic_force, "rad"));
  largest("peak_power", "W", of_actuators(a, OfActuator::power));
  if (work) {
    double regenerated = 0;
    for (const double x : work->regenerated) regenerated += x;
    out.push_back({"dynamics", "work", "J", work->work()});
    out.push_back({"dynamics", "regenerated", "J", regenerated});
  }
  if (a.scenario().motion->by_forces()) out.push_back({"dynamics", "energy_drift", "J", a.trajectory().energy_drift});
  return out;
}

document::Proof evidence(const Analysis& a, const EnergyEvidence& energy) {
  std::vector<Claim> claims{
      {Measure::newton_euler, "Virtual work equals Newton and Euler",
       "actuator forces by virtual work against those that balance every body, relative to the largest share or wrench", 1e-8, ""},
      {Measure::free_body, "Every body obeys Newton and Euler",
       "largest force, or moment per characteristic length, that joints, actuators, load and weight leave over for a body beyond what its "
       "inertia takes; relative to the largest of them",
       1e-8, ""},
      {Measure::judge, "Limb by limb equals all at once",
       "actuator forces and joint reactions against one factorisation over all bodies, relative to the largest", 1e-8, "",
       "the platform does not cut this mechanism into limbs, and the factorisation over all bodies is the only way"}};
  // Compared where the differences are good to a tenth of the tolerance.
  if (a.worst(Measure::power_balance).compared > 0)
    claims.push_back({Measure::power_balance, "Power becomes energy",
                      "power of actuators and load against eighth-order differences of kinetic and potential energy along the motion, at "
                      "samples around which it is smooth, or beside them where it has knots; relative to the largest power",
                      1e-8, ""});
  document::Proof p = proof(a, claims);
  p.lines.insert(p.lines.end(), energy.lines.begin(), energy.lines.end());
  const bool by_forces = a.scenario().motion->by_forces();
  if (!by_forces) return p;
  p.lines.push_back(
      {"Inverse dynamics returns the given forces",
       "forces that the scenario gives against those that the integrated motion takes, relative to the largest share of load, "
       "weights or inertia",
       analysis::given_against_found(a), 1e-8, ""});
  p.lines.push_back({"Integration keeps the energy",
                     "energy along the integrated motion against the work of actuators and load, relative to the largest of both",
                     a.trajectory().energy_drift_share, 1e-6, ""});
  return p;
}

}  // namespace

Result dynamics_section(const Analysis& a, const DynamicsOptions& r) {
  document::Section s{"dynamics", "dynamics", "Dynamics", {}};
  for (const std::string& line : singularity_sentences(a)) s.blocks.push_back(Paragraph{Paragraph::Tone::warning, line});
  for (Paragraph& p : dynamics_words(a)) s.blocks.push_back(std::move(p));
  const std::optional<analysis::MotionWork> work = analysis::motion_work(a);
  s.blocks.push_back(force_figure(a));
  if (figure::Figure shares = share_figure(a); !shares.panels.empty()) s.blocks.push_back(std::move(shares));
  s.blocks.push_back(power_figure(a));
  const bool linear = !of_actuators(a, OfActuator::dynamic_force, "m").empty(),
             rotary = !of_actuators(a, OfActuator::dynamic_force, "rad").empty();
  if (linear) s.blocks.push_back(actuator_table(a, work, "m", !rotary));
  if (rotary) s.blocks.push_back(actuator_table(a, work, "rad", true));
  for (document::Block& b : equations_of_motion(a, r.equations)) s.blocks.push_back(std::move(b));
  EnergyEvidence energy = energy_evidence(a, work);
  for (Paragraph& p : energy.notes) s.blocks.push_back(std::move(p));
  s.blocks.push_back(evidence(a, energy));
  return {s, values_of(a, work), {}, {}};
}

}  // namespace pmreport::section
