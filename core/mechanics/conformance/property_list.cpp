#include <core/mechanics/conformance/property_list.hpp>

#include <core/mechanics/conformance/wrench_properties.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::mechanics {

// Rounding of one evaluation is some 1e-15; sums over bodies, divisions by limb lengths and poses near the edge of the box cost a few
// digits.
constexpr double rounding = 1e-10;

Verdict Property::verdict() const {
  if (!applies) return Verdict::not_applicable;
  if (evaluations == 0) return Verdict::not_examined;
  return worst <= tolerance ? Verdict::passed : Verdict::failed;
}

std::string pose_in_words(const Machine& machine, const Eigen::VectorXd& coordinates) {
  std::string s;
  for (int i = 0; i < coordinates.size(); ++i)
    s += fmt::format("{}{} = {:.4g}", i > 0 ? ", " : "", machine.topology().coordinates[static_cast<std::size_t>(i)].name, coordinates(i));
  return s;
}

PropertyList::PropertyList(const Machine& machine, double length, const PropertyOptions& options) {
  const auto add = [this](const char* claim, const char* how, double tolerance, const char* unit) -> Property& {
    all.push_back({claim, how, 0, tolerance, unit, ""});
    return all.back();
  };
  all.reserve(40);
  const Topology& t = machine.topology();
  reach =
      &add("poses are in reach", "share of random poses in the box of the coordinates that cannot be assembled", options.out_of_reach, "");
  home = &add("home is regular", "freedoms that the joints leave at home with the actuators held, or with the platform", 0, "");
  units = &add("axes and rotations are unit", "deviation of axes from unit length, of rotations from orthonormal", rounding, "");
  gap = &add("joints close", "joint centres carried from home by both bodies", rounding * length, "m");
  turn = &add("joint axes agree", "joint axes carried from home by both bodies", rounding, "rad");
  velocity = &add("relative velocities are allowed", "twists by jets in the generic constraints", rounding, "");
  acceleration = &add("relative accelerations are allowed", "twist rates by jets in the differentiated constraints", rounding, "");
  drives = &add("actuators measure their joints", "actuator rates by jets against the relative motion at their joints", rounding, "");
  mobility = &add("mobility is as declared", "degrees of freedom and idle freedoms by rank of the generic model", 0, "");
  jacobian = &add("jacobian gives the actuator rates", "G times twist against jets", rounding, "");
  jacobian_rate = &add("jacobian gives the actuator accelerations", "G times twist rate plus G' times twist against jets", rounding, "");
  regular = &add("jacobian is regular at home", "condition of G where the joints hold the platform", singular_condition, "");
  wrenches = &add("constraint wrenches are of unit size", "force, or couple where the unit is N*m, of the rows below the actuators'",
                  rounding, "");
  wrenches->applies = !t.constraints.empty();
  limb_wrenches = &add("constraint wrenches are of the limbs they name", "rows of G against the wrenches of one limb alone", 1e-6, "");
  limb_wrenches->applies = std::ranges::any_of(t.constraints, [](const Constraint& c) { return limb_named(c) > 0; });
  jumps = &add("quantities do not jump", "actuators and derived quantities along paths from home, by their rates", 0, "");
  rates = &add("rates are exact", "jets against differences in extended precision", 1e-12, "");
  accelerations = &add("accelerations are exact", "jets against second differences in extended precision", 1e-10, "");
  matrices = &add("matrices of the source hold", "relations that the source states, with rates by jets", rounding, "");
  matrices->applies = !t.matrices.empty();
  partials = &add("partials are exact", "partials times coordinate rates against jets", rounding, "");
  lanes = &add("lanes equal doubles", "poses many at once against one at a time, all scalar types", 1e-11, "");
  extended = &add("extended precision agrees", "extended against double precision", 1e-12, "");
  recorded = &add("recording equals place and jacobian", "recorded operations on numbers against place and jacobian", 1e-11, "");
  recorded_rates = &add("recording has the same rates", "recorded operations, differentiated in time, against jets", 1e-11, "");
  recorded_partials =
      &add("recording has the same partials", "recorded operations, differentiated by the coordinates, against partials", 1e-11, "");
  for (Property* p : {recorded, recorded_rates, recorded_partials}) p->optional = !machine.records();
  round_trip = &add("forward inverts inverse displacement",
                    "coordinates recovered from actuator values, guess a hundredth of the size away", 1e-8, "");
  statics = &add("closed-form statics equal the generic model's", "actuator forces by G and by the system over all bodies", 1e-8, "");
  power = &add("virtual power balances", "actuator forces times rates plus load times twist", 1e-8, "");
  mass = &add("mass matrix is positive definite", "asymmetry; 1 where a motion has no kinetic energy, or a negative one", rounding, "");
  energy =
      &add("energy balances", "change of kinetic and potential energy by differences against the power of actuators and load", 1e-8, "");
  virtual_work = &add("virtual work equals Newton and Euler", "actuator forces by partials and by the free bodies", 1e-8, "");
  const bool massive = std::ranges::any_of(t.bodies, [](const Body& b) { return b.inertia.mass > 0 || !b.inertia.about_centre.isZero(); });
  mass->applies = massive;
  bodies = &add("every body is in balance", "unbalanced force or moment of the free bodies", 1e-8, "");
  stresses = &add("self-stresses balance", "unbalanced force or moment of the bodies under each self-stress alone", 1e-8, "");
  redundant =
      &add("self-stresses are as many as redundant constraints", "null space of the reactions against the rank of the constraints", 0, "");
  limits = &add("limits are finite", "strokes, joint limits and their motions that are not finite", 0, "");
}

}  // namespace pmreport::mechanics
