// What the compliance of a pose tells: stiffness, indices, eigenscrews, natural frequencies, and who makes it give way.
#pragma once

#include <core/mechanics/stiffness/elastostatics.hpp>

#include <array>
#include <optional>
#include <vector>

namespace pmreport::mechanics {

// A compliance, or the inverse of a mass of displacements, about another point and in other axes. With r from the reference point to the
// tool and R the axes, a wrench (F; M) there is (R F; R M + r x R F) at the reference point: w = T w', C' = T^T C T, and d' = T^T d.
Matrix6d to_tool(const Eigen::Vector3d& r, const Eigen::Matrix3d& axes);  // T

// Largest and smallest singular value of the 3 x 3 blocks: translation by force pF [m/N], translation by moment pT [1/N] (rotation by force
// PhiF is its transpose, and has the same), rotation by moment PhiT [rad/(N m)].
struct DeformationIndices {
  double pF_max = 0, pF_min = 0, pT_max = 0, pT_min = 0, PhiT_max = 0, PhiT_min = 0;
};
DeformationIndices deformation_indices(const Matrix6d& compliance);

// The inverse of a compliance of full rank: its least singular value over the largest, moments per `length` [m], above 1e-12. Nothing where
// some wrench moves nothing: there the platform is held rigidly, and no stiffness exists.
std::optional<Matrix6d> stiffness_of(const Matrix6d& compliance, double length);
// Independent directions in which the platform gives way, 0 to 6, by the same measure.
int rank_of(const Matrix6d& compliance, double length);

// K t = lambda D t, D = [0 1; 1 0]: twists whose wrench lies on their own screw, force lambda omega, moment lambda v (Patterson and Lipkin
// 1993). |omega| = 1, its largest component positive; sorted by lambda [N]. With K = L L^T and y = L^T t it is L^T D L y = lambda y,
// symmetric. The compliance's eigenscrews are the same, with 1 / lambda.
struct Eigenscrew {
  double lambda = 0, pitch = 0;        // [N], [m]
  Eigen::Vector3d direction, nearest;  // unit; of its axis, the point nearest to the point that K is about [m]
};
std::array<Eigenscrew, 6> eigenscrews(const Matrix6d& stiffness);

// Free vibration w a cos(omega t) of wrenches w a: from a^T C a, twice the strain energy, and a^T M a, M of (5) in elastostatics.hpp.
// Lowest first; as many as the compliance has directions of which the inertia moves.
struct Mode {
  double frequency = 0;  // [Hz]
  Vector6d shape;        // of the platform, (translation; rotation), of kinetic energy 1/2 at unit rate
};
std::vector<Mode> modes(const Matrix6d& compliance, const Matrix6d& inertia, double length);

// Free vibration of the whole machine, limbs as they swing by themselves included: by (6), lowest first, `most` of them at most. The pose
// was solved with limb inertia. Without `shapes` frequencies alone, for a part of the time.
struct WholeMode : Mode {
  Eigen::VectorXd masses;  // amplitude of every mass column, mass-weighted, of length 1
};
std::vector<WholeMode> whole_modes(const ElasticPose& pose, int most, bool shapes = true);

// Shares of the elements in the displacement along a unit wrench e: e . d = sum of q_e (c q + q_0), by element of the topology; the last is
// that of base and platform. `forces`: of the springs, and `strained` whether q_0 counts.
std::vector<double> shares(const ElasticPose& pose, std::size_t elements, const Vector6d& along, const Eigen::VectorXd& forces,
                           bool strained);

// Largest internal forces of a beam over its stretches: axial force (tension positive, by size), bending moment, torque; and what presses
// it, for by its own weight a beam may be pulled more at one end than it is pressed at the other.
struct BeamForces {
  double axial = 0, bending = 0, torque = 0;  // [N], [N m], [N m]
  double compression = 0;                     // [N], 0 where all of it is pulled
};
std::vector<BeamForces> beam_forces(const ElasticPose& pose, std::size_t elements, const Eigen::VectorXd& forces);
// Euler's load of a beam, pi^2 E I / (k L)^2, of its weaker direction [N]; infinite where it is not slender.
double buckling_load(const Element& beam, double length);

}  // namespace pmreport::mechanics
