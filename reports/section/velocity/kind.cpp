#include <reports/section/velocity/velocity.hpp>

namespace pmreport::section {

const SectionKind& velocity_kind() {
  static const SectionKind kind{{.name = "velocity",
                                 .purpose = "rates of the actuators, twist of the platform, condition of the overall Jacobian",
                                 .needs = {.velocity_evidence = true},
                                 .columns = analysis::velocity_columns},
                                [](const Context& c, const scenario::Section&) { return velocity_section(c.analysis); }};
  return kind;
}

}  // namespace pmreport::section
