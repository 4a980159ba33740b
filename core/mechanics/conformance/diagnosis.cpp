#include <core/mechanics/conformance/diagnosis.hpp>
#include <core/mechanics/conformance/wrench_properties.hpp>

#include <core/linear/singular_values.hpp>
#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/model/constraint_scale.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/numbers.hpp>
#include <core/text/text.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::mechanics {

namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const Joint& joint_of(const Machine& m, int joint) { return m.topology().joints[static_cast<std::size_t>(joint)]; }
const std::string& name_of(const Machine& m, int body) { return m.topology().bodies[static_cast<std::size_t>(body)].name; }

// The motions that the joints allow while every actuator is held: an orthonormal basis, rotations times `length`. A rank by singular
// values, with the threshold that mobility() has.
MatrixXd motions_with_drives_held(const Machine& machine, const State& state, double length) {
  const GenericModel model = generic_model(machine, state);
  MatrixXd all(model.constraints.rows() + model.actuation.rows(), model.constraints.cols());
  all << model.constraints, model.actuation;
  return linear::null_space_by_singular_values(unit_rows(std::move(all), length));
}

// A motion of the platform, linear part and rotations times length: "shift along (0, 0, 1)" or "turn about (0, 0, 1)".
std::string motion_in_words(const VectorXd& twist) {
  const bool turns = twist.tail(3).norm() > linear::part_tolerance * twist.norm();
  Vector3d d = (turns ? twist.tail<3>() : twist.head<3>()).normalized();
  Eigen::Index largest = 0;
  d.cwiseAbs().maxCoeff(&largest);
  if (d(largest) < 0) d = -d;                                                // either way is the same freedom
  const auto clean = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; };  // no "-0.000"
  return fmt::format("{} ({:.3f}, {:.3f}, {:.3f})", turns ? "turn about" : "shift along", clean(d.x()), clean(d.y()), clean(d.z()));
}

}  // namespace

std::string in_words(const Machine& machine, int joint) {
  const Joint& j = joint_of(machine, joint);
  return fmt::format("joint {} ({}, {} and {})", j.name, word_of(j.kind), name_of(machine, j.a), name_of(machine, j.b));
}

std::string about_gap(const Machine& machine, const State& state, int joint, double gap) {
  const Joint& j = joint_of(machine, joint);
  if (state.joints[static_cast<std::size_t>(joint)].centre.isZero() && machine.centre(machine.home_pose(), joint).isZero())
    return fmt::format("its centre is (0, 0, 0), at home too, and {} and {} part there by {:.3g} mm; does place give joint {}?",
                       name_of(machine, j.a), name_of(machine, j.b), gap * 1e3, j.name);
  return fmt::format(
      "the point where {} and {} meet at home is {:.3g} mm away from itself{}; look at where place puts these two bodies, and at what "
      "closes "
      "the limb",
      name_of(machine, j.a), name_of(machine, j.b), gap * 1e3,
      j.kind == JointKind::prismatic || j.kind == JointKind::cylindrical ? ", across the axis" : "");
}

std::string about_misalignment(const Machine& machine, int joint, double angle) {
  const Joint& j = joint_of(machine, joint);
  const std::string &a = name_of(machine, j.a), &b = name_of(machine, j.b);
  const double degrees = angle / deg;
  switch (j.kind) {
    case JointKind::universal:
      return fmt::format(
          "its axes are {:.3g} deg from perpendicular; axis 1 must be fixed in {}, axis 2 in {}: look at the two that place "
          "gives, and at the rotations of the two bodies",
          degrees, a, b);
    case JointKind::prismatic:
      return fmt::format(
          "{} and {} turn by {:.3g} deg against each other, or their axes do; look at the rotations of the two bodies, and at "
          "the axis that place gives",
          a, b, degrees);
    default:
      return fmt::format(
          "its axis as {} carries it and as {} carries it differ by {:.3g} deg; it must be fixed in both: look at the axis "
          "that place gives, and at the rotations of the two bodies",
          a, b, degrees);
  }
}

std::string about_forbidden_motion(const Machine& machine, int joint, double share) {
  const Joint& j = joint_of(machine, joint);
  return fmt::format(
      "{} and {} move against each other as no {} joint allows, by {:.2g} of the largest motion; look at its kind, its axes "
      "and its centre",
      name_of(machine, j.a), name_of(machine, j.b), word_of(j.kind), share);
}

std::string about_body(const Machine& machine, const State& state, int body) {
  const bool slender = machine.topology().bodies[static_cast<std::size_t>(body)].slender;
  const std::size_t at = 3 * (machine.layout().body(body) + 3);
  const auto zero = [](double x) { return x == 0; };
  const auto from = state.placement_jets.begin() + static_cast<std::ptrdiff_t>(at);
  if (std::all_of(from, from + (slender ? 9 : 27), zero))
    return fmt::format("body {}: its {} is zero; does place put it anywhere?", name_of(machine, body), slender ? "axis" : "rotation");
  if (slender)
    return fmt::format("body {}: its axis has length {:.6g}; is it divided by its length, and does its limb close?", name_of(machine, body),
                       Vector3d(from[0], from[3], from[6]).norm());
  return fmt::format("body {}: its rotation is not orthonormal, or left-handed; its columns are the body's axes", name_of(machine, body));
}

std::string about_axis(const Machine& machine, const State& state, int joint, int axis) {
  const bool zero = state.joints[static_cast<std::size_t>(joint)].axis[axis].isZero();
  return fmt::format("axis {} of {} is {}", axis + 1, in_words(machine, joint),
                     zero ? "zero; does place give this joint with its axes?" : "not of unit length; is it divided by its length?");
}

std::string about_drive(const Machine& machine, const State& state, int actuator, double joint_rate) {
  const Actuator& a = machine.topology().actuators[static_cast<std::size_t>(actuator)];
  return fmt::format(
      "actuator {} changes by {:.4g} {}/s, {} by {:.4g}; look at its sign, at its joint, and at what place gives as its value", a.name,
      state.actuators[static_cast<std::size_t>(actuator)].rate, a.unit, in_words(machine, a.joint), joint_rate);
}

std::string about_row(const Machine& machine, int row) {
  const Topology& t = machine.topology();
  const std::size_t i = static_cast<std::size_t>(row), dof = t.actuators.size();
  return fmt::format("row {} of the Jacobian ({})", row + 1, i < dof ? t.actuators[i].name : t.constraints[i - dof].name);
}

// Declared too few: what moves though every drive is held tells what nothing holds. An idle spin is such a motion too, of a slender body
// about its own axis, and is left out.
std::string about_mobility(const Machine& machine, const State& state, const Mobility& found) {
  const Topology& t = machine.topology();
  std::string out =
      fmt::format("found {} degrees of freedom and {} idle, declared {} and {}", found.freedoms, found.idle, machine.dof(), t.idle);
  if (found.freedoms < machine.dof())
    return out + "; the joints hold more than the coordinates move: look for a joint that allows too little, or that is declared twice";

  MatrixXd moves = motions_with_drives_held(machine, state, characteristic_length(machine));
  std::vector<std::string> loose, spinning;
  for (std::size_t body = 1; body < t.bodies.size(); ++body) {
    const auto rows = static_cast<Eigen::Index>(6 * body - 6);
    const Vector3d spine = state.bodies[body].rotation.col(2);
    const auto spin = moves.middleRows(rows + 3, 3);
    if (t.bodies[body].slender && (spine.transpose() * spin).norm() > linear::part_tolerance) {
      spinning.push_back(t.bodies[body].name);
      moves.middleRows(rows + 3, 3) -= spine * (spine.transpose() * spin).eval();
    }
    if (moves.middleRows(rows, 6).norm() > linear::part_tolerance) loose.push_back(t.bodies[body].name);
  }
  if (loose.empty())
    return out + fmt::format("; {}: declare {} idle freedoms",
                             spinning.empty() ? "nothing spins about itself" : "about themselves spin " + listed(spinning), found.idle);
  out += fmt::format("; with every actuator held {} can still move", listed(loose));
  const linear::LeftSingular platform = linear::left_singular(moves.middleRows(6 * t.platform - 6, 6));
  const auto ways = (platform.values.array() > linear::part_tolerance).count();
  if (ways == 1) out += fmt::format(", the platform can {}", motion_in_words(platform.vectors.col(0)));
  return out + (ways > 0 ? ": a coordinate with its actuator is missing, or a joint or a limb, or a joint allows too much"
                         : ": a joint is missing, or allows too much");
}

std::string about_singular_home(const Machine& machine, const LockedFreedoms& freedoms, bool everywhere) {
  std::string out = everywhere ? "home is singular, and so is every other pose that was tried: such an architecture is no machine"
                               : "home is on a singular surface";
  if (freedoms.free > machine.dof())
    out += fmt::format("; with every actuator free the platform has {} freedoms there, not {}", freedoms.free, machine.dof());
  if (freedoms.platform == 1)
    out += fmt::format("; with every actuator held the platform can {}", motion_in_words(freedoms.escapes.basis.col(0)));
  if (freedoms.platform > 1) out += fmt::format("; with every actuator held the platform has {} freedoms", freedoms.platform);
  if (freedoms.actuators > 0) out += "; with the platform held an actuator can still move: the end of its reach";
  return out + (everywhere ? "" : "; choose another home, or other sizes");
}

std::string about_singular_jacobian(const Machine& machine, const Matrix6d& jacobian) {
  if (!jacobian.allFinite()) return "the overall Jacobian has no finite value at home, though the joints hold the platform there";
  for (int row = 0; row < 6; ++row)
    if (jacobian.row(row).isZero()) return about_row(machine, row) + " is zero at home; does jacobian fill it?";
  return "the rows of the overall Jacobian depend on one another at home, though the joints hold the platform there; is a row given twice?";
}

std::string about_wrench(const Machine& machine, const Matrix6d& jacobian, int row) {
  const Constraint& c = machine.topology().constraints[static_cast<std::size_t>(row - machine.dof())];
  const double force = jacobian.row(row).head<3>().norm(), moment = jacobian.row(row).tail<3>().norm();
  const std::string which = about_row(machine, row);
  if (force == 0 && moment == 0) return which + " is zero; does jacobian fill it?";
  if (c.sense() == Sense::linear && force == 0)
    return fmt::format("{} is a couple, though {} is declared in N: are the rows in the order of the constraints?", which, c.name);
  if (c.sense() == Sense::linear)
    return fmt::format("{} has a force of {:.4g} where a unit wrench has 1: 1 N of it would be told as {:.4g} N", which, force, 1 / force);
  if (moment == 0) return fmt::format("{} has no moment, though {} is declared in N*m", which, c.name);
  return fmt::format("{} has a moment of {:.4g} where a unit wrench in N*m has 1{}", which, moment,
                     force > 0 ? fmt::format(", and a force of {:.4g}: are the rows in the order of the constraints?", force)
                               : fmt::format(": 1 N*m of it would be told as {:.4g} N*m", 1 / moment));
}

std::string about_limb_wrench(const Machine& machine, int row) {
  const Constraint& c = machine.topology().constraints[static_cast<std::size_t>(row - machine.dof())];
  return fmt::format(
      "{} does work on what limb {} allows the platform, which its title names: are the rows in the order of the constraints?",
      about_row(machine, row), limb_named(c));
}

}  // namespace pmreport::mechanics
