#include <core/mechanics/mobility/wrench_system.hpp>

#include <core/linear/eigenvalues.hpp>
#include <core/linear/subspace.hpp>

#include <Eigen/Geometry>

namespace pmreport::mechanics {

using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

// With moments per length, and velocities likewise, products of a wrench and a twist keep their zeros and the rank is one of plain numbers.
MatrixXd scaled_wrenches(const MatrixXd& w, double length) {
  MatrixXd s = w;
  s.bottomRows(3) /= length;
  return s;
}
MatrixXd scaled_twists(const MatrixXd& t, double length) {
  MatrixXd s = t;
  s.bottomRows(3) *= length;
  return s;
}

Eigen::Matrix3d skew(const Vector3d& r) {
  Eigen::Matrix3d m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

// Collects wrenches as long as they are independent. All in scaled numbers, about the system's origin.
class Basis {
 public:
  Basis(const ScrewSystem& wrenches, double length)
      : origin_(wrenches.origin), length_(length), all_(linear::column_space(scaled_wrenches(wrenches.basis, length))) {}

  void add_couples() {
    const MatrixXd moments = (all_ * linear::null_space(all_.topRows(3), 1)).bottomRows(3);
    const MatrixXd axes = aligned(moments);
    for (Eigen::Index k = 0; k < axes.cols(); ++k) add((Vector6d() << Vector3d::Zero(), axes.col(k)).finished(), -1);
  }
  // Forces f with moment r x f about the origin: their moment about the landmark itself is zero.
  MatrixXd forces_through(const Landmark& mark) const {
    const MatrixXd about_mark = all_.bottomRows(3) - skew((mark.at - origin_) / length_) * all_.topRows(3);
    return all_ * linear::null_space(about_mark, 1);
  }
  int gain(const MatrixXd& more) const {
    MatrixXd both(6, chosen_.cols() + more.cols());
    both << chosen_, more;
    return more.cols() == 0 ? 0 : linear::rank(both, 1) - static_cast<int>(chosen_.cols());
  }
  void add_forces(const Landmark& mark) {
    const MatrixXd axes = aligned(forces_through(mark).topRows(3));
    for (Eigen::Index k = 0; k < axes.cols(); ++k) {
      const Vector3d f = axes.col(k);
      add((Vector6d() << f, ((mark.at - origin_) / length_).cross(f)).finished(), mark.joint);
    }
  }
  // Of the wrenches x without a couple, pitch is x'Px / x'Ax with A = F'F and P the symmetric part of F'M: its stationary values.
  void add_principal_screws() {
    const MatrixXd rest = all_ * linear::null_space(chosen_.transpose() * all_, 1);
    if (rest.cols() == 0) return;
    const MatrixXd f = rest.topRows(3), m = rest.bottomRows(3), mixed = f.transpose() * m;
    const MatrixXd x = linear::stationary_vectors(MatrixXd(mixed + mixed.transpose()) / 2, f.transpose() * f);
    for (Eigen::Index k = 0; k < rest.cols(); ++k) add(rest * x.col(k), -1);
  }
  bool complete() const { return chosen_.cols() == all_.cols(); }
  std::vector<NamedWrench> take() { return std::move(named_); }

 private:
  void add(Vector6d w, int joint) {
    if (gain(w) == 0) return;
    w /= w.head<3>().norm() > linear::rank_tolerance * w.norm() ? w.head<3>().norm() : w.norm();
    chosen_.conservativeResize(6, chosen_.cols() + 1);
    chosen_.rightCols(1) = w;
    Vector6d physical = w;
    physical.tail<3>() *= length_;
    named_.push_back({physical, screw_of_wrench(physical, origin_, length_), joint});
  }

  Vector3d origin_;
  double length_;
  MatrixXd all_, chosen_ = MatrixXd(6, 0);
  std::vector<NamedWrench> named_;
};

}  // namespace

ScrewSystem reciprocal(const ScrewSystem& system, double length) {
  MatrixXd w = linear::null_space(scaled_twists(system.basis, length).transpose());
  w.bottomRows(3) *= length;
  return {system.origin, w};
}

std::vector<NamedWrench> readable_basis(const ScrewSystem& wrenches, const std::vector<Landmark>& landmarks, double length) {
  if (wrenches.dimension() == 0) return {};
  Basis basis(wrenches, length);
  basis.add_couples();
  while (!basis.complete()) {
    const Landmark* best = nullptr;
    int most = 0;
    for (const Landmark& mark : landmarks)
      if (const int gain = basis.gain(basis.forces_through(mark)); gain > most) most = gain, best = &mark;
    if (best == nullptr) break;
    basis.add_forces(*best);
  }
  if (!basis.complete()) basis.add_principal_screws();
  return basis.take();
}

double outside(const ScrewSystem& a, const ScrewSystem& b, double length) {
  if (a.dimension() == 0) return 0;
  MatrixXd x = scaled_wrenches(a.basis, length);
  const MatrixXd space = linear::column_space(scaled_wrenches(b.basis, length));
  x.colwise().normalize();
  return (x - space * (space.transpose() * x)).colwise().norm().maxCoeff();
}

}  // namespace pmreport::mechanics
