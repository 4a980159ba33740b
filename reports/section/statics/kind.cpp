#include <reports/section/statics/statics.hpp>

namespace pmreport::section {

const SectionKind& statics_kind() {
  static const SectionKind kind{{.name = "statics",
                                 .purpose = "actuator forces and constraint wrenches that hold the platform at rest",
                                 .needs = {.statics = true},
                                 .columns = analysis::statics_columns},
                                [](const Context& c, const scenario::Section&) { return statics_section(c.analysis); }};
  return kind;
}

}  // namespace pmreport::section
