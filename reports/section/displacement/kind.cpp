#include <reports/section/displacement/displacement.hpp>

namespace pmreport::section {

const SectionKind& displacement_kind() {
  static const SectionKind kind{{.name = "displacement",
                                 .purpose = "pose of the platform, actuators and joint motions against time",
                                 .needs = {.displacement_evidence = true},
                                 .columns = analysis::displacement_columns},
                                [](const Context& c, const scenario::Section&) { return displacement_section(c.analysis); }};
  return kind;
}

}  // namespace pmreport::section
