#include <reports/section/mechanism/mechanism.hpp>

namespace pmreport::section {

const SectionKind& mechanism_kind() {
  static const SectionKind kind{{.name = "mechanism",
                                 .purpose = "the mechanism at home, its parameters, joints, bodies and mobility",
                                 .needs = {.motion = false, .pictures = true}},
                                [](const Context& c, const scenario::Section&) { return mechanism_section(c.analysis, c.stage); }};
  return kind;
}

}  // namespace pmreport::section
