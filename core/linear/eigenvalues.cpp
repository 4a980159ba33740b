#include <core/linear/eigenvalues.hpp>

#include <core/assertion.hpp>

#include <Eigen/Eigenvalues>

namespace pmreport::linear {

Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues();
}

SmallVector symmetric_eigenvalues(const SmallMatrix& m) {
  return Eigen::SelfAdjointEigenSolver<SmallMatrix>(m, Eigen::EigenvaluesOnly).eigenvalues();
}

SymmetricEigen6 symmetric_eigen(const Matrix6d& m) {
  const Eigen::SelfAdjointEigenSolver<Matrix6d> parts(m);
  return {parts.eigenvalues(), parts.eigenvectors()};
}

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& m) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(m);
  return {parts.eigenvalues(), parts.eigenvectors()};
}

Eigen::VectorXd symmetric_eigenvalues_of(const Eigen::MatrixXd& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::MatrixXd stationary_vectors(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  PMREPORT_ASSERT(a.rows() == b.rows(), "both forms are of the same vectors");
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(a, b).eigenvectors();
}

}  // namespace pmreport::linear
