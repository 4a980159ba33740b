// Eigenvalues of symmetric matrices. Of what is given the lower triangle is read.
#pragma once

#include <core/linear/types.hpp>

namespace pmreport::linear {

Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& m);  // smallest first
SmallVector symmetric_eigenvalues(const SmallMatrix& m);          // smallest first

// With orthonormal eigenvectors as columns, smallest value first.
struct SymmetricEigen6 {
  Vector6d values;
  Matrix6d vectors;
};
SymmetricEigen6 symmetric_eigen(const Matrix6d& m);
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& m);

Eigen::VectorXd symmetric_eigenvalues_of(const Eigen::MatrixXd& m);  // smallest first

// All x with a x = s b x, a symmetric and b symmetric and positive definite: columns by rising s, with x^T b x = 1. They are where
// x^T a x / x^T b x is stationary.
Eigen::MatrixXd stationary_vectors(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace pmreport::linear
