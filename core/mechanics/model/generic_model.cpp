#include <core/mechanics/model/generic_model.hpp>

#include <Eigen/Geometry>
#include <array>
#include <core/assertion.hpp>

namespace pmreport::mechanics {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Writes the rows of one joint. A body's columns are 6 (body - 1) ...; the base has none.
class Rows {
 public:
  Rows(GenericModel& m, const State& s, const Joint& j, const JointState& at, int first)
      : m_(m),
        a_(j.a),
        b_(j.b),
        sa_(s.bodies[static_cast<std::size_t>(j.a)]),
        sb_(s.bodies[static_cast<std::size_t>(j.b)]),
        at_(at),
        row_(first) {
    const Vector3d p_AC = at.centre - sa_.origin, p_BC = at.centre - sb_.origin;
    centre_rate_ = sa_.velocity + sa_.angular_velocity.cross(p_AC);
    relative_velocity_ = sb_.velocity + sb_.angular_velocity.cross(p_BC) - centre_rate_;
    relative_rotation_ = sb_.angular_velocity - sa_.angular_velocity;
  }

  // (2), and what the accelerations do not enter of (4).
  void force(const Vector3d& e, const Vector3d& e_rate) {
    const Vector3d p_AC = at_.centre - sa_.origin, p_BC = at_.centre - sb_.origin;
    if (b_ > 0) m_.constraints.block<1, 6>(row_, 6 * b_ - 6) << e.transpose(), p_BC.cross(e).transpose();
    if (a_ > 0) m_.constraints.block<1, 6>(row_, 6 * a_ - 6) << -e.transpose(), -p_AC.cross(e).transpose();
    m_.bias(row_) = e_rate.dot(relative_velocity_) + e.dot(sb_.angular_velocity.cross(centre_rate_ - sb_.velocity) -
                                                           sa_.angular_velocity.cross(centre_rate_ - sa_.velocity));
    ++row_;
  }
  // (3), and likewise of (5).
  void couple(const Vector3d& e, const Vector3d& e_rate) {
    if (b_ > 0) m_.constraints.block<1, 3>(row_, 6 * b_ - 3) = e.transpose();
    if (a_ > 0) m_.constraints.block<1, 3>(row_, 6 * a_ - 3) = -e.transpose();
    m_.bias(row_) = e_rate.dot(relative_rotation_);
    ++row_;
  }
  void three_forces() {
    for (int k = 0; k < 3; ++k) force(Vector3d::Unit(k), Vector3d::Zero());
  }
  // Two directions across axis 1, carried by body a.
  void forces_across() {
    for (const Vector3d& e : across()) force(e, sa_.angular_velocity.cross(e));
  }
  void couples_across() {
    for (const Vector3d& e : across()) couple(e, sa_.angular_velocity.cross(e));
  }
  void couple_along() { couple(at_.axis[0], sa_.angular_velocity.cross(at_.axis[0])); }
  void couple_of_cross() {  // axis 1 is carried by body a, axis 2 by body b
    const Vector3d &a1 = at_.axis[0], &a2 = at_.axis[1];
    couple(a1.cross(a2), sa_.angular_velocity.cross(a1).cross(a2) + a1.cross(sb_.angular_velocity.cross(a2)));
  }

 private:
  std::array<Vector3d, 2> across() const {
    const Vector3d e = at_.axis[0].unitOrthogonal();
    return {e, at_.axis[0].cross(e)};
  }

  GenericModel& m_;
  int a_, b_;
  const BodyState &sa_, &sb_;
  const JointState& at_;
  int row_;
  Vector3d centre_rate_, relative_velocity_, relative_rotation_;
};

}  // namespace

GenericModel generic_model(const Machine& machine, const State& state) {
  PMREPORT_ASSERT(state.status == PM_OK, "the state is that of an assembled pose");
  const Topology& t = machine.topology();
  const int columns = 6 * (static_cast<int>(t.bodies.size()) - 1);
  GenericModel m;
  for (std::size_t i = 0; i < t.joints.size(); ++i)
    for (int r = freedoms_of(t.joints[i].kind); r < 6; ++r) m.joint_of_row.push_back(static_cast<int>(i));
  const int rows = static_cast<int>(m.joint_of_row.size());
  m.constraints = MatrixXd::Zero(rows, columns);
  m.bias = VectorXd::Zero(rows);
  int first = 0;
  for (std::size_t i = 0; i < t.joints.size(); ++i) {
    Rows r(m, state, t.joints[i], state.joints[i], first);
    switch (t.joints[i].kind) {
      case JointKind::spherical:
        r.three_forces();
        break;
      case JointKind::revolute:
        r.three_forces(), r.couples_across();
        break;
      case JointKind::universal:
        r.three_forces(), r.couple_of_cross();
        break;
      case JointKind::cylindrical:
        r.forces_across(), r.couples_across();
        break;
      case JointKind::prismatic:
        r.forces_across(), r.couples_across(), r.couple_along();
        break;
    }
    first += 6 - freedoms_of(t.joints[i].kind);
  }
  m.actuation = MatrixXd::Zero(static_cast<int>(t.actuators.size()), columns);
  for (std::size_t i = 0; i < t.actuators.size(); ++i) {
    const Actuator& a = t.actuators[i];
    const Joint& j = t.joints[static_cast<std::size_t>(a.joint)];
    const JointState& at = state.joints[static_cast<std::size_t>(a.joint)];
    const Vector3d& n = at.axis[0];
    for (const auto& [body, sign] : {std::pair{j.b, 1.0}, std::pair{j.a, -1.0}}) {
      if (body == 0) continue;
      auto cell = m.actuation.block<1, 6>(static_cast<int>(i), 6 * body - 6);
      if (a.sense() == Sense::linear)
        cell << sign * n.transpose(), sign * (at.centre - state.bodies[static_cast<std::size_t>(body)].origin).cross(n).transpose();
      else
        cell << 0, 0, 0, sign * n.transpose();
    }
  }
  return m;
}

VectorXd stacked_twists(const State& state) {
  VectorXd v(6 * (static_cast<int>(state.bodies.size()) - 1));
  for (std::size_t i = 1; i < state.bodies.size(); ++i) v.segment<6>(6 * static_cast<int>(i) - 6) = state.bodies[i].twist();
  return v;
}

VectorXd stacked_twist_rates(const State& state) {
  VectorXd v(6 * (static_cast<int>(state.bodies.size()) - 1));
  for (std::size_t i = 1; i < state.bodies.size(); ++i) v.segment<6>(6 * static_cast<int>(i) - 6) = state.bodies[i].twist_rate();
  return v;
}

double characteristic_length(const Machine& machine) {
  const Topology& t = machine.topology();
  const Vector3d p = machine.origin(machine.home_pose(), t.platform);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < t.joints.size(); ++i)
    if (t.joints[i].a == t.platform || t.joints[i].b == t.platform) {
      sum += (machine.centre(machine.home_pose(), static_cast<int>(i)) - p).norm();
      ++count;
    }
  return sum > 0 ? sum / count : 1.0;
}

}  // namespace pmreport::mechanics
