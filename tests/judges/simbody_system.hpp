// Bodies, joints, gravity and load of a mechanism, made in Simbody from its declaration and its home placement.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <tests/judges/simbody_headers.hpp>
#include <tests/judges/simbody_tree.hpp>

#include <vector>

namespace pmreport::judges {

inline SimTK::Vec3 vec(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
SimTK::Rotation rotation(const Eigen::Matrix3d& r);

class SimbodySystem {
 public:
  // Everything but what drives it; the caller adds that before it realizes the topology. `machine` must outlive this.
  explicit SimbodySystem(const mechanics::Machine& machine);

  const Topology& topology() const { return t_; }
  const SpanningTree& tree() const { return tree_; }
  int child(int joint) const;  // the body that a joint of the tree carries
  const SimTK::MobilizedBody& body(int i) const { return mobods_[static_cast<std::size_t>(i)]; }
  SimTK::MobilizedBody& body(int i) { return mobods_[static_cast<std::size_t>(i)]; }
  const std::vector<SimTK::Constraint>& constraints(int joint) const { return constraints_[static_cast<std::size_t>(joint)]; }

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::Force::Gravity gravity{forces, matter, SimTK::UnitVec3(-SimTK::ZAxis), 0};
  SimTK::Force::DiscreteForces load{forces, matter};

 private:
  SimTK::Body::Rigid rigid(int joint) const;
  void add_mobilizer(int joint);
  void add_constraints(int joint);

  Eigen::Vector3d axis_at_home(int joint, int k = 0) const;
  SimTK::Vec3 centre_at_home(int joint) const;
  SimTK::UnitVec3 direction(int body, const Eigen::Vector3d& in_base) const;  // in the axes of the body
  const SimTK::Transform& home(int body) const { return home_[static_cast<std::size_t>(body)]; }

  const mechanics::Machine& machine_;
  const Topology& t_;
  SpanningTree tree_;
  std::vector<SimTK::MobilizedBody> mobods_;  // by body
  std::vector<SimTK::Transform> home_;        // by body
  std::vector<std::vector<SimTK::Constraint>> constraints_;
};

}  // namespace pmreport::judges
