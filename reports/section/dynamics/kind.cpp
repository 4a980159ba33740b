#include <reports/section/dynamics/dynamics.hpp>

#include <core/scenario/section/keys.hpp>

namespace pmreport::section {

using scenario::Shape;
namespace keys = scenario::keys;

namespace {

constexpr std::size_t most_equations = 12;  // each fills a table of its own

void read_equations(const scenario::Entry& e, const scenario::Reading& r, DynamicsOptions& options) {
  for (const scenario::Value& item : items_of(e, most_equations, r.reader))
    if (const auto t = read_time(item, r.span, r.reader)) add_once(options.equations, *t, item, r.reader);
}

std::vector<scenario::Quantity> quantities(const scenario::Options*) {
  return {{"dynamics.peak_force", "N", "largest force of a linear actuator", false},
          {"dynamics.peak_torque", "N*m", "largest torque of a rotary actuator", false},
          {"dynamics.peak_power", "W", "largest power of any actuator", false},
          {"dynamics.work", "J", "work of the actuators over the motion", false},
          {"dynamics.regenerated", "J", "work that loads and inertia give back to actuators over the motion", false},
          {"dynamics.energy_drift", "J", "energy that a motion by forces loses or gains by integration", false}};
}

}  // namespace

const SectionKind& dynamics_kind() {
  static const SectionKind kind{
      {.name = "dynamics",
       .purpose = "actuator forces in motion by load, weights and inertia; powers, work, energies",
       .keys = {keys::of<DynamicsOptions>("equations", Shape::list(1, most_equations, Shape::quantity(Dimension{0, 0, 1, 0})),
                                          "times at which mass matrix, Coriolis and gravity terms are given, `[\"0 s\", \"5 s\"]`", "none",
                                          read_equations)},
       .needs = {.dynamics = true, .force_evidence = true, .power_evidence = true},
       .columns = analysis::dynamics_columns,
       .quantities = quantities,
       .make_options = scenario::plain_options<DynamicsOptions>},
      [](const Context& c, const scenario::Section& s) { return dynamics_section(c.analysis, options_of<DynamicsOptions>(s)); }};
  return kind;
}

}  // namespace pmreport::section
