#include <tests/judges/simbody_model.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <tests/judges/simbody_system.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>

namespace pmreport::judges {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanics::Machine;
using mechanics::State;
using mechanics::Vector6d;
using SimTK::MobilizedBody;
using SimTK::SpatialVec;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

Vector3d eigen(const Vec3& v) { return {v[0], v[1], v[2]}; }

// The accelerations of the actuators for Simbody to ask.
class Prescribed : public SimTK::Motion::Custom::Implementation {
 public:
  explicit Prescribed(const double& acceleration) : acceleration_(acceleration) {}
  Implementation* clone() const override { return new Prescribed(*this); }
  SimTK::Motion::Level getLevel(const SimTK::State&) const override { return SimTK::Motion::Acceleration; }
  void calcPrescribedAcceleration(const SimTK::State&, int, SimTK::Real* udot) const override { *udot = acceleration_; }

 private:
  const double& acceleration_;
};

}  // namespace

class SimbodyModel::Parts {
 public:
  explicit Parts(const Machine& machine) : machine_(machine), simbody_(machine), accelerations_(t_.actuators.size()) {
    for (std::size_t i = 0; i < t_.actuators.size(); ++i) {
      const Joint& joint = t_.joints[static_cast<std::size_t>(t_.actuators[i].joint)];
      if (freedoms_of(joint.kind) != 1) throw std::invalid_argument("the actuated joint " + joint.name + " has more than one freedom");
      SimTK::Motion::Custom(simbody_.body(simbody_.child(t_.actuators[i].joint)), new Prescribed(accelerations_[i]));
    }
    state_ = simbody_.system.realizeTopology();
    simbody_.system.realizeModel(state_);
  }

  void set_gravity(const Vector3d& gravity) { simbody_.gravity.setGravityVector(state_, vec(gravity)); }

  Input input(const State& at, const Vector6d& load) const {
    SimTK::State s = state_;
    for (const int j : simbody_.tree().outward) {
      const int p = parent(j), b = child(j);
      const MobilizedBody& mobod = body(b);
      const auto& in = at.bodies[static_cast<std::size_t>(p)];
      const auto& out = at.bodies[static_cast<std::size_t>(b)];
      const Transform f = placed(at, p) * mobod.getDefaultInboardFrame(), m = placed(at, b) * mobod.getDefaultOutboardFrame();
      mobod.setQToFitTransform(s, ~f * m);
      const Vector3d at_m = eigen(m.p());
      const Vector3d slip =
          out.velocity + out.angular_velocity.cross(at_m - out.origin) - in.velocity - in.angular_velocity.cross(at_m - in.origin);
      mobod.setUToFitVelocity(s, {~f.R() * vec(out.angular_velocity - in.angular_velocity), ~f.R() * vec(slip)});
    }
    Input i;
    const SimTK::Vector &q = s.getQ(), &u = s.getU();
    for (int k = 0; k < q.size(); ++k) i.coordinates.push_back(q[k]);
    for (int k = 0; k < u.size(); ++k) i.speeds.push_back(u[k]);
    for (const auto& actuator : at.actuators) i.accelerations.push_back(actuator.acceleration);
    i.load = load;
    return i;
  }

  void solve(const Input& i) {
    std::ranges::copy(i.accelerations, accelerations_.begin());
    SimTK::Vector &q = state_.updQ(), &u = state_.updU();
    std::ranges::copy(i.coordinates, q.updContiguousScalarData());
    std::ranges::copy(i.speeds, u.updContiguousScalarData());
    simbody_.load.setOneBodyForce(state_, body(t_.platform), {vec(i.load.tail<3>()), vec(i.load.head<3>())});
    simbody_.system.realize(state_, SimTK::Stage::Acceleration);
  }

  Deviation deviation(const State& at) const {
    const double length = characteristic_length(machine_);
    Deviation d{largest(state_.getQErr()), largest(state_.getUErr()), largest(state_.getUDotErr())};
    for (std::size_t b = 1; b < t_.bodies.size(); ++b) {
      const MobilizedBody& mobod = body(static_cast<int>(b));
      const auto& ours = at.bodies[b];
      const Transform& theirs = mobod.getBodyTransform(state_);
      const auto differ = [](double& worst, const Vector3d& ours, const Vec3& theirs) {
        worst = std::max(worst, (ours - eigen(theirs)).lpNorm<Eigen::Infinity>());
      };
      differ(d.position, ours.origin, theirs.p());
      for (int k = t_.bodies[b].slender ? 2 : 0; k < 3; ++k) differ(d.position, ours.rotation.col(k), theirs.R().col(k));
      const SpatialVec &v = mobod.getBodyVelocity(state_), &a = mobod.getBodyAcceleration(state_);
      differ(d.velocity, ours.angular_velocity, v[0]);
      differ(d.velocity, ours.velocity, v[1]);
      differ(d.acceleration, length * ours.angular_acceleration, length * a[0]);
      differ(d.acceleration, ours.acceleration, a[1]);
    }
    return d;
  }

  // Simbody counts the force of a prescribed motion among the inertial ones, on the left of its equations.
  std::vector<double> actuator_forces() const {
    SimTK::Vector forces;
    simbody_.matter.findMotionForces(state_, forces);
    std::vector<double> out;
    for (const Actuator& a : t_.actuators) out.push_back(-forces[body(child(a.joint)).getFirstUIndex(state_)]);
    return out;
  }

  std::vector<Vector6d> joint_reactions(const State& at) const {
    std::vector<Vector6d> out(t_.joints.size());
    SimTK::Vector_<SpatialVec> of_mobilizers;
    simbody_.matter.calcMobilizerReactionForces(state_, of_mobilizers);
    for (std::size_t j = 0; j < t_.joints.size(); ++j) {
      const Joint& joint = t_.joints[j];
      const int number = static_cast<int>(j);
      Vector6d& w = out[j];
      if (parent(number) == SpanningTree::left_out) {
        SpatialVec on_b(Vec3(0), Vec3(0));
        for (const SimTK::Constraint& c : simbody_.constraints(number)) on_b += force_on(c, body(joint.b));
        w = about(eigen(body(joint.b).getBodyOriginLocation(state_)), on_b, at.joints[j].centre);
      } else {
        const MobilizedBody& mobod = body(child(number));
        const Vec3 from = mobod.getBodyTransform(state_) * mobod.getDefaultOutboardFrame().p();
        w = about(eigen(from), of_mobilizers[mobod.getMobilizedBodyIndex()], at.joints[j].centre);
        if (joint.a != parent(number)) w = -w;
      }
    }
    const std::vector<double> drive = actuator_forces();
    for (std::size_t i = 0; i < drive.size(); ++i) {
      const auto j = static_cast<std::size_t>(t_.actuators[i].joint);
      Vector6d& w = out[j];
      if (t_.joints[j].kind == JointKind::prismatic)
        w.head<3>() -= drive[i] * at.joints[j].axis[0];
      else
        w.tail<3>() -= drive[i] * at.joints[j].axis[0];
    }
    return out;
  }

  double mobilizer_reactions() const {
    simbody_.matter.calcMobilizerReactionForces(state_, reactions_);
    return reactions_[1][0][0];
  }

  int constraint_equations() const { return state_.getNMultipliers(); }

  int redundant_constraints() const {
    SimTK::Matrix g;
    simbody_.matter.calcG(state_, g);
    Eigen::MatrixXd equations(g.nrow(), g.ncol());
    for (int i = 0; i < g.nrow(); ++i)
      for (int k = 0; k < g.ncol(); ++k) equations(i, k) = g(i, k);
    Eigen::FullPivLU<Eigen::MatrixXd> lu(equations);
    lu.setThreshold(1e-9);
    return g.nrow() - static_cast<int>(lu.rank());
  }

 private:
  const MobilizedBody& body(int i) const { return simbody_.body(i); }
  int child(int j) const { return simbody_.child(j); }
  int parent(int j) const { return simbody_.tree().parent[static_cast<std::size_t>(j)]; }

  static double largest(const SimTK::Vector& v) { return v.size() > 0 ? v.normInf() : 0; }

  // A slender body is not told its spin: it comes from home by the shortest turn of its axis.
  Transform placed(const State& at, int b) const {
    if (b == 0) return {};
    const auto& s = at.bodies[static_cast<std::size_t>(b)];
    if (!t_.bodies[static_cast<std::size_t>(b)].slender) return {rotation(s.rotation), vec(s.origin)};
    const Matrix3d home = machine_.rotation(machine_.home_pose(), b);
    return {rotation(Eigen::Quaterniond::FromTwoVectors(home.col(2), s.rotation.col(2)) * home), vec(s.origin)};
  }

  // A wrench about `from`, about `to`.
  static Vector6d about(const Vector3d& from, const SpatialVec& w, const Vector3d& to) {
    const Vector3d force = eigen(w[1]);
    return (Vector6d() << force, eigen(w[0]) + (from - to).cross(force)).finished();
  }

  // What a constraint exerts on one of its bodies, about its origin. Simbody gives it with the sign of its left side.
  SpatialVec force_on(const SimTK::Constraint& c, const MobilizedBody& mobod) const {
    const SimTK::Vector_<SpatialVec> forces = c.getConstrainedBodyForcesAsVector(state_);
    for (SimTK::ConstrainedBodyIndex k(0); k < c.getNumConstrainedBodies(); ++k)
      if (c.getMobilizedBodyFromConstrainedBody(k).getMobilizedBodyIndex() == mobod.getMobilizedBodyIndex()) return -forces[k];
    return {Vec3(0), Vec3(0)};
  }

  const Machine& machine_;
  const Topology& t_ = machine_.topology();
  SimbodySystem simbody_;
  std::vector<double> accelerations_;
  SimTK::State state_;
  mutable SimTK::Vector_<SpatialVec> reactions_;
};

SimbodyModel::SimbodyModel(const Machine& machine) : parts_(std::make_unique<Parts>(machine)) {}
SimbodyModel::~SimbodyModel() = default;
SimbodyModel::Input SimbodyModel::input(const State& state, const Vector6d& load) const { return parts_->input(state, load); }
void SimbodyModel::set_gravity(const Vector3d& gravity) { parts_->set_gravity(gravity); }
void SimbodyModel::solve(const Input& input) { parts_->solve(input); }
SimbodyModel::Deviation SimbodyModel::deviation(const State& state) const { return parts_->deviation(state); }
std::vector<double> SimbodyModel::actuator_forces() const { return parts_->actuator_forces(); }
std::vector<Vector6d> SimbodyModel::joint_reactions(const State& state) const { return parts_->joint_reactions(state); }
double SimbodyModel::mobilizer_reactions() const { return parts_->mobilizer_reactions(); }
int SimbodyModel::constraint_equations() const { return parts_->constraint_equations(); }
int SimbodyModel::redundant_constraints() const { return parts_->redundant_constraints(); }

}  // namespace pmreport::judges
