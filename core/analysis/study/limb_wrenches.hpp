// What the limbs exert on the platform, and what a 6 x 6 formula takes them to exert.
//
// The overall Jacobian G of a mechanism tells what massless limbs can exert on the platform: a multiple of each of its rows. Fed with all
// that the platform needs, w = inertia - load - weight, G^T f = w gives one force f_i for each actuator and each constraint wrench, and
// with limbs that have mass their sum is still right. Yet such a limb is no two-force member: its weight and inertia come out at both of
// its ends, in directions that no row of G has. What one limb exerts on the platform is then not its rows times f, and the constraint force
// that the formula gives is not the force of any joint.
#pragma once

#include <core/analysis/study/joint_loads.hpp>

#include <Eigen/Core>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pmreport::analysis {

class LimbWrenches {
 public:
  LimbWrenches(const Analysis& a, const std::vector<int>& checked);  // `checked`: samples whose self-stresses are looked at

  const std::vector<int>& limbs() const { return limbs_; }  // numbers of those that end at the platform
  bool any() const { return !limbs_.empty(); }
  // Component c of a limb's wrench is not determined by rigid bodies.
  bool doubtful(int limb, int c) const { return doubtful_[static_cast<std::size_t>(limb - 1)] >> c & 1; }

  struct LimbPeaks {
    int limb;
    JointLoad::Size force, moment;  // largest over the samples; rms is left out
  };
  const std::vector<LimbPeaks>& peaks() const { return peaks_; }

  // Largest over the samples: wrenches of all limbs, load and weight against the platform's own inertia, relative to the largest of them.
  // NaN: no sample has forces.
  double imbalance() const { return imbalance_; }

  // Where formula and bodies differ most: of limbs that hold a constraint wrench, and all that share an actuator with them.
  struct Difference {
    int sample = -1;  // -1: nowhere
    std::vector<int> limbs;
    double share = 0;  // relative to the largest wrench there
    mechanics::Vector6d by_formula = mechanics::Vector6d::Zero(), by_bodies = mechanics::Vector6d::Zero();
    std::vector<std::pair<int, double>> constraints;  // row of G, value by the formula
  };
  const Difference& difference() const { return differ_; }

 private:
  struct Group {             // limbs that hold a constraint wrench, and all that share an actuator with them
    std::vector<int> limbs;  // numbers
    std::vector<int> rows;   // of G: their actuators and the constraint wrenches that they hold
  };
  void judge();  // the formula and the platform's balance, sample by sample
  std::vector<int> carriers(int actuator) const;
  std::vector<Group> groups(int sample) const;
  mechanics::Vector6d bodies(int limb, int sample) const;  // from the columns

  const Analysis& a_;
  std::vector<int> limbs_;
  std::vector<unsigned> doubtful_;  // of limb n at [n - 1]: bit c, component c of its wrench on the platform is not determined
  std::vector<LimbPeaks> peaks_;
  double imbalance_ = std::numeric_limits<double>::quiet_NaN();
  Difference differ_;
};

}  // namespace pmreport::analysis
