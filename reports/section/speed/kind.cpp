#include <reports/section/speed/speed.hpp>

namespace pmreport::section {

namespace {

std::vector<scenario::Quantity> quantities(const scenario::Options*) {
  return {{"speed.scale", "", "how many times as fast the motion could run", false},
          {"speed.duration", "s", "duration of the motion at that speed", false}};
}

}  // namespace

const SectionKind& speed_kind() {
  static const SectionKind kind{
      {.name = "speed",
       .purpose = "how many times as fast the motion could run within the limits",
       .needs = {.dynamics = true},
       .tables = {{"limits", "at least one limit, and there is none",
                   "add [limits] and at least one of actuator_force, actuator_speed, actuator_power, joint_force and joint_moment"}},
       .quantities = quantities},
      [](const Context& c, const scenario::Section&) { return speed_section(c.analysis); }};
  return kind;
}

}  // namespace pmreport::section
