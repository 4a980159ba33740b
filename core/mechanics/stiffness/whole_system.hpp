// Elasticity by one system over all bodies: the judge of elastostatics.hpp, and what moves besides the platform.
//
// With x all multipliers of constraints and actuators, S = (PHI^T, B^T), W the loads on the bodies 1..n about their origins, H the
// compliances of the springs as a form of x, and e what they would shorten by themselves, the least of x . H x / 2 + e . x among all x
// that balance the loads is where
//     | H  S^T | | x |   | -e |
//     | S   0  | | u | = | -W |                              (1)
// and the multipliers u of the balance are the small displacements of the bodies (translation of the origin; rotation): its first rows say
// that what gives way in the joints is what the bodies leave between them. Nothing is cut at the platform, no self-stress is looked for.
#pragma once

#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/stiffness/springs.hpp>

namespace pmreport::mechanics {

class WholeSystem {
 public:
  // Of an assembled pose: `state.status` is PM_OK.
  WholeSystem(const SpringPlan& plan, const State& state);

  // Displacements of the bodies 1..n, 6 n numbers, under wrenches on them, a column each; `strained`: under what springs shorten too.
  // The freedoms of idle spins, and what nothing settles, are as small as can be.
  Eigen::MatrixXd displacements(const Eigen::MatrixXd& wrenches, bool strained = false) const;
  // Under unit wrenches on the platform about its reference point: columns, 6 n x 6; the platform's own rows are the compliance.
  Eigen::MatrixXd under_unit_wrenches() const;

 private:
  Eigen::MatrixXd system_;  // of (1), scaled
  Eigen::VectorXd strain_;
  double softness_ = 1;  // by which u is divided
  Eigen::Index multipliers_ = 0;
  int platform_ = 0;
};

}  // namespace pmreport::mechanics
