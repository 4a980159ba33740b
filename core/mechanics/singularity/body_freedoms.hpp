// What all bodies can do, not the platform's reference body alone: the constraint system of the generic model, followed limb by limb.
//
// G is 6 x 6: it holds one body. A platform of several bodies, or an overconstrained loop, can come loose inside while det G is regular.
// With unit rows [PHI; B] on the twists of all bodies, B those of the actuators, let a group be the bodies of limbs that are jointed to one
// another, and the core all others. The rows that touch group g read A_g x_g + C_g c on its twists and those of the core, and with E_g a
// basis of what no column of A_g reaches,
//     A_g x_g + C_g c = 0 has a solution x_g    when    E_g^T C_g c = 0                                 (1)
//     null space of [PHI; B]  =  those of all A_g  +  that of R = [E_g^T C_g; rows of the core alone]   (2)
// so that four margins tell every loss of rank apart, each the last pivot of a matrix whose rank is known from regular poses:
//     locked        R with the actuators' rows: bodies move with all actuators locked (type 2, or beyond G)
//     free          R without them: the platform gains a freedom that no actuator has a say in (constraint singularity)
//     limb          A_g without them: with the platform locked bodies of a limb move, its actuator among them (type 1)
//     limb_locked   A_g with them: bodies of a limb move by themselves, platform and actuators locked
#pragma once

#include <core/mechanics/model/generic_model.hpp>

#include <array>
#include <vector>

namespace pmreport::mechanics {

class BodyFreedoms {
 public:
  explicit BodyFreedoms(const Machine& machine);  // which must outlive it

  enum Margin : std::size_t { locked, free, limb, limb_locked, count };
  using Margins = std::array<double, count>;
  // Of an assembled pose; 0 where the rank falls, of the order of a tenth where it is far from that. Idle freedoms do not count.
  Margins at(const State& state) const;
  // The same at coordinates [m], [rad]; NaN where the pose cannot be assembled.
  Margins at(const Eigen::VectorXd& coordinates) const;
  // Those at home.
  const Margins& at_home() const { return at_home_; }

 private:
  struct Ranks {
    std::vector<Eigen::Index> limb, limb_locked;  // one a group
    Eigen::Index free = 0, locked = 0;
  };
  struct Rows {                              // unit rows of [PHI; B], by what they touch
    std::vector<Eigen::MatrixXd> own, core;  // of each group: A_g, C_g
    std::vector<Eigen::Index> passive;       // of each group: how many of its rows are of PHI; those of B follow
    Eigen::MatrixXd alone, drives_alone;     // of the core alone
  };
  Rows rows(const State& state) const;
  Margins margins(const Rows& r) const;
  Eigen::MatrixXd reduced(const Rows& r, bool locked, double& least) const;

  const Machine& machine_;
  double length_;
  std::vector<int> group_;            // of each body; -1: core
  std::vector<Eigen::Index> column_;  // of each body, among those of its group or of the core
  std::vector<Eigen::Index> widths_;  // columns of each group
  Eigen::Index core_width_ = 0;
  Ranks expected_;
  Margins at_home_{};
};

}  // namespace pmreport::mechanics
