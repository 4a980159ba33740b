#include <core/mechanics/model/state.hpp>

#include <Eigen/Geometry>
#include <cmath>

namespace pmreport::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

Vector3d part(const double* jets, int component) { return {jets[component], jets[3 + component], jets[6 + component]}; }

Matrix3d matrix_part(const double* jets, int component) {
  Matrix3d r;
  for (int i = 0; i < 9; ++i) r(i / 3, i % 3) = jets[3 * i + component];
  return r;
}

// Axial vector of the skew part of m r^T, from the entries that it takes.
Vector3d axial(const Matrix3d& m, const Matrix3d& r) {
  const auto entry = [&](int i, int k) { return m.row(i).dot(r.row(k)); };
  return 0.5 * Vector3d(entry(2, 1) - entry(1, 2), entry(0, 2) - entry(2, 0), entry(1, 0) - entry(0, 1));
}

// Rigid body: R' R^T = [w]x, and R'' R^T = [e]x + [w]x [w]x, whose second term is symmetric: the skew part of R'' R^T is [e]x.
void rigid(const double* jets, BodyState& b) {
  b.rotation = matrix_part(jets, 0);
  b.angular_velocity = axial(matrix_part(jets, 1), b.rotation);
  b.angular_acceleration = axial(matrix_part(jets, 2), b.rotation);
}

// Slender body with axis n and no spin: w = n x n', hence e = n x n''.
void slender(const double* jets, BodyState& b) {
  const Vector3d n = part(jets, 0), x = n.unitOrthogonal();
  b.rotation << x, n.cross(x), n;
  b.angular_velocity = n.cross(part(jets, 1));
  b.angular_acceleration = n.cross(part(jets, 2));
}

}  // namespace

void evaluate(const Machine& machine, const double* q, const double* q_rate, const double* q_acceleration, State& out) {
  const Topology& t = machine.topology();
  const Layout& layout = machine.layout();
  const std::size_t dof = static_cast<std::size_t>(machine.dof());
  out.coordinate_jets.resize(3 * dof);
  out.coordinates.resize(dof);
  for (std::size_t i = 0; i < dof; ++i) {
    out.coordinates[i] = {q[i], q_rate[i], q_acceleration[i]};
    out.coordinate_jets[3 * i] = q[i];
    out.coordinate_jets[3 * i + 1] = q_rate[i];
    out.coordinate_jets[3 * i + 2] = q_acceleration[i];
  }
  out.placement_jets.resize(3 * layout.size());
  const double* jets = out.placement_jets.data();
  out.why.clear();
  out.status = machine.place(PM_JET, 1, out.coordinate_jets.data(), out.placement_jets.data());
  if (out.status != PM_OK) {  // only plain numbers come with a sentence
    std::vector<double> numbers(layout.size());
    const pm_status plain = machine.place(PM_VALUE, 1, q, numbers.data(), &out.why);
    if (plain == PM_OK)
      out.why = "the pose exists, but its rates are not finite: it is the end of reach, or the geometry has a corner there";
    return;
  }
  out.bodies.resize(t.bodies.size());
  for (std::size_t i = 1; i < t.bodies.size(); ++i) {
    const double* at = jets + 3 * layout.body(static_cast<int>(i));
    BodyState& b = out.bodies[i];
    b.origin = part(at, 0);
    b.velocity = part(at, 1);
    b.acceleration = part(at, 2);
    t.bodies[i].slender ? slender(at + 9, b) : rigid(at + 9, b);
  }
  out.joints.resize(t.joints.size());
  for (std::size_t i = 0; i < t.joints.size(); ++i) {
    const double* at = jets + 3 * layout.joint(static_cast<int>(i));
    out.joints[i].centre = part(at, 0);
    for (int k = 0; k < axes_of(t.joints[i].kind); ++k) out.joints[i].axis[k] = part(at + 9 * (k + 1), 0);
  }
  const auto scalars = [&](std::vector<Scalar>& list, std::size_t count, std::size_t first) {
    list.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double* at = jets + 3 * (first + i);
      list[i] = {at[0], at[1], at[2]};
    }
  };
  scalars(out.actuators, t.actuators.size(), layout.actuator(0));
  scalars(out.derived, t.derived.size(), layout.derived(0));
}

State state_at_rest(const Machine& machine, const Eigen::VectorXd& coordinates) {
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(machine.dof());
  State s;
  evaluate(machine, coordinates.data(), still.data(), still.data(), s);
  return s;
}

}  // namespace pmreport::mechanics
