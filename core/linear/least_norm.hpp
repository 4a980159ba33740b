// Linear systems of any shape and rank, by complete orthogonal decomposition: of all x that leave the least |a x - b| the one of least |x|.
#pragma once

#include <core/linear/tolerance.hpp>

#include <Eigen/Core>
#include <Eigen/QR>

namespace pmreport::linear {

// a: m x n, b: m long; the answer n long. Pivots below rounding (eps times min(m, n), of the largest) count as zero: for systems known to
// be of the rank that their structure says.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

// The same with pivots below `tolerance` of the largest as zero: for systems that may be singular.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, double tolerance);

// A matrix factorised once, for several right sides.
class LeastNorm {
 public:
  LeastNorm(const Eigen::MatrixXd& a, double tolerance);
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;  // a column each

 private:
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver_;
};

}  // namespace pmreport::linear
