#include <core/mechanics/assembly/loops.hpp>

#include <core/mechanics/model/closure.hpp>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace pmreport::mechanics {

using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Writes the equations one after the other.
class Writer {
 public:
  Writer(LoopEquations::Value& out, double length) : out_(out), length_(length) {}

  struct Side {  // a body at a joint, base axes
    int body;
    Vector3d arm;  // from its origin to its centre
  };
  Side a{}, b{};
  Vector3d d = Vector3d::Zero();

  void way(const Vector3d& e) { row(e.dot(d) / length_, e, e.cross(d) / length_); }
  // Along a direction that no body carries.
  void way_fixed(const Vector3d& e) { row(e.dot(d) / length_, e, Vector3d::Zero()); }
  // e carried by A, f by B.
  void product(const Vector3d& e, const Vector3d& f) {
    out_.error(at_) = e.dot(f);
    turn(a.body, e.cross(f));
    turn(b.body, f.cross(e));
    ++at_;
  }
  void length(const Vector3d& n, double beyond) {
    way(n);
    out_.error(at_ - 1) += beyond / length_;
  }
  void angle(const Vector3d& n, double value) {
    out_.error(at_) = std::remainder(value, 2 * std::numbers::pi);
    turn(a.body, -n);
    turn(b.body, n);
    ++at_;
  }

 private:
  void row(double value, const Vector3d& e, const Vector3d& by_a) {
    out_.error(at_) = value;
    if (b.body > 0) out_.slope.block<1, 6>(at_, 6 * b.body - 6) << e.transpose(), b.arm.cross(e).transpose() / length_;
    if (a.body > 0) out_.slope.block<1, 6>(at_, 6 * a.body - 6) << -e.transpose(), (by_a - a.arm.cross(e) / length_).transpose();
    ++at_;
  }
  void turn(int body, const Vector3d& by) {
    if (body > 0) out_.slope.block<1, 3>(at_, 6 * body - 3) += by.transpose();
  }

  LoopEquations::Value& out_;
  double length_;
  int at_ = 0;
};

}  // namespace

LoopEquations::LoopEquations(const Machine& machine, double length) : machine_(machine), length_(length) {
  const Topology& t = machine.topology();
  const Pose& home = machine.home_pose();
  const std::vector<BodyState> bodies = bodies_at_rest(machine, home);
  for (int i = 0; i < static_cast<int>(t.joints.size()); ++i) {
    const Joint& j = t.joints[static_cast<std::size_t>(i)];
    const Vector3d n = axes_of(j.kind) > 0 ? machine.axis(home, i) : Vector3d(Vector3d::UnitZ());
    const Vector3d second = axes_of(j.kind) > 1 ? machine.axis(home, i, 1) : n, e1 = n.unitOrthogonal();
    const auto seat = [&](int body) {
      const BodyState& s = bodies[static_cast<std::size_t>(body)];
      const auto in = [&](const Vector3d& v) { return Vector3d(s.rotation.transpose() * v); };
      return Seat{in(machine.centre(home, i) - s.origin), {in(n), in(second)}, in(e1), in(n.cross(e1))};
    };
    const auto slender = [&](int body) { return t.bodies[static_cast<std::size_t>(body)].slender; };
    joints_.push_back({seat(j.a), seat(j.b), slender(j.a) || slender(j.b)});
    rows_ += 6 - freedoms_of(j.kind) - (j.kind == JointKind::prismatic && joints_.back().spins ? 1 : 0);
  }
  home_actuators_ = Eigen::Map<const VectorXd>(home.numbers.data() + machine.layout().actuator(0), machine.dof());
  rows_ += machine.dof();
}

LoopEquations::Value LoopEquations::at(const std::vector<BodyState>& bodies, const VectorXd& actuators) const {
  const Topology& t = machine_.topology();
  Value out{VectorXd::Zero(rows_), Eigen::MatrixXd::Zero(rows_, 6 * static_cast<int>(bodies.size() - 1))};
  Writer write(out, length_);
  const auto open = [&](std::size_t i) -> std::pair<const BodyState&, const BodyState&> {
    const Joint& j = t.joints[i];
    const BodyState &a = bodies[static_cast<std::size_t>(j.a)], &b = bodies[static_cast<std::size_t>(j.b)];
    write.a = {j.a, a.rotation * joints_[i].a.centre};
    write.b = {j.b, b.rotation * joints_[i].b.centre};
    write.d = b.origin + write.b.arm - a.origin - write.a.arm;
    return {a, b};
  };
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto& [a, b] = open(i);
    const Held& h = joints_[i];
    const Vector3d e1 = a.rotation * h.a.e1, e2 = a.rotation * h.a.e2, n_b = b.rotation * h.b.axis[0];
    switch (t.joints[i].kind) {
      case JointKind::spherical:
        for (int k = 0; k < 3; ++k) write.way_fixed(Vector3d::Unit(k));
        break;
      case JointKind::revolute:
        for (int k = 0; k < 3; ++k) write.way_fixed(Vector3d::Unit(k));
        write.product(e1, n_b), write.product(e2, n_b);
        break;
      case JointKind::universal:
        for (int k = 0; k < 3; ++k) write.way_fixed(Vector3d::Unit(k));
        write.product(a.rotation * h.a.axis[0], b.rotation * h.b.axis[1]);
        break;
      case JointKind::cylindrical:
      case JointKind::prismatic:
        write.way(e1), write.way(e2);
        write.product(e1, n_b), write.product(e2, n_b);
        if (t.joints[i].kind == JointKind::prismatic && !h.spins) write.product(e1, b.rotation * h.b.e2);
        break;
    }
  }
  for (std::size_t k = 0; k < t.actuators.size(); ++k) {
    const auto i = static_cast<std::size_t>(t.actuators[k].joint);
    const auto& [a, b] = open(i);
    const Held& h = joints_[i];
    const Vector3d n = a.rotation * h.a.axis[0];
    const auto at = static_cast<Eigen::Index>(k);
    const double beyond = home_actuators_(at) - actuators(at);
    if (t.actuators[k].sense() == Sense::linear) {
      write.length(n, beyond);
    } else {
      const Vector3d e1 = a.rotation * h.a.e1, e2 = a.rotation * h.a.e2, f1 = b.rotation * h.b.e1;
      write.angle(n, std::atan2(e2.dot(f1), e1.dot(f1)) + beyond);
    }
  }
  return out;
}

void LoopEquations::displace(std::vector<BodyState>& bodies, const VectorXd& by) const {
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(6 * i - 6);
    bodies[i].origin += by.segment<3>(at) * length_;
    const Vector3d turn = by.segment<3>(at + 3);
    const double angle = turn.norm();
    if (angle > 0) bodies[i].rotation = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * bodies[i].rotation;
  }
}

}  // namespace pmreport::mechanics
