// The parts of plausibility.hpp: a mechanism's data at home, and what each kind of datum may look like.
#pragma once

#include <core/mechanics/conformance/plausibility.hpp>
#include <core/numbers.hpp>

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace pmreport::mechanics {

// Where everything stands at home, with the sizes that others are compared with.
class AtHome {
 public:
  explicit AtHome(const Machine& machine);

  const Topology& topology() const { return topology_; }
  const Body& body(int i) const { return topology_.bodies[static_cast<std::size_t>(i)]; }
  const Joint& joint(int j) const { return topology_.joints[static_cast<std::size_t>(j)]; }
  int bodies() const { return static_cast<int>(topology_.bodies.size()); }
  const std::vector<int>& joints_of(int body) const { return joints_of_[static_cast<std::size_t>(body)]; }

  Eigen::Vector3d centre(int joint) const { return centre_[static_cast<std::size_t>(joint)]; }  // base axes [m]
  Eigen::Vector3d seat(int joint, int body) const;                                 // the same in axes of a body, from its origin
  double actuator(int i) const { return actuator_[static_cast<std::size_t>(i)]; }  // its value [m], [rad]
  Eigen::Vector3d in_socket(int joint, const Eigen::Vector3d& direction) const;    // of a ball's socket's axes: a direction in base axes
  Eigen::Vector3d stud(int joint) const;                                           // of a ball: the stud's z axis, base axes

  double apart(const std::vector<int>& joints) const;  // the largest distance of two of them [m]
  // Joints and solids of a body, in its axes; empty where it has neither.
  Eigen::AlignedBox3d box(int body) const;
  double drawn_volume(int body) const;   // of its solids, as if none overlapped [m^3]
  double drawn_size(int body) const;     // largest dimension of any one solid [m]
  double joints_apart(int limb) const;   // of the joints of a limb's bodies [m]
  double longest_drive(int limb) const;  // end of the stroke of its linear drives; 0: none [m]
  double reach(int limb) const { return std::max(joints_apart(limb), longest_drive(limb)); }
  double span() const { return span_; }  // of all joints [m]

  int limbs() const { return limbs_; }  // numbered 1 to this
  std::vector<int> bodies_of(int limb) const;
  std::vector<int> joints_of_limb(int limb) const;  // that touch one of its bodies, in the order of the topology
  // Limbs of one structure: as many bodies, and joints of the same kinds between the same of them. Of limb 1 and those like it first.
  const std::vector<std::vector<int>>& alike() const { return alike_; }

 private:
  const Topology& topology_;
  std::vector<Eigen::Vector3d> origin_, centre_;
  std::vector<Eigen::Matrix3d> rotation_;
  std::vector<double> actuator_;
  std::vector<std::vector<int>> joints_of_, alike_;
  int limbs_ = 0;
  double span_ = 0;
};

inline constexpr double whole_turn = 2 * pi;

// A remark of one `kind`: several of a kind become one, with the numbers of the worst. Without a kind it stays alone.
struct Oddity {
  std::string kind;
  double worst;  // how odd, in terms of others of its kind
  Remark remark;
};

std::vector<Oddity> odd_masses(const AtHome& home);
std::vector<Oddity> odd_bodies(const AtHome& home);   // centre of mass, inertia, drawn solids
std::vector<Oddity> odd_lengths(const AtHome& home);  // one length against the rest; strokes and limits
std::vector<Oddity> odd_layouts(const AtHome& home);  // one member that breaks a regular pattern

std::string length_words(double metres);  // "760 mm", "12 m"
std::string angle_words(double radians);  // "30 deg"

}  // namespace pmreport::mechanics
