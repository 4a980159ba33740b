// Elasticity of a mechanism at its poses: the force method on the reactions.
//
// What rigid bodies say of the forces q in all springs (springs.hpp) under loads w is linear,
//     q = Q_0 w + Z y                                                              (1)
// Q_0 from the balance of the bodies, whatever split it takes; Z the springs' forces in the self-stresses, of any share y. Of all splits
// that balance the elastic one has the least complementary energy (Castigliano, Menabrea),
//     q . C q / 2 + q_0 . q -> least:   Z^T C Z y = -Z^T (C Q_0 w + q_0)           (2)
// C the compliances on a diagonal, and the displacement that a wrench meets is the derivative of that energy by the wrench. With Q = Q_0 +
// Z Y settled by (2) for unit wrenches on the platform,
//     compliance   Q^T C Q                                                         (3)
//     displacement Q^T (C q + q_0)   under any loads on any bodies                 (4)
// for Q^T C Z = 0 by (2), so that q in (4) need not be settled. Elements of no compliance are welcome, and no stiffness is ever asked for.
// Self-stresses without energy are left as they are: nothing gives way in them, and rigid bodies do not tell them.
//
// The inertia that goes with these displacements: a body moves by u = U w under unit wrenches, and by (4), Maxwell and Betti, a load f on
// the body gives f . u = q_f . C Q w, q_f any forces that balance f. Kinetic energy in the shapes of the six unit wrenches is then
//     M = sum over the bodies of U^T M_b U                                         (5)
// (Guyan's reduction: bodies follow the platform as they do statically), which makes frequencies too high where limbs swing by themselves.
// Nothing is left out when the masses load each other: with the columns f_k of square roots of all mass matrices as loads on their bodies,
//     A_kl = Q(f_k) . C Q(f_l)                                                     (6)
// is the flexibility between all masses, mass-weighted, and its eigenvalues are 1 / omega^2 of the whole machine.
#pragma once

#include <core/mechanics/reactions/inverse_dynamics.hpp>
#include <core/mechanics/stiffness/springs.hpp>

#include <memory>
#include <vector>

namespace pmreport::mechanics {

// About the platform's reference point, base axes; displacements are (translation of that point [m]; small rotation [rad]).
struct ElasticPose {
  bool known = false;  // else the pose is out of reach, or the actuators do not hold it, and nothing below means anything
  SpringPlan::AtPose parts;
  Eigen::Matrix<double, Eigen::Dynamic, 6> unit;  // Q: forces in the springs by unit forces [N] and moments [N m] on the platform
  Matrix6d compliance = Matrix6d::Zero();         // (3)
  Vector6d deflection = Vector6d::Zero();         // under load, weights and inertia
  Vector6d by_load = Vector6d::Zero(), by_weights = Vector6d::Zero(), by_inertia = Vector6d::Zero();  // its shares
  Vector6d by_strain = Vector6d::Zero();  // of temperature and misfits, no part of it
  Eigen::VectorXd forces;                 // in the springs under load, weights, inertia and strain
  Eigen::VectorXd loaded;                 // the same without strain: what deflects
  Matrix6d inertia = Matrix6d::Zero();    // (5), by wrenches: of all bodies where limb inertia was asked for, else the platform's
  struct Mass {                           // a column of a square root of a mass matrix, as a load
    int body;
    Vector6d wrench;  // about the platform's reference point
  };
  std::vector<Mass> masses;                          // of all bodies, where limb inertia was asked for
  Eigen::MatrixXd flexibility;                       // (6), of these: its lower triangle
  Eigen::Matrix<double, 6, Eigen::Dynamic> by_mass;  // the platform's displacement by each
  Matrix6d platform_inertia = Matrix6d::Zero();      // (5) of the platform alone
  int settled = 0, open = 0;                         // self-stresses that the elements settle, and that they leave open
};

// Forces in the springs of one pose, a column a case, by the joints' wrenches without actuators' forces, number i of case k at
// [i * count + k], and likewise actuators' forces; null: none.
using ForceRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
void spring_forces(const SpringPlan& plan, const SpringPlan::AtPose& parts, const double* placement, std::size_t count,
                   const double* joints, const double* actuators, ForceRows& out);
// Of a self-stress, by its wrenches, with what is but rounding made zero: it has no energy there.
Eigen::VectorXd stress_forces(const SpringPlan& plan, const SpringPlan::AtPose& parts, const double* placement, const double* joints);

class Elastostatics {
 public:
  explicit Elastostatics(const Machine& machine);  // which must outlive it

  struct Wanted {
    bool loads = true;         // deflections and forces; else compliance and inertia alone
    bool limb_inertia = true;  // (5) and (6) of all bodies
  };
  // As InverseDynamics::solve. Keeps buffers: one object a thread.
  void solve(std::size_t count, const double* jets, const double* loads, const Eigen::Vector3d& gravity, const Wanted& wanted,
             std::vector<ElasticPose>& out);
  // One pose at rest: dof coordinates, the load on the platform.
  ElasticPose at(const Eigen::VectorXd& coordinates, const Vector6d& load, const Eigen::Vector3d& gravity, const Wanted& wanted);

  const SpringPlan& plan() const { return plan_; }

 private:
  void solve_one(const double* jets, std::size_t stride, const Vector6d& load, const Eigen::Vector3d& gravity, const Wanted& wanted,
                 ElasticPose& out);
  void load_bodies(const Eigen::Vector3d& gravity, const Wanted& wanted, std::vector<ElasticPose::Mass>& masses);

  const Machine& machine_;
  SpringPlan plan_;
  InverseDynamics dynamics_;
  std::vector<double> placement_, jets_, loads_, wrenches_, stress_;
  ForceRows forces_;
  MotionReactions reactions_;
  std::size_t cases_ = 0;
};

// Shares of the self-stresses: (2) with q for Q_0 w. Stresses without energy get none, and are counted.
struct Settled {
  Eigen::MatrixXd shares;  // a row a stress, a column a column of `forces`
  Eigen::MatrixXd open;    // stresses that nothing settles, as columns of combinations of the given ones; orthonormal
};
Settled settled(const std::vector<Spring>& springs, const Eigen::MatrixXd& stresses, const Eigen::MatrixXd& forces, bool strained);

}  // namespace pmreport::mechanics
