// Square systems of at most six equations, by Gauss's elimination with row pivots, P A = L U. None allocates. A singular matrix is not
// refused: what comes out is infinite, or NaN, or large, and those who may meet one look.
#pragma once

#include <core/linear/types.hpp>

#include <Eigen/LU>
#include <optional>

namespace pmreport::linear {

double determinant(const Matrix6d& a);

// The sign of det a, by what is known of its entries: each to `entry_rounding` of the length of its row. With unit rows E has entries of
// that size at most, and
//     det(a + E) = det a det(I + a^-1 E)
// keeps its sign while the entries of a^-1 sum to less than 1 / entry_rounding. 1, -1, or 0 where rounding could turn it over, where a row
// has no length, and where an entry is not finite. Lengths of rows play no part.
int sign_of_determinant(const Matrix6d& a);

Vector6d solution(const Matrix6d& a, const Vector6d& b);               // x of a x = b
Vector6d solution_of_transpose(const Matrix6d& a, const Vector6d& b);  // x of a^T x = b

SmallMatrix inverse(const SmallMatrix& a);

// A matrix factorised once, for several right sides. `order`: in which its numbers follow one another; that of the transpose of a
// SmallMatrix is by rows, and not moving them saves a copy. The order decides how sums round.
template <int order>
class Factorised {
 public:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, order, 6, 6>;
  explicit Factorised(const Matrix& a);
  SmallVector solve(const SmallVector& b) const;
  double determinant() const;

 private:
  Eigen::PartialPivLU<Matrix> lu_;
};
extern template class Factorised<Eigen::ColMajor>;
extern template class Factorised<Eigen::RowMajor>;
using SmallFactors = Factorised<Eigen::ColMajor>;
using SmallFactorsOfTranspose = Factorised<Eigen::RowMajor>;  // give it a.transpose()

// x of a x = b, a symmetric and positive definite, its diagonal 1, by L D L^T with pivots (after Cholesky). Nothing where a pivot is not
// above `least_pivot`: a is singular, or not positive definite.
std::optional<SmallVector> solution_of_positive_definite(const SmallMatrix& a, const SmallVector& b, double least_pivot);

}  // namespace pmreport::linear
