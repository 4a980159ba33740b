#include <core/linear/scaled_inverse.hpp>

#include <Eigen/LU>

namespace pmreport::linear {

using Eigen::Index;

// (1), column by column: L^-1 P forwards, then U backwards with its last unknown known beforehand, z = y_n and x = (s y - u z).
ScaledInverse scaled_inverse(const SmallMatrix& a) {
  const Index n = a.rows(), last = n - 1;
  const Eigen::FullPivLU<SmallMatrix> lu(a);
  const SmallMatrix& f = lu.matrixLU();
  ScaledInverse out{SmallMatrix::Zero(n, n), f(last, last)};
  if (lu.nonzeroPivots() < last) return out;
  SmallMatrix y = lu.permutationP() * SmallMatrix::Identity(n, n);
  f.triangularView<Eigen::UnitLower>().solveInPlace(y);
  y.topRows(last) = out.scale * y.topRows(last) - f.col(last).head(last) * y.row(last);
  if (last > 0) {
    auto rest = y.topRows(last);
    f.topLeftCorner(last, last).triangularView<Eigen::Upper>().solveInPlace(rest);
  }
  out.columns = lu.permutationQ() * y;
  return out;
}

}  // namespace pmreport::linear
