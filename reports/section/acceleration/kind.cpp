#include <reports/section/acceleration/acceleration.hpp>

#include <reports/section/common/kinematic_plots.hpp>

namespace pmreport::section {

namespace {

std::string glance(const Analysis& a, figure::Figure& f) {
  add_actuators(f, a, analysis::acceleration_columns, OfMotion::acceleration, "actuator acceleration", "/s^2");
  return "their accelerations";
}

}  // namespace

const SectionKind& acceleration_kind() {
  static const SectionKind kind{{.name = "acceleration",
                                 .purpose = "accelerations of the actuators and of the platform",
                                 .needs = {.acceleration_evidence = true},
                                 .columns = analysis::acceleration_columns},
                                [](const Context& c, const scenario::Section&) { return acceleration_section(c.analysis); },
                                glance};
  return kind;
}

}  // namespace pmreport::section
