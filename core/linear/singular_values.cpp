#include <core/linear/singular_values.hpp>

#include <Eigen/SVD>

namespace pmreport::linear {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd singular_values(const MatrixXd& m) { return Eigen::BDCSVD<MatrixXd>(m).singularValues(); }

Vector6d singular_values(const Matrix6d& m) { return Eigen::JacobiSVD<Matrix6d>(m).singularValues(); }

Eigen::Vector3d singular_values(const Eigen::Matrix3d& m) { return Eigen::JacobiSVD<Eigen::Matrix3d>(m).singularValues(); }

RightSingular right_singular(const Matrix6d& m) {
  const Eigen::JacobiSVD<Matrix6d> svd(m, Eigen::ComputeFullV);
  return {svd.singularValues(), svd.matrixV()};
}

int rank_by_singular_values(const MatrixXd& m) {
  Eigen::JacobiSVD<MatrixXd> svd(m);
  svd.setThreshold(rank_tolerance);
  return static_cast<int>(svd.rank());
}

MatrixXd null_space_by_singular_values(const MatrixXd& unit_rows) {
  const Eigen::JacobiSVD<MatrixXd> svd(unit_rows, Eigen::ComputeFullV);
  const Eigen::Index rank = (svd.singularValues().array() > rank_tolerance).count();
  return svd.matrixV().rightCols(unit_rows.cols() - rank);
}

LeftSingular left_singular(const MatrixXd& m) {
  const Eigen::JacobiSVD<MatrixXd> svd(m, Eigen::ComputeThinU);
  return {svd.singularValues(), svd.matrixU()};
}

}  // namespace pmreport::linear
