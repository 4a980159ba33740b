#include <core/linear/least_norm.hpp>

#include <core/assertion.hpp>

#include <Eigen/QR>

namespace pmreport::linear {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd least_norm_solution(const MatrixXd& a, const VectorXd& b) {
  PMREPORT_ASSERT(b.size() == a.rows(), "a right side is as long as its matrix is high");
  return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(a).solve(b);
}

VectorXd least_norm_solution(const MatrixXd& a, const VectorXd& b, double tolerance) { return LeastNorm(a, tolerance).solve(b); }

LeastNorm::LeastNorm(const MatrixXd& a, double tolerance) {
  solver_.setThreshold(tolerance);
  solver_.compute(a);
}

MatrixXd LeastNorm::solve(const MatrixXd& b) const {
  PMREPORT_ASSERT(b.rows() == solver_.rows(), "a right side is as long as its matrix is high");
  return solver_.solve(b);
}

}  // namespace pmreport::linear
