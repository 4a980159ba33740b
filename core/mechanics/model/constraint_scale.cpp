#include <core/assertion.hpp>
#include <core/mechanics/model/constraint_scale.hpp>

namespace pmreport::mechanics {

Eigen::MatrixXd per_length(Eigen::MatrixXd rows, double length) {
  PMREPORT_ASSERT(length > 0, "the characteristic length is positive");
  PMREPORT_ASSERT(rows.cols() % 6 == 0, "rows on twists have six columns a body");
  for (Eigen::Index c = 0; c < rows.cols(); c += 6) rows.middleCols(c + 3, 3) /= length;
  return rows;
}

Eigen::MatrixXd unit_rows(Eigen::MatrixXd rows, double length) {
  rows = per_length(std::move(rows), length);
  const Eigen::VectorXd sizes = rows.rowwise().norm();
  for (Eigen::Index r = 0; r < rows.rows(); ++r)
    if (sizes(r) > 0) rows.row(r) /= sizes(r);
  return rows;
}

}  // namespace pmreport::mechanics
