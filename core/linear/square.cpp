#include <core/linear/square.hpp>

#include <core/assertion.hpp>
#include <core/linear/tolerance.hpp>

#include <Eigen/Cholesky>

namespace pmreport::linear {

double determinant(const Matrix6d& a) { return a.determinant(); }

int sign_of_determinant(const Matrix6d& a) {
  const Vector6d lengths = a.rowwise().norm();
  if (!(lengths.minCoeff() > 0) || !lengths.allFinite()) return 0;
  const Eigen::PartialPivLU<Matrix6d> lu(lengths.cwiseInverse().asDiagonal() * a);
  const double det = lu.determinant();
  if (!(entry_rounding * lu.inverse().cwiseAbs().sum() < 1)) return 0;
  return det > 0 ? 1 : -1;
}

Vector6d solution(const Matrix6d& a, const Vector6d& b) { return a.partialPivLu().solve(b); }

Vector6d solution_of_transpose(const Matrix6d& a, const Vector6d& b) { return a.transpose().partialPivLu().solve(b); }

SmallMatrix inverse(const SmallMatrix& a) {
  PMREPORT_ASSERT(a.rows() == a.cols(), "only a square matrix has an inverse");
  return a.partialPivLu().inverse();
}

template <int order>
Factorised<order>::Factorised(const Matrix& a) : lu_(a) {}

template <int order>
SmallVector Factorised<order>::solve(const SmallVector& b) const {
  return lu_.solve(b);
}

template <int order>
double Factorised<order>::determinant() const {
  return lu_.determinant();
}

template class Factorised<Eigen::ColMajor>;
template class Factorised<Eigen::RowMajor>;

std::optional<SmallVector> solution_of_positive_definite(const SmallMatrix& a, const SmallVector& b, double least_pivot) {
  const Eigen::LDLT<SmallMatrix> factor(a);
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > least_pivot)) return std::nullopt;
  return SmallVector(factor.solve(b));
}

}  // namespace pmreport::linear
