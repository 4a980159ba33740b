#include <reports/section/acceleration/acceleration.hpp>

namespace pmreport::section {

const SectionKind& acceleration_kind() {
  static const SectionKind kind{{.name = "acceleration",
                                 .purpose = "accelerations of the actuators and of the platform",
                                 .needs = {.acceleration_evidence = true},
                                 .columns = analysis::acceleration_columns},
                                [](const Context& c, const scenario::Section&) { return acceleration_section(c.analysis); }};
  return kind;
}

}  // namespace pmreport::section
