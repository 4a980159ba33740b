// The measure in which rows on twists are compared: rotations count per characteristic length, so that a number stands for a velocity in
// either half of a twist, and with rows of unit length a rank does not depend on units.
#pragma once

#include <Eigen/Core>

namespace pmreport::mechanics {

// Rows on stacked twists (velocity; angular velocity), 6 columns a body: the columns of angular velocities divided by `length` [m]. They
// act on twists whose angular velocities are multiplied by it; as wrenches, they have moments per length.
Eigen::MatrixXd per_length(Eigen::MatrixXd rows, double length);

// These, each row then divided by its length; a row of zeros, as of an axis that a plugin forgot, stays one.
Eigen::MatrixXd unit_rows(Eigen::MatrixXd rows, double length);

}  // namespace pmreport::mechanics
