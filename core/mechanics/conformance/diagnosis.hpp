// What the author of a mechanism should look at when a property fails: sentences that name the joint or body, the residual and the likely
// mistake. They cost more than the test that failed, and are asked for only then.
#pragma once

#include <core/mechanics/singularity/singularity.hpp>

#include <string>

namespace pmreport::mechanics {

// "joint B1 (spherical, arm 1 and rod 11)"
std::string in_words(const Machine& machine, int joint);

// Joint `joint` parts by `gap` [m] in this state.
std::string about_gap(const Machine& machine, const State& state, int joint, double gap);
// The two images of its axis, or the orientations that a prismatic joint keeps, differ by `angle` [rad].
std::string about_misalignment(const Machine& machine, int joint, double angle);
// Its bodies move in a way that it forbids, by `share` of the largest twist.
std::string about_forbidden_motion(const Machine& machine, int joint, double share);
// The plugin gave a rotation or an axis that is not unit: of body `body`, or of axis `axis` of joint `joint`.
std::string about_body(const Machine& machine, const State& state, int body);
std::string about_axis(const Machine& machine, const State& state, int joint, int axis);
// The value of actuator `actuator` changes at another rate than the motion of its joint, `joint_rate` [m/s, rad/s].
std::string about_drive(const Machine& machine, const State& state, int actuator, double joint_rate);
// Row `row` of G.
std::string about_row(const Machine& machine, int row);
// Mobility found at a state is not the declared one: what still moves when every actuator is held.
std::string about_mobility(const Machine& machine, const State& state, const Mobility& found);

// Home is singular, `freedoms` there; `everywhere`: so are other poses that were tried.
std::string about_singular_home(const Machine& machine, const LockedFreedoms& freedoms, bool everywhere);
// The mechanism is regular at home, but the overall Jacobian G there is not.
std::string about_singular_jacobian(const Machine& machine, const Matrix6d& jacobian);
// Row `row` of G, a constraint's, is no unit wrench of the kind that its unit declares.
std::string about_wrench(const Machine& machine, const Matrix6d& jacobian, int row);
// It does work on what the limb that it names lets the platform do.
std::string about_limb_wrench(const Machine& machine, int row);

}  // namespace pmreport::mechanics
