#include <core/mechanics/stiffness/elastostatics.hpp>

#include <core/linear/eigenvalues.hpp>
#include <core/linear/tolerance.hpp>
#include <core/mechanics/dynamics/momentum.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pmreport::mechanics {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Of the largest energy of a self-stress: what rounding leaves of one that has none.
constexpr double no_energy = 1e-13;
// Of what a spring could carry of a self-stress: what it carries by rounding.
constexpr double cancelled = 1e-11;

constexpr std::size_t unit_cases = 6;  // then weights, then the whole

// Adds what passes through joint j, as seen by g on (force; moment about its centre), to a row of forces.
struct Passing {
  const SpringPlan& plan;
  const double* placement;
  const double* joints;
  const double* actuators;
  std::size_t count;

  template <class Row>
  void add(int joint, int actuator, const Vector6d& g, Row&& row) const {
    const auto n = static_cast<Index>(count);
    const double* w = joints + 6 * static_cast<std::size_t>(joint) * count;
    for (int c = 0; c < 6; ++c)
      if (g(c) != 0) row += g(c) * Eigen::Map<const Eigen::RowVectorXd>(w + static_cast<std::size_t>(c) * count, n);
    if (actuator < 0 || actuators == nullptr) return;
    const Machine& m = plan.machine();
    const Vector3d axis(placement + m.layout().joint(joint) + 3);
    const bool linear = m.topology().actuators[static_cast<std::size_t>(actuator)].sense() == Sense::linear;
    const double along = linear ? g.head<3>().dot(axis) : g.tail<3>().dot(axis);
    row += along * Eigen::Map<const Eigen::RowVectorXd>(actuators + static_cast<std::size_t>(actuator) * count, n);
  }

  // What the joints of a body exert on it in sum, about a point: what the base passes on to what it stands on, or the platform to its tool.
  template <class Row>
  void add_body(int body, const Vector3d& point, const Vector6d& g, Row&& row) const {
    const Topology& t = plan.machine().topology();
    for (std::size_t j = 0; j < t.joints.size(); ++j) {
      if (t.joints[j].a != body && t.joints[j].b != body) continue;
      const int joint = static_cast<int>(j);
      const Vector3d centre(placement + plan.machine().layout().joint(joint));
      Vector6d here = g;  // g . (F; M + (centre - point) x F)
      here.head<3>() += g.tail<3>().cross(centre - point);
      add(joint, plan.actuator_of(joint), t.joints[j].b == body ? here : Vector6d(-here), row);
    }
  }
};

}  // namespace

void spring_forces(const SpringPlan& plan, const SpringPlan::AtPose& parts, const double* placement, std::size_t count,
                   const double* joints, const double* actuators, ForceRows& out) {
  const Passing passing{plan, placement, joints, actuators, count};
  const Machine& m = plan.machine();
  const auto n = static_cast<Index>(count);
  out.setZero(static_cast<Index>(parts.springs.size()), n);
  for (std::size_t i = 0; i < parts.springs.size(); ++i) {
    const Spring& s = parts.springs[i];
    auto row = out.row(static_cast<Index>(i));
    switch (s.of) {
      case Spring::Of::actuator:
        if (actuators != nullptr) row = Eigen::Map<const Eigen::RowVectorXd>(actuators + static_cast<std::size_t>(s.actuator) * count, n);
        break;
      case Spring::Of::platform:
        passing.add_body(m.topology().platform, Vector3d(placement + m.layout().body(m.topology().platform)), s.g, row);
        break;
      case Spring::Of::base:
        passing.add_body(0, Vector3d::Zero(), s.g, row);
        break;
      case Spring::Of::joints:
        for (int k = s.first; k < s.first + s.terms; ++k) {
          const SpringTerm& term = parts.terms[static_cast<std::size_t>(k)];
          passing.add(term.joint, term.actuator, term.g, row);
        }
    }
  }
}

VectorXd stress_forces(const SpringPlan& plan, const SpringPlan::AtPose& parts, const double* placement, const double* joints) {
  ForceRows forces;
  spring_forces(plan, parts, placement, 1, joints, nullptr, forces);
  // What a spring that sees the largest wrench of the stress would carry of it: rounding is measured by that.
  const double length = plan.length();
  double largest = 0;
  for (std::size_t j = 0; j < plan.machine().topology().joints.size(); ++j) {
    const Eigen::Map<const Vector6d> w(joints + 6 * j);
    largest = std::max({largest, w.head<3>().norm(), w.tail<3>().norm() / length});
  }
  for (std::size_t i = 0; i < parts.springs.size(); ++i) {
    const Spring& s = parts.springs[i];
    double size = 0;
    for (int k = s.first; k < s.first + s.terms; ++k) {
      const Vector6d& g = parts.terms[static_cast<std::size_t>(k)].g;
      size += g.head<3>().norm() + length * g.tail<3>().norm();
    }
    double& q = forces(static_cast<Index>(i), 0);
    // A self-stress is no load on base or platform, and passes no drive.
    if (s.of != Spring::Of::joints || std::abs(q) <= cancelled * largest * size) q = 0;
  }
  return forces;
}

Settled settled(const std::vector<Spring>& springs, const MatrixXd& stresses, const MatrixXd& forces, bool strained) {
  const Index n = stresses.cols();
  Settled out{MatrixXd::Zero(n, forces.cols()), MatrixXd(n, 0)};
  if (n == 0) return out;
  VectorXd c(stresses.rows()), strain(stresses.rows());
  for (Index i = 0; i < c.size(); ++i) {
    c(i) = springs[static_cast<std::size_t>(i)].compliance;
    strain(i) = springs[static_cast<std::size_t>(i)].shortens;
  }
  const MatrixXd weighted = c.asDiagonal() * stresses;
  const linear::SymmetricEigen energy = linear::symmetric_eigen(MatrixXd(stresses.transpose() * weighted));
  MatrixXd right = weighted.transpose() * forces;
  if (strained) right.colwise() += stresses.transpose() * strain;
  const double least = no_energy * energy.values(n - 1);
  Index open = 0;
  for (Index i = 0; i < n; ++i) {
    if (!(energy.values(i) > least && energy.values(i) > 0)) {
      ++open;
      continue;
    }
    const auto v = energy.vectors.col(i);
    out.shares -= v * (v.transpose() * right / energy.values(i));
  }
  out.open = energy.vectors.leftCols(open);
  return out;
}

Elastostatics::Elastostatics(const Machine& machine) : machine_(machine), plan_(machine), dynamics_(machine) {
  placement_.resize(machine.layout().size());
}

// Cases of one pose, side by side: unit wrenches on the platform; the weights at rest; the whole motion; then unit motions of all
// masses, whose forces are the columns of a square root of each mass matrix.
void Elastostatics::load_bodies(const Vector3d& gravity, const Wanted& wanted, std::vector<ElasticPose::Mass>& masses) {
  const Topology& t = machine_.topology();
  const double* at = placement_.data();
  const Layout& layout = machine_.layout();
  const Vector3d origin(at + layout.body(t.platform));
  masses.clear();
  std::vector<Vector6d> weights(t.bodies.size() - 1, Vector6d::Zero());
  for (std::size_t b = 1; b < t.bodies.size(); ++b) {
    const Inertia& inertia = t.bodies[b].inertia;
    const double* body = at + layout.body(static_cast<int>(b));
    Matrix3d r;
    if (t.bodies[b].slender) {
      const Vector3d n(body + 3), x = n.unitOrthogonal();
      r << x, n.cross(x), n;
    } else {
      r = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(body + 3);
    }
    const Vector3d p_OC = Vector3d(body) + r * inertia.centre - origin;
    const auto wrench = [&](const Vector3d& force) { return (Vector6d() << force, p_OC.cross(force)).finished(); };
    weights[b - 1] = wrench(inertia.mass * gravity);
    if (!wanted.limb_inertia) continue;
    const int which = static_cast<int>(b);
    if (inertia.mass > 0)
      for (int k = 0; k < 3; ++k) masses.push_back({which, wrench(std::sqrt(inertia.mass) * Vector3d::Unit(k))});
    const Eigen::Matrix3d& about = inertia.about_centre;
    if (about.isZero(0)) continue;
    if (about.isDiagonal(1e-15)) {  // of a slender body the spin is nobody's
      for (int k = 0; k < (t.bodies[b].slender ? 2 : 3); ++k)
        if (about(k, k) > 0) masses.push_back({which, (Vector6d() << Vector3d::Zero(), std::sqrt(about(k, k)) * r.col(k)).finished()});
    } else {
      MatrixXd dense = about;
      const linear::SymmetricEigen parts = linear::symmetric_eigen(dense);
      for (int k = 0; k < 3; ++k)
        if (parts.values(k) > 0)
          masses.push_back({which, (Vector6d() << Vector3d::Zero(), std::sqrt(parts.values(k)) * (r * parts.vectors.col(k))).finished()});
    }
  }
  const std::size_t first = wanted.loads ? unit_cases + 2 : unit_cases, bodies = t.bodies.size() - 1;
  cases_ = first + masses.size();
  wrenches_.assign(6 * bodies * cases_, 0.0);
  const auto put = [&](std::size_t body, std::size_t which, const Vector6d& w) {
    for (std::size_t c = 0; c < 6; ++c) wrenches_[(6 * body + c) * cases_ + which] += w(static_cast<Index>(c));
  };
  for (std::size_t c = 0; c < unit_cases; ++c) put(static_cast<std::size_t>(t.platform - 1), c, Vector6d::Unit(static_cast<Index>(c)));
  if (wanted.loads)
    for (std::size_t b = 0; b < bodies; ++b) put(b, unit_cases, weights[b]), put(b, unit_cases + 1, weights[b]);
  for (std::size_t i = 0; i < masses.size(); ++i) put(static_cast<std::size_t>(masses[i].body - 1), first + i, masses[i].wrench);
}

void Elastostatics::solve_one(const double* jets, std::size_t stride, const Vector6d& load, const Vector3d& gravity, const Wanted& wanted,
                              ElasticPose& out) {
  const Topology& t = machine_.topology();
  const auto dof = static_cast<std::size_t>(machine_.dof());
  out.known = false;
  VectorXd q(machine_.dof());
  for (std::size_t i = 0; i < dof; ++i) q(static_cast<Index>(i)) = jets[3 * i * stride];
  if (machine_.place(PM_VALUE, 1, q.data(), placement_.data()) != PM_OK) return;
  load_bodies(gravity, wanted, out.masses);
  const std::size_t whole = unit_cases + 1;
  jets_.assign(3 * dof * cases_, 0.0);
  for (std::size_t i = 0; i < dof; ++i) {
    std::fill_n(jets_.begin() + static_cast<std::ptrdiff_t>(3 * i * cases_), cases_, q(static_cast<Index>(i)));
    if (!wanted.loads) continue;
    for (std::size_t c = 1; c < 3; ++c) jets_[(3 * i + c) * cases_ + whole] = jets[(3 * i + c) * stride];
  }
  loads_.assign(6 * cases_, 0.0);
  if (wanted.loads)
    for (std::size_t c = 0; c < 6; ++c) loads_[c * cases_ + whole] = load(static_cast<Index>(c));
  dynamics_.solve(cases_, jets_.data(), loads_.data(), Vector3d::Zero(), reactions_, true, wrenches_.data());
  if (!(reactions_.regularity[0] >= linear::rank_tolerance)) return;

  plan_.at(placement_.data(), 1, out.parts);
  const std::vector<Spring>& springs = out.parts.springs;
  const auto n = static_cast<Index>(springs.size());
  if (n == 0) {  // nothing gives way
    const auto masses = std::move(out.masses);
    out = ElasticPose{};
    out.masses = masses;
    out.unit.resize(0, 6);
    out.open = reactions_.stress_count;
    out.known = true;
    return;
  }
  spring_forces(plan_, out.parts, placement_.data(), cases_, reactions_.joints.data(), reactions_.actuator_forces.data(), forces_);
  const ForceRows& forces = forces_;
  MatrixXd stresses(n, reactions_.stress_count);
  for (int s = 0; s < reactions_.stress_count; ++s) {  // the same in every case
    const double* of = reactions_.stresses.data() + static_cast<std::size_t>(s) * 6 * t.joints.size() * cases_;
    stress_.resize(6 * t.joints.size());
    for (std::size_t i = 0; i < stress_.size(); ++i) stress_[i] = of[i * cases_];
    stresses.col(s) = stress_forces(plan_, out.parts, placement_.data(), stress_.data());
  }
  if (!forces.allFinite() || !stresses.allFinite()) return;

  VectorXd c(n), strain(n);
  for (Index i = 0; i < n; ++i)
    c(i) = springs[static_cast<std::size_t>(i)].compliance, strain(i) = springs[static_cast<std::size_t>(i)].shortens;
  const Settled units = settled(springs, stresses, forces.leftCols(unit_cases), false);
  out.unit = forces.leftCols(unit_cases) + stresses * units.shares;
  out.open = static_cast<int>(units.open.cols());
  out.settled = reactions_.stress_count - out.open;
  const MatrixXd weighted = c.asDiagonal() * out.unit;
  out.compliance = out.unit.transpose() * weighted;
  out.compliance = (0.5 * (out.compliance + out.compliance.transpose())).eval();
  out.by_strain = out.unit.transpose() * strain;
  if (wanted.loads) {
    const MatrixXd whole_forces = forces.col(static_cast<Index>(whole));
    out.loaded = whole_forces + stresses * settled(springs, stresses, whole_forces, false).shares;
    const bool strained = !strain.isZero(0);
    out.forces = strained ? VectorXd(whole_forces + stresses * settled(springs, stresses, whole_forces, true).shares) : out.loaded;
    out.by_weights = weighted.transpose() * forces.col(unit_cases);
    out.deflection = weighted.transpose() * forces.col(static_cast<Index>(whole));
    out.by_load = out.compliance * load;
    out.by_inertia = out.deflection - out.by_load - out.by_weights;
  }
  BodyState platform;
  const double* body = placement_.data() + machine_.layout().body(t.platform);
  platform.origin = Vector3d(body);
  platform.rotation = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(body + 3);
  const Matrix6d mass = mass_matrix(t.bodies[static_cast<std::size_t>(t.platform)].inertia, platform);
  out.platform_inertia = out.compliance * mass * out.compliance;
  out.inertia = out.platform_inertia;
  if (wanted.limb_inertia) {
    const MatrixXd masses = forces.rightCols(static_cast<Index>(out.masses.size()));
    const MatrixXd loaded = masses + stresses * settled(springs, stresses, masses, false).shares;
    const MatrixXd rooted = c.cwiseSqrt().asDiagonal() * loaded;
    out.flexibility.setZero(rooted.cols(), rooted.cols());
    out.flexibility.selfadjointView<Eigen::Lower>().rankUpdate(rooted.transpose());
    out.by_mass = weighted.transpose() * loaded;
    out.inertia = out.by_mass * out.by_mass.transpose();
  }
  out.known = true;
}

void Elastostatics::solve(std::size_t count, const double* jets, const double* loads, const Vector3d& gravity, const Wanted& wanted,
                          std::vector<ElasticPose>& out) {
  out.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    Vector6d load;
    for (std::size_t c = 0; c < 6; ++c) load(static_cast<Index>(c)) = loads[c * count + k];
    solve_one(jets + k, count, load, gravity, wanted, out[k]);
  }
}

ElasticPose Elastostatics::at(const VectorXd& coordinates, const Vector6d& load, const Vector3d& gravity, const Wanted& wanted) {
  std::vector<double> jets(3 * static_cast<std::size_t>(coordinates.size()), 0.0);
  for (Index i = 0; i < coordinates.size(); ++i) jets[3 * static_cast<std::size_t>(i)] = coordinates(i);
  ElasticPose out;
  solve_one(jets.data(), 1, load, gravity, wanted, out);
  return out;
}

}  // namespace pmreport::mechanics
