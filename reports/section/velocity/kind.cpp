#include <reports/section/velocity/velocity.hpp>

#include <reports/section/common/kinematic_plots.hpp>

namespace pmreport::section {

namespace {

std::string glance(const Analysis& a, figure::Figure& f) {
  add_actuators(f, a, analysis::velocity_columns, OfMotion::rate, "actuator rate", "/s");
  return "their rates";
}

}  // namespace

const SectionKind& velocity_kind() {
  static const SectionKind kind{{.name = "velocity",
                                 .purpose = "rates of the actuators, twist of the platform, condition of the overall Jacobian",
                                 .needs = {.velocity_evidence = true},
                                 .columns = analysis::velocity_columns},
                                [](const Context& c, const scenario::Section&) { return velocity_section(c.analysis); },
                                glance};
  return kind;
}

}  // namespace pmreport::section
