// MuJoCo as a judge of a machine's inverse dynamics.
//
// MuJoCo is handed positions, velocities and accelerations of the joints of a tree (mujoco_tree.hpp) and asked what they mean for the
// bodies, and which generalised forces they need. Its own inverse dynamics stops there: it does not solve for loops whose accelerations
// are given, but for soft ones. So the loops are solved here, exactly, with its Jacobian J of the pins:
//     forces that the tree needs - those of the load = S^T tau + J^T lambda,
// S picking the driven freedoms. Nothing of core/mechanics but the motion of the bodies enters.
#pragma once

#include <core/mechanics/dynamics/momentum.hpp>
#include <tests/judges/mujoco_tree.hpp>

#include <mujoco/mujoco.h>

#include <memory>

namespace pmreport::judges {

// Of the tree's joints, as MuJoCo counts them.
struct JointMotion {
  Eigen::VectorXd position, velocity, acceleration;
};

class MujocoModel {
 public:
  // Throws std::invalid_argument as tree_of does, std::runtime_error with MuJoCo's words.
  explicit MujocoModel(const mechanics::Machine& machine);

  // The motion of the joints that the relative motion of their bodies is.
  JointMotion joint_motion(const mechanics::State& state) const;

  // Generalised forces that the tree alone needs for this motion, less those of the load. Until the next call the functions below speak of
  // this motion. Returns a view that the next call overwrites.
  Eigen::Map<const Eigen::VectorXd> needed(const JointMotion& motion, const mechanics::Loading& loading);

  // J: three rows a pin, the velocity of the point of body b less that of body a.
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<const RowMajor> pin_jacobian() const { return {data_->efc_J, data_->nefc, model_->nv}; }
  Eigen::VectorXd pin_gaps() const { return Eigen::Map<const Eigen::VectorXd>(data_->efc_pos, data_->nefc); }  // [m]
  const std::vector<int>& driven() const { return driven_; }                                                   // freedom of each actuator
  int freedoms() const { return model_->nv; }

  // Where MuJoCo finds a body of the machine, and how it moves. Of a motion given to `needed`.
  mechanics::BodyState body(int body) const;

  struct Solution {
    Eigen::VectorXd actuators;  // tau, push positive [N] or [N m]
    std::vector<mechanics::Vector6d>
        joints;           // what body a of each joint exerts on body b: (force; moment about the centre), without drives
    double residual = 0;  // what no tau and lambda can give, relative to the largest force that the tree needs
  };
  Solution solve(const mechanics::State& state, const mechanics::Loading& loading);

 private:
  int id(int body) const { return ids_[static_cast<std::size_t>(body)]; }
  void push(int body, const Eigen::Vector3d& point, const Eigen::Vector3d& force, const Eigen::Vector3d& moment);
  mechanics::Vector6d carried(int body, const Eigen::Vector3d& point) const;

  const mechanics::Machine& machine_;
  Tree tree_;
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model_;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data_;
  std::vector<int> ids_;     // of the machine's bodies in MuJoCo
  std::vector<int> joints_;  // MuJoCo's first joint of each branch
  std::vector<int> driven_;
  Eigen::VectorXd needed_;
};

}  // namespace pmreport::judges
