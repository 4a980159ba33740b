#include <core/mechanics/conformance/rest_properties.hpp>

#include <core/mechanics/conformance/diagnosis.hpp>
#include <core/mechanics/conformance/wrench_properties.hpp>
#include <core/mechanics/model/closed_form.hpp>

#include <algorithm>

namespace pmreport::mechanics {

namespace {

int undeclared(const Machine& machine, const Mobility& m) {
  return std::abs(m.freedoms - machine.dof()) + std::abs(m.idle - machine.topology().idle);
}
// Freedoms that a regular pose does not have.
int too_many(const Machine& machine, const LockedFreedoms& f) { return f.platform + f.actuators + std::max(0, f.free - machine.dof()); }

void look_at_limbs(const Machine& machine, const State& state, double length, const std::string& where, PropertyList& properties) {
  if (!properties.limb_wrenches->applies) return;
  const ClosedForm c = closed_form(machine, state, length);
  const WrenchDeviation limb = limb_deviation(machine, state, generic_model(machine, state), c.jacobian);
  if (limb.row >= 0) note(*properties.limb_wrenches, limb.value, where, [&] { return about_limb_wrench(machine, limb.row); });
}

}  // namespace

void look_at_rest(const Machine& machine, const Eigen::VectorXd& coordinates, double length, PropertyList& properties) {
  const State s = state_at_rest(machine, coordinates);
  if (s.status != PM_OK) return;
  const Mobility m = mobility(machine, s);
  const std::string where = pose_in_words(machine, coordinates);
  note(*properties.mobility, undeclared(machine, m), where, [&] { return about_mobility(machine, s, m); });
  look_at_limbs(machine, s, length, where, properties);
}

// A mechanism of another mobility than declared has no regular pose, unless that is so at home alone: then home is singular.
void look_at_home(const Machine& machine, const std::vector<Eigen::VectorXd>& beside, double length, PropertyList& properties) {
  const State home = state_at_rest(machine, machine.home());
  if (home.status != PM_OK) return;
  std::vector<State> others;
  for (const Eigen::VectorXd& q : beside)
    if (State s = state_at_rest(machine, q); s.status == PM_OK) others.push_back(std::move(s));

  const Mobility m = mobility(machine, home);
  if (undeclared(machine, m) == 0) {
    note(*properties.mobility, 0, "home");
  } else if (std::ranges::none_of(others, [&](const State& s) { return undeclared(machine, mobility(machine, s)) == 0; })) {
    note(*properties.mobility, undeclared(machine, m), "home", [&] { return about_mobility(machine, home, m); });
    properties.home->unexamined = properties.regular->unexamined = "the mobility is not as declared";
    return;
  }
  look_at_limbs(machine, home, length, "home", properties);

  const LockedFreedoms f = locked_freedoms(machine, home, m, length);
  note(*properties.home, too_many(machine, f), "home", [&] {
    const auto singular = [&](const State& s) { return too_many(machine, locked_freedoms(machine, s, mobility(machine, s), length)) > 0; };
    return about_singular_home(machine, f, !others.empty() && std::ranges::all_of(others, singular));
  });
  if (too_many(machine, f) > 0) {
    properties.regular->unexamined = "home is singular";
    return;
  }
  const ClosedForm c = closed_form(machine, home, length);
  note(*properties.regular, c.condition, "home", [&] { return about_singular_jacobian(machine, c.jacobian); });
}

}  // namespace pmreport::mechanics
