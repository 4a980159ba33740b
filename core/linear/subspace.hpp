// Linear subspaces by orthogonal factorisation with pivots, A P = Q R (Businger and Golub 1965): the diagonal of R falls, and those of its
// entries that are not rounding count the rank. An entry counts as zero below `rank_tolerance` of the largest one, or of `size` where that
// is more: what a pivot of such a matrix is when it is not rounding. Parts of orthonormal columns have size 1, and may be zero altogether.
//
// None of these throws; matrices without a row or a column are allowed. Bases have orthonormal columns, and are the same on every run.
#pragma once

#include <core/linear/tolerance.hpp>

#include <Eigen/Core>

namespace pmreport::linear {

// Of m x n numbers: 0 to min(m, n).
int rank(const Eigen::MatrixXd& m, double size = 0);

// All x with m x = 0: n x (n - rank). The identity where m has no row.
Eigen::MatrixXd null_space(const Eigen::MatrixXd& m, double size = 0);

// All m x: m.rows() x rank.
Eigen::MatrixXd column_space(const Eigen::MatrixXd& m, double size = 0);

// Magnitudes of the diagonal of R, min(m, n) of them, largest first: none is more than the next by rounding.
Eigen::VectorXd pivots(const Eigen::MatrixXd& m);

// The directions that no column of m reaches, where m is meant to have this rank: m.rows() x (m.rows() - rank), orthonormal. `pivot`: the
// last of the pivots that count, of which nothing is left where the rank falls; infinite where none counts.
struct Complement {
  Eigen::MatrixXd basis;
  double pivot = 0;
};
Complement complement(const Eigen::MatrixXd& m, Eigen::Index rank);

// Gram and Schmidt's, of independent columns: m x n, n <= m, that span the same, each the first so many of the given ones.
Eigen::MatrixXd orthonormalised(const Eigen::MatrixXd& columns);

}  // namespace pmreport::linear
