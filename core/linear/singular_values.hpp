// Singular values, m = U S V^T, largest first: how far a matrix is from the nearest one of lower rank (Eckart and Young). Dearer than the
// pivots of subspace.hpp, and exact where a pivot may be small without a singular value that is, or the other way round.
#pragma once

#include <core/linear/tolerance.hpp>
#include <core/linear/types.hpp>

namespace pmreport::linear {

// min(m, n) numbers, by divide and conquer: for large matrices. Absolute errors of rounding times the largest.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& m);

// Those of a wrench or twist Jacobian, by Jacobi's rotations: small ones keep their relative accuracy.
Vector6d singular_values(const Matrix6d& m);

Eigen::Vector3d singular_values(const Eigen::Matrix3d& m);

// With the unit vectors v_k that m shortens, or lengthens, to s_k: columns of V, each up to its sign.
struct RightSingular {
  Vector6d values;
  Matrix6d vectors;
};
RightSingular right_singular(const Matrix6d& m);

// The number of singular values above `rank_tolerance` of the largest: rank as the literature on lines and singularities has it.
int rank_by_singular_values(const Eigen::MatrixXd& m);

// All x with m x = 0, by singular values not above `rank_tolerance` itself: of rows that are unit vectors. n x (n - rank), orthonormal.
Eigen::MatrixXd null_space_by_singular_values(const Eigen::MatrixXd& unit_rows);

// Singular values of m with the directions in its column space that they belong to: columns of U, min(m, n) of them.
struct LeftSingular {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
LeftSingular left_singular(const Eigen::MatrixXd& m);

}  // namespace pmreport::linear
