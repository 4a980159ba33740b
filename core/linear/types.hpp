// The small vectors and matrices of mechanics: twists and wrenches, and what has the size of the degrees of freedom. None allocates.
#pragma once

#include <Eigen/Core>

namespace pmreport::linear {

using Vector6d = Eigen::Matrix<double, 6, 1>;  // a twist (velocity; angular velocity), or a wrench (force; moment)
using Matrix6d = Eigen::Matrix<double, 6, 6>;

using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;  // dof long, at most 6
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

}  // namespace pmreport::linear
