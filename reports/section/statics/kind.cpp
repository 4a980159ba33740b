#include <reports/section/statics/statics.hpp>

#include <reports/section/common/kinematic_plots.hpp>
#include <reports/section/dynamics/dynamics.hpp>

namespace pmreport::section {

namespace {

std::string glance(const Analysis& a, figure::Figure& f) {
  const std::string words = a.scenario().asks_for(dynamics_kind()) ? " at rest" : "";
  for (const std::string unit : {"N", "N*m"}) {
    std::vector<Trace> forces = group(a, analysis::statics_columns, "actuator_force", unit);
    for (const Trace& c : group(a, analysis::statics_columns, "constraint", unit)) forces.push_back(c);
    const std::string kind = unit == "N" ? "force" : "moment";
    add_panel(f, a, kind + "s" + words, kind, unit, forces);
  }
  return "actuator forces and constraint wrenches at rest";
}

}  // namespace

const SectionKind& statics_kind() {
  static const SectionKind kind{{.name = "statics",
                                 .purpose = "actuator forces and constraint wrenches that hold the platform at rest",
                                 .needs = {.statics = true},
                                 .columns = analysis::statics_columns},
                                [](const Context& c, const scenario::Section&) { return statics_section(c.analysis); },
                                glance};
  return kind;
}

}  // namespace pmreport::section
