#include <reports/section/displacement/displacement.hpp>

#include <reports/section/common/kinematic_plots.hpp>

namespace pmreport::section {

namespace {

std::string glance(const Analysis& a, figure::Figure& f) {
  add_panel(f, a, "position", "position", "m", group(a, analysis::displacement_columns, "coordinate", "m"));
  add_panel(f, a, "orientation", "angle", "rad", group(a, analysis::displacement_columns, "coordinate", "rad"));
  add_actuators(f, a, analysis::displacement_columns, OfMotion::value, linear_drives(a) ? "actuator length" : "actuator value", "");
  return "position and orientation of the platform, displacement of the actuators";
}

}  // namespace

const SectionKind& displacement_kind() {
  static const SectionKind kind{{.name = "displacement",
                                 .purpose = "pose of the platform, actuators and joint motions against time",
                                 .needs = {.displacement_evidence = true},
                                 .columns = analysis::displacement_columns},
                                [](const Context& c, const scenario::Section&) { return displacement_section(c.analysis); },
                                glance};
  return kind;
}

}  // namespace pmreport::section
