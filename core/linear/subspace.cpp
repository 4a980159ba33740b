#include <core/linear/subspace.hpp>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::linear {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

struct Factors {
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  Eigen::Index rank = 0;
};
Factors factorised(const MatrixXd& m, double size) {
  Factors f{Eigen::ColPivHouseholderQR<MatrixXd>(m)};
  const double least = rank_tolerance * std::max(size, f.qr.maxPivot());
  for (Eigen::Index k = 0; k < std::min(m.rows(), m.cols()); ++k) f.rank += std::abs(f.qr.matrixQR()(k, k)) > least ? 1 : 0;
  return f;
}

}  // namespace

int rank(const MatrixXd& m, double size) { return m.size() == 0 ? 0 : static_cast<int>(factorised(m, size).rank); }

// With m^T P = Q R the columns of Q beyond the rank are across every row of m.
MatrixXd null_space(const MatrixXd& m, double size) {
  const Eigen::Index n = m.cols();
  if (m.rows() == 0 || n == 0) return MatrixXd::Identity(n, n);
  const Factors f = factorised(m.transpose(), size);
  return MatrixXd(f.qr.householderQ() * MatrixXd::Identity(n, n)).rightCols(n - f.rank);
}

MatrixXd column_space(const MatrixXd& m, double size) {
  if (m.size() == 0) return MatrixXd(m.rows(), 0);
  const Factors f = factorised(m, size);
  return MatrixXd(f.qr.householderQ() * MatrixXd::Identity(m.rows(), m.rows())).leftCols(f.rank);
}

VectorXd pivots(const MatrixXd& m) {
  if (m.size() == 0) return VectorXd(0);
  return Eigen::ColPivHouseholderQR<MatrixXd>(m).matrixQR().diagonal().cwiseAbs();
}

Complement complement(const MatrixXd& m, Eigen::Index rank) {
  if (m.size() == 0 || rank == 0) return {MatrixXd::Identity(m.rows(), m.rows()), std::numeric_limits<double>::infinity()};
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(m);
  const MatrixXd across = MatrixXd::Identity(m.rows(), m.rows()).rightCols(m.rows() - rank);
  return {qr.householderQ() * across, std::abs(qr.matrixQR()(rank - 1, rank - 1))};
}

MatrixXd orthonormalised(const MatrixXd& columns) {
  return Eigen::HouseholderQR<MatrixXd>(columns).householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
}

}  // namespace pmreport::linear
