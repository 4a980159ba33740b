// How far a pose is from a singularity, of which type it is there, and how the platform escapes its actuators.
//
// The types of Gosselin and Angeles (1990), told by the generic model: type 1, inverse: with the platform locked an actuator still moves,
// the platform has lost a freedom; type 2, direct: with the actuators locked the platform still moves; type 3: both. Zlatanov, Bonev and
// Gosselin (2002), constraint singularity: with all actuators free the platform has more freedoms than degrees of freedom.
#pragma once

#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/mobility/wrench_system.hpp>
#include <core/mechanics/model/overall_jacobian.hpp>

#include <optional>
#include <vector>

namespace pmreport::mechanics {

struct Conditioning {
  double determinant = 0;  // of G^
  double smallest = 0;     // singular value of G^
  double largest = 0;
  Vector6d escape = Vector6d::Zero();  // unit right singular vector of the smallest as a twist (v; w) [m/s, rad/s]: what the actuators
                                       // feel least
  double condition() const;
};
Conditioning conditioning(const Machine& machine, const Matrix6d& jacobian, double length);

// Ranks of the rows of G, each of unit force (couples: of unit couple per length), moments per length.
struct LineRanks {
  int lines = 0;              // of the actuators' rows
  int wrenches = 0;           // of all six
  std::vector<double> pitch;  // of each actuator's row [m]; 0: a line, infinite: a couple
};
LineRanks line_ranks(const Machine& machine, const Matrix6d& jacobian, double length);

// What the generic model lets move, by rank at linear::rank_tolerance. With PHI the constraint rows, B those of the actuators, N a basis of
// a null space, subscript P the platform's columns or rows and Q those of the other bodies,
//     platform      rank of N_P,  N of [PHI; B]                (2)
//     free          rank of N_P,  N of PHI                     (3)
//     actuators     rank of B_Q N,  N of PHI_Q                 (4)
struct LockedFreedoms {
  int platform = 0;              // of the platform, all actuators locked: (2)
  int actuators = 0;             // of the actuators, the platform locked: (4)
  int free = 0;                  // of the platform, all actuators free: (3)
  ScrewSystem escapes;           // twists of the platform with all actuators locked, about its reference point
  double inverse_margin = 0;     // smallest singular value, beside those of idle freedoms, of PHI without the platform's columns
  double constraint_margin = 0;  // smallest one of PHI that is not zero at home
};
// `at_home`: mobility there; `state.status` is PM_OK; `length`, here and below: characteristic_length(machine) [m].
LockedFreedoms locked_freedoms(const Machine& machine, const State& state, const Mobility& at_home, double length);

enum class SingularityType { regular, inverse, direct, both, constraint };
SingularityType type_of(const LockedFreedoms& f, int dof);

// All of it at a pose.
struct Singularity {
  Eigen::VectorXd coordinates;
  State state;
  Matrix6d jacobian = Matrix6d::Zero();
  Conditioning conditioning;
  LineRanks ranks;
  LockedFreedoms freedoms;
  SingularityType type = SingularityType::regular;
};
// Nothing where the pose cannot be assembled.
std::optional<Singularity> singularity_at(const Machine& machine, const Eigen::VectorXd& coordinates, const Mobility& at_home,
                                          double length);

// det G^ at dof coordinates [m], [rad]; NaN where the pose cannot be assembled, or the plugin gives no G.
double dimensionless_determinant(const Machine& machine, const Eigen::VectorXd& coordinates, double length);

// What the wrenches on the platform are at dof coordinates: det G_, whose sign is that of det G and which has no poles, and its sign as far
// as rounding lets it be known. Nothing where the pose cannot be assembled, or the plugin gives no G.
struct WrenchDeterminant {
  double value = 0;  // 1 at most, in magnitude: of six unit wrenches
  int side = 0;
};
std::optional<WrenchDeterminant> wrench_determinant(const Machine& machine, const Eigen::VectorXd& coordinates, double length);

// An architecture that is singular at every pose: rounding could turn det G over at home and at random poses of the coordinates' box, all
// of them. Such a machine holds its platform nowhere.
bool singular_everywhere(const Machine& machine, double length);

// The pose on the singular surface that a pose given by rounded numbers means: the zero of det G along that one coordinate which changes
// det G most, when it is no farther than `reach` (radians, or lengths). Nothing when there is none, or the pose cannot be assembled.
struct OnSurface {
  Eigen::VectorXd coordinates;
  int coordinate = 0;  // that was moved
  double moved = 0;    // [m] or [rad]
};
std::optional<OnSurface> onto_surface(const Machine& machine, const Eigen::VectorXd& coordinates, double length, double reach = 1e-4);

}  // namespace pmreport::mechanics
