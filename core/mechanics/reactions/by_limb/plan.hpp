// How the inverse dynamics of one mechanism is reckoned, settled once: which joints carry the tree of each group of bodies, which are cut,
// which equations and unknowns that leaves. See inverse_dynamics.hpp for the idea, kernel.cpp for what is done with it.
#pragma once

#include <pmreport/topology.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace pmreport::mechanics {

// `at`, here and below: the first of its numbers in a placement.
struct DynamicsPlan {
  struct Mass {
    int body = 0;
    std::size_t at = 0;
    bool slender = false;
    double mass = 0;                                     // [kg]
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();    // of mass, body axes [m]
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();   // second moments about it, sum of b b^T dm = tr(I) / 2 - I, body axes [kg m^2]
    std::array<bool, 3> column = {false, false, false};  // of the rotation, that any of these needs
  };

  // A freedom of a tree joint that transmits nothing: a translation along its axis 1; or a rotation about axis 1, about axis 2 (its share
  // across axis 1), about a base axis, or about the spine of a slender body and two directions across it.
  enum class Freedom { slide, turn, turn_second, turn_x, turn_y, turn_z, turn_spine, turn_across, turn_across_both };

  struct Beyond {
    int cut = 0;
    double sign = 0;  // 1: body b of the cut joint lies beyond, -1: body a does
  };
  struct Tree {  // a joint of a tree: the wrench on its child balances all that lies beyond
    int joint = 0;
    std::size_t at = 0;
    JointKind kind = JointKind::spherical;
    int parent = 0, child = 0;
    double sign = 1;           // 1: the child is body b
    std::size_t spine = 0;     // of a slender body, where a freedom needs it
    int push = -1, turn = -1;  // actuators along axis 1, and about it
    std::vector<Freedom> passive{};
    std::vector<Beyond> beyond{};
  };
  struct Cut {
    int joint = 0;
    std::size_t at = 0;
    JointKind kind = JointKind::spherical;
    int first = 0, forces = 0, couples = 0;  // unknowns: 3 along base axes; 2 across axis 1; 1 couple along axis 1 x axis 2
    double platform = 0;                     // 1: the platform is body b, -1: body a, 0: neither
    int unknowns() const { return forces + couples; }
  };
  struct Group {  // joints of its tree with parents first; its cuts follow one another, and so do its unknowns
    std::vector<Tree> trees;
    int first_cut = 0, end_cut = 0;
    int first = 0, unknowns = 0, equations = 0;
    int first_open = 0;       // of the parameters that its equations leave open
    std::size_t vectors = 0;  // of these parameters, `unknowns` numbers each, among those of all groups
    int open() const { return unknowns - equations; }
  };
  struct Frame {  // axes of a joint, as JointFrames finds them
    std::size_t along = 0;
    std::size_t along_step = 1;  // 3: the column of a rotation
    std::size_t second = 0;      // an axis, or with `carried` the rotation of the body that carries `mark`; 0: the base does
    bool carried = false;
    Eigen::Vector3d mark = Eigen::Vector3d::Zero();
  };

  std::vector<Mass> masses;
  std::vector<Group> groups;
  std::vector<Cut> cuts;
  std::vector<Frame> frames;
  std::size_t size = 0;         // scalars of a placement
  std::size_t platform_at = 0;  // its origin is what moments refer to
  int platform = 0, bodies = 0, joints = 0, actuators = 0;
  int unknowns = 0, open = 0;
  int most_equations = 0, most_unknowns = 0;  // of any group
  std::size_t vector_numbers = 0;             // of all groups
  double length = 1;                          // characteristic length [m]: moments count per length
  int stresses() const { return open - 6; }
};

}  // namespace pmreport::mechanics
