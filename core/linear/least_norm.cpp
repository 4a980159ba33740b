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

VectorXd least_norm_solution(const MatrixXd& a, const VectorXd& b, double tolerance) {
  PMREPORT_ASSERT(b.size() == a.rows(), "a right side is as long as its matrix is high");
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver;
  solver.setThreshold(tolerance);
  solver.compute(a);
  return solver.solve(b);
}

}  // namespace pmreport::linear
