#include <tests/judges/mujoco_model.hpp>

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pmreport::judges {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using mechanics::BodyState;
using mechanics::Loading;
using mechanics::Machine;
using mechanics::State;
using mechanics::Vector6d;

namespace {

// [kg], [kg m^2]: MuJoCo divides by what a body without inertia weighs. Far below the last digit that is compared.
constexpr double nothing = 1e-12;

// From memory; the virtual files are a large struct.
mjModel* load(const std::string& model) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), "machine.xml", static_cast<int>(model.size())) != 0)
    throw std::runtime_error("MuJoCo takes no file from memory");
  std::copy(model.begin(), model.end(), static_cast<char*>(files->filedata[mj_findFileVFS(files.get(), "machine.xml")]));
  char words[1000] = "";
  mjModel* out = mj_loadXML("machine.xml", files.get(), words, sizeof words);
  mj_deleteVFS(files.get());
  if (out == nullptr) throw std::runtime_error(fmt::format("MuJoCo: {}", words));
  return out;
}

int id_of(const mjModel* model, int type, const std::string& name) {
  const int id = mj_name2id(model, type, name.c_str());
  if (id < 0) throw std::runtime_error("MuJoCo does not know " + name);
  return id;
}

Vector3d vector(const mjtNum* at) { return {at[0], at[1], at[2]}; }

// The turn about the unit vector `axis` that takes `from` to `to`, as seen along it.
double turn(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  const Vector3d u = from - axis * axis.dot(from), v = to - axis * axis.dot(to);
  return std::atan2(axis.dot(u.cross(v)), u.dot(v));
}

// The motion of child against parent at a branch. Relative rotation since home in the child's axes at home: T = exp(q1 a1) exp(q2 a2).
class Relative {
 public:
  Relative(const Machine& machine, const Branch& branch, const State& state)
      : p_(state.bodies[static_cast<std::size_t>(branch.parent)]), c_(state.bodies[static_cast<std::size_t>(branch.child)]) {
    const mechanics::Pose& home = machine.home_pose();
    const Matrix3d up = machine.rotation(home, branch.parent).transpose();
    at_home_ = up * machine.rotation(home, branch.child);
    home_offset_ = up * (machine.origin(home, branch.child) - machine.origin(home, branch.parent));
    turned_ = at_home_.transpose() * p_.rotation.transpose() * c_.rotation;
    rotation_ = c_.angular_velocity - p_.angular_velocity;
    rotation_rate_ = c_.angular_acceleration - p_.angular_acceleration;
  }

  struct Freedom {
    double position, velocity, acceleration;
  };
  // Travel of the child's origin along an axis fixed in both, seen from the turning parent: its acceleration is that of the origin less
  // those of the parent's turning, of Coriolis, and towards its axis of turning.
  Freedom slide(const Vector3d& axis) const {
    const Vector3d &w = p_.angular_velocity, r = c_.origin - p_.origin, v = c_.velocity - p_.velocity - w.cross(r);
    const Vector3d a = c_.acceleration - p_.acceleration - p_.angular_acceleration.cross(r) - 2 * w.cross(v) - w.cross(w.cross(r));
    const Vector3d in_parent = at_home_ * axis, n = p_.rotation * in_parent;
    return {in_parent.dot(p_.rotation.transpose() * r - home_offset_), n.dot(v), n.dot(a)};
  }
  Freedom hinge(const Vector3d& axis) const {
    const Vector3d n = c_.rotation * axis, across = axis.unitOrthogonal();
    return {turn(axis, across, turned_ * across), n.dot(rotation_), n.dot(rotation_rate_)};
  }
  // The first axis is carried by the parent, n1' = w_p x n1, the second by the child; w_c - w_p = n1 q1' + n2 q2'.
  std::array<Freedom, 2> hinges(const Vector3d& first, const Vector3d& second) const {
    Eigen::Matrix<double, 3, 2> n;
    n << p_.rotation * at_home_ * first, c_.rotation * second;
    const auto share = n.colPivHouseholderQr();
    const Eigen::Vector2d rates = share.solve(rotation_);
    const Eigen::Vector2d accelerations = share.solve(
        Vector3d(rotation_rate_ - p_.angular_velocity.cross(n.col(0)) * rates(0) - c_.angular_velocity.cross(n.col(1)) * rates(1)));
    return {{{turn(first, second, turned_ * second), rates(0), accelerations(0)},
             {turn(second, turned_.transpose() * first, first), rates(1), accelerations(1)}}};
  }
  // MuJoCo counts a ball's rates in the child's axes, in which (w_c - w_p)' = e_c - e_p - w_c x (w_c - w_p).
  Eigen::Quaterniond ball() const { return Eigen::Quaterniond(turned_); }
  Vector3d ball_rates() const { return c_.rotation.transpose() * rotation_; }
  Vector3d ball_accelerations() const { return c_.rotation.transpose() * Vector3d(rotation_rate_ - c_.angular_velocity.cross(rotation_)); }

 private:
  const BodyState &p_, &c_;
  Matrix3d at_home_, turned_;
  Vector3d home_offset_, rotation_, rotation_rate_;
};

}  // namespace

MujocoModel::MujocoModel(const Machine& machine)
    : machine_(machine),
      tree_(tree_of(machine)),
      model_(load(mjcf(machine, tree_)), &mj_deleteModel),
      data_(mj_makeData(model_.get()), &mj_deleteData),
      ids_(machine.topology().bodies.size(), 0),
      needed_(model_->nv) {
  for (std::size_t i = 1; i < ids_.size(); ++i) {
    ids_[i] = id_of(model_.get(), mjOBJ_BODY, fmt::format("b{}", i));
    const Inertia& inertia = machine.topology().bodies[i].inertia;
    model_->body_mass[ids_[i]] = std::max(inertia.mass, nothing);
    const Vector3d moments = principal(inertia).moments.cwiseMax(nothing);
    std::copy_n(moments.data(), 3, model_->body_inertia + 3 * ids_[i]);
  }
  mj_setConst(model_.get(), data_.get());
  for (const Branch& branch : tree_.branches) joints_.push_back(id_of(model_.get(), mjOBJ_JOINT, fmt::format("j{}_0", branch.joint)));
  for (const Actuator& a : machine.topology().actuators) {
    const bool turns =
        machine.topology().joints[static_cast<std::size_t>(a.joint)].kind == JointKind::cylindrical && a.sense() == Sense::rotary;
    driven_.push_back(model_->jnt_dofadr[id_of(model_.get(), mjOBJ_JOINT, fmt::format("j{}_{}", a.joint, turns ? 1 : 0))]);
  }
}

JointMotion MujocoModel::joint_motion(const State& state) const {
  JointMotion out{VectorXd(model_->nq), VectorXd(model_->nv), VectorXd(model_->nv)};
  for (std::size_t k = 0; k < tree_.branches.size(); ++k) {
    const Branch& branch = tree_.branches[k];
    const Relative motion(machine_, branch, state);
    int at_position = model_->jnt_qposadr[joints_[k]], at_rate = model_->jnt_dofadr[joints_[k]];
    const auto put = [&](const Relative::Freedom& f) {
      out.position(at_position++) = f.position;
      out.velocity(at_rate) = f.velocity;
      out.acceleration(at_rate++) = f.acceleration;
    };
    const auto axis = [&](int i) { return branch_axis(machine_, branch, i); };
    switch (machine_.topology().joints[static_cast<std::size_t>(branch.joint)].kind) {
      case JointKind::prismatic:
        put(motion.slide(axis(0)));
        break;
      case JointKind::revolute:
        put(motion.hinge(axis(0)));
        break;
      case JointKind::cylindrical:
        put(motion.slide(axis(0)));
        put(motion.hinge(axis(0)));
        break;
      case JointKind::universal:
        for (const Relative::Freedom& f : motion.hinges(axis(0), axis(1))) put(f);
        break;
      case JointKind::spherical: {
        const Eigen::Quaterniond q = motion.ball();
        out.position.segment<4>(at_position) << q.w(), q.x(), q.y(), q.z();
        out.velocity.segment<3>(at_rate) = motion.ball_rates();
        out.acceleration.segment<3>(at_rate) = motion.ball_accelerations();
      }
    }
  }
  return out;
}

// MuJoCo takes the forces of its soft constraints off what the tree needs; they are put back.
Eigen::Map<const VectorXd> MujocoModel::needed(const JointMotion& motion, const Loading& loading) {
  std::copy_n(motion.position.data(), model_->nq, data_->qpos);
  std::copy_n(motion.velocity.data(), model_->nv, data_->qvel);
  std::copy_n(motion.acceleration.data(), model_->nv, data_->qacc);
  std::copy_n(loading.gravity.data(), 3, model_->opt.gravity);
  mj_inverse(model_.get(), data_.get());
  needed_.setZero();
  if (!loading.platform.isZero(0)) {
    const int platform = id(machine_.topology().platform);
    const Vector6d opposite = -loading.platform;
    mj_applyFT(model_.get(), data_.get(), opposite.data(), opposite.data() + 3, data_->xpos + 3 * platform, platform, needed_.data());
  }
  for (int i = 0; i < model_->nv; ++i) needed_(i) += data_->qfrc_inverse[i] + data_->qfrc_constraint[i];
  return {needed_.data(), needed_.size()};
}

// MuJoCo gives spatial vectors as (rotation; translation), and accelerations as felt by what gravity pulls.
BodyState MujocoModel::body(int body) const {
  BodyState out;
  const int i = id(body);
  out.origin = vector(data_->xpos + 3 * i);
  out.rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->xmat + 9 * i);
  double both[6];
  mj_objectVelocity(model_.get(), data_.get(), mjOBJ_XBODY, i, both, 0);
  out.angular_velocity = vector(both), out.velocity = vector(both + 3);
  mj_rnePostConstraint(model_.get(), data_.get());
  mj_objectAcceleration(model_.get(), data_.get(), mjOBJ_XBODY, i, both, 0);
  out.angular_acceleration = vector(both), out.acceleration = vector(both + 3) + vector(model_->opt.gravity);
  return out;
}

// MuJoCo wants what acts on a body from outside at its centre of mass.
void MujocoModel::push(int body, const Vector3d& point, const Vector3d& force, const Vector3d& moment) {
  if (body == 0) return;
  const int i = id(body);
  const Vector3d about_centre = moment + (point - vector(data_->xipos + 3 * i)).cross(force);
  for (int k = 0; k < 3; ++k) {
    data_->xfrc_applied[6 * i + k] += force(k);
    data_->xfrc_applied[6 * i + 3 + k] += about_centre(k);
  }
}

// The wrench with which the parent carries `body`, drives included, about `point`; MuJoCo has it about the centre of mass of the whole
// branch of the tree that stands on the base.
Vector6d MujocoModel::carried(int body, const Vector3d& point) const {
  const int i = id(body);
  const Vector3d moment = vector(data_->cfrc_int + 6 * i), force = vector(data_->cfrc_int + 6 * i + 3);
  const Vector3d about = vector(data_->subtree_com + 3 * model_->body_rootid[i]);
  return (Vector6d() << force, moment + (about - point).cross(force)).finished();
}

// Once lambda is known, MuJoCo's recursion gives the wrench in every joint of the tree: loads and forces of the pins count as applied.
MujocoModel::Solution MujocoModel::solve(const State& state, const Loading& loading) {
  const Topology& t = machine_.topology();
  const VectorXd forces = needed(joint_motion(state), loading);
  const Eigen::Index m = static_cast<Eigen::Index>(driven_.size()), rows = data_->nefc;
  MatrixXd system = MatrixXd::Zero(model_->nv, m + rows);
  for (Eigen::Index i = 0; i < m; ++i) system(driven_[static_cast<std::size_t>(i)], i) = 1;
  system.rightCols(rows) = pin_jacobian().transpose();
  const VectorXd x = system.completeOrthogonalDecomposition().solve(forces);

  Solution out{x.head(m), std::vector<Vector6d>(t.joints.size(), Vector6d::Zero()),
               (system * x - forces).lpNorm<Eigen::Infinity>() / forces.lpNorm<Eigen::Infinity>()};
  std::fill_n(data_->xfrc_applied, 6 * model_->nbody, 0.0);
  std::fill_n(data_->efc_force, rows, 0.0);
  push(t.platform, state.bodies[static_cast<std::size_t>(t.platform)].origin, loading.platform.head<3>(), loading.platform.tail<3>());
  for (std::size_t k = 0; k < tree_.pins.size(); ++k) {
    const auto j = static_cast<std::size_t>(tree_.pins[k].joint);
    const BodyState& b = state.bodies[static_cast<std::size_t>(t.joints[j].b)];
    const Vector3d at = b.origin + b.rotation * tree_.pins[k].on_b, force = x.segment<3>(m + 3 * static_cast<Eigen::Index>(k));
    push(t.joints[j].b, at, force, Vector3d::Zero());
    push(t.joints[j].a, at, -force, Vector3d::Zero());
    out.joints[j] += (Vector6d() << force, (at - state.joints[j].centre).cross(force)).finished();
  }
  mj_rnePostConstraint(model_.get(), data_.get());
  for (const Branch& branch : tree_.branches) {
    const auto j = static_cast<std::size_t>(branch.joint);
    const double sign = branch.parent == t.joints[j].a ? 1 : -1;
    out.joints[j] = sign * carried(branch.child, state.joints[j].centre);
  }
  for (std::size_t i = 0; i < t.actuators.size(); ++i) {
    const auto j = static_cast<std::size_t>(t.actuators[i].joint);
    const Vector3d drive = out.actuators(static_cast<Eigen::Index>(i)) * state.joints[j].axis[0];
    if (t.actuators[i].sense() == Sense::linear)
      out.joints[j].head<3>() -= drive;
    else
      out.joints[j].tail<3>() -= drive;
  }
  std::fill_n(data_->xfrc_applied, 6 * model_->nbody, 0.0);
  return out;
}

}  // namespace pmreport::judges
