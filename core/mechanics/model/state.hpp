// A mechanism in motion: where every body is, its twist and its acceleration, from the second-order jets of `place`.
#pragma once

#include <Eigen/Core>
#include <core/mechanics/model/machine.hpp>
#include <string>
#include <vector>

namespace pmreport::mechanics {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

struct BodyState {  // base axes; velocities are those of the body's origin
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // of a slender body: z along its axis, the others anyhow
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), angular_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero(), angular_acceleration = Eigen::Vector3d::Zero();

  Vector6d twist() const { return (Vector6d() << velocity, angular_velocity).finished(); }
  Vector6d twist_rate() const { return (Vector6d() << acceleration, angular_acceleration).finished(); }
};

struct JointState {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis[2] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
};

struct Scalar {  // a quantity with its time derivatives
  double value = 0, rate = 0, acceleration = 0;
};

struct State {
  pm_status status = PM_FAILED;  // PM_OK; PM_UNREACHABLE; PM_FAILED: the plugin gave numbers that are not finite
  std::string why;
  std::vector<Scalar> coordinates, actuators, derived;
  std::vector<BodyState> bodies;  // base first
  std::vector<JointState> joints;
  std::vector<double> coordinate_jets, placement_jets;  // as the contract has them, for further calls
};

// The state at coordinates q with rates and accelerations (each dof long). Reuses the memory of `out`.
void evaluate(const Machine& machine, const double* q, const double* q_rate, const double* q_acceleration, State& out);

}  // namespace pmreport::mechanics
