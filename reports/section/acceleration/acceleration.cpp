// Section `acceleration`.
#include <reports/section/acceleration/acceleration.hpp>
#include <reports/section/common/kinematic_plots.hpp>

namespace pmreport::section {

using document::Section;

Result acceleration_section(const Analysis& a) {
  Section s{"acceleration", "acceleration", "Acceleration", {}};
  figure::Figure f{
      "acceleration", "Accelerations of the actuators and of the platform.", "data/acceleration.csv", figure::Width::full, 2, {}};
  add_actuators(f, a, analysis::acceleration_columns, OfMotion::acceleration, "actuator acceleration", "/s^2");
  add_panel(f, a, "acceleration of the platform", "acceleration", "m/s^2", group(a, analysis::acceleration_columns, "acceleration"));
  add_panel(f, a, "angular acceleration of the platform", "angular acceleration", "rad/s^2",
            group(a, analysis::acceleration_columns, "angular_acceleration"));
  put(s, std::move(f));
  s.blocks.push_back(
      extremes(a, "Extremes over the motion.",
               columns_in(a, analysis::acceleration_columns, {"actuator_acceleration", "acceleration", "angular_acceleration"})));
  s.blocks.push_back(
      proof(a, {{Measure::acceleration, "Relative accelerations are those the joints allow",
                 "accelerations of all bodies in the differentiated constraints of the generic model, relative", 1e-9, ""},
                {Measure::jacobian_rate, "Closed form equals the geometry",
                 "G times twist rate plus dG/dt times twist, against actuator accelerations by differentiation, relative", 1e-9, ""},
                {Measure::forward_acceleration, "Forward acceleration returns the twist rate",
                 "solved from the actuator accelerations, relative", 1e-7, ""},
                {Measure::difference_acceleration, "Second derivatives are exact",
                 "accelerations of every body and joint against eighth-order differences in extended precision, relative", 1e-9, ""}}));
  return {s};
}

}  // namespace pmreport::section
