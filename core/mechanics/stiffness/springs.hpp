// Elastic elements as springs: numbers that the forces through the joints give, each with a compliance of its own.
//
// Statically a joint passes one wrench from its body a to its body b: its reaction, and the force of its actuator. What an element carries
// is some component of such a wrench,
//     q = g . W_j                                                                  (1)
// and its complementary energy c q^2 / 2 + q_0 q, q_0 what it would shorten by itself. All components are chosen so that none is coupled
// with another:
//
// A beam of length L runs from its root along n through a chain of bodies, joint j_0 before the first and j_k behind body k. On each body
// act its further joints, and its weight and inertia at its centre of mass, each where it lies along n. What passes a section between two
// of them follows from the joints on either side, bodies and their loads in balance: before the centre of mass of body k from j_(k-1) and
// the further joints passed, behind it from j_k and the further joints still to come. That is a force F, the same over the stretch, and a
// moment
// that changes along it. About the middle of a stretch of length l that moment, M, and F are not coupled (Euler and Bernoulli):
//     c = l / EA for n . F,   l / GJ for n . M,   l^3 / 12 EI for a force across, l / EI for a moment across            (2)
// Bent by couples alone, M about j_m counts and no force across does.
// A rail gives (|l| + offset) / EA for the force along the slide. A drive gives 1 / k for its force. A bearing gives 1 / k along the axis
// of its joint and about it, and for two directions across of each. Base and platform, where they have a compliance, give by its
// eigenvectors: a wrench of unit size each.
//
// Signs: q pushes; a beam under compression has q > 0.
#pragma once

#include <core/mechanics/model/state.hpp>

#include <vector>

namespace pmreport::mechanics {

struct Spring {
  enum class Kind { axial, across, torsion, bending, end_bending, drive, rail, bearing_force, bearing_moment, mount };
  enum class Of { joints, actuator, base, platform };  // what passes the force

  int element = -1;  // of the topology; -1: base or platform
  Kind kind = Kind::axial;
  Of of = Of::joints;
  int first = 0, terms = 0;       // of joints: (1) is a sum over these
  int actuator = -1;              // whose force it is
  Vector6d g = Vector6d::Zero();  // of the base about its origin, of the platform about its reference point
  double compliance = 0;
  double shortens = 0;  // q_0, by temperature and misfit
};
struct SpringTerm {
  int joint = 0;
  int actuator = -1;  // whose force is part of W_j; -1: none
  Vector6d g;         // on (force; moment about the joint's centre), base axes
};

// A stretch of a beam: from `first` on the six springs of (2), axial, across x and y, torsion, bending about x and y, of no compliance
// where the beam does not give that way.
struct BeamStretch {
  int element = 0;
  int first = 0;
  double length = 0;  // [m]
};

class SpringPlan {
 public:
  // By the elements of the topology, under machine.elasticity(). The machine must outlive it.
  explicit SpringPlan(const Machine& machine);

  struct AtPose {
    std::vector<Spring> springs;
    std::vector<SpringTerm> terms;
    std::vector<BeamStretch> stretches;
    std::vector<double> lengths;  // of the beams and rails [m], by element; NaN: of another kind
  };
  // `placement`: the plain numbers of a placement in reach; scalar s at [s * stride]. Reuses the memory of `out`. The order is the same at
  // every pose.
  void at(const double* placement, std::size_t stride, AtPose& out) const;

  const Machine& machine() const { return machine_; }
  double length() const { return length_; }                                                         // characteristic length [m]
  int actuator_of(int joint) const { return actuator_of_joint_[static_cast<std::size_t>(joint)]; }  // -1: none

 private:
  struct Passed {  // W_j of a joint, as what its root's side, or the joint itself, exerts on the beam's bodies
    int joint, actuator;
    double sign;
  };
  struct Beam {
    int element;
    std::vector<int> bodies;
    std::vector<Passed> chain;                 // j_0 to j_m: what the root's side exerts on what follows
    std::vector<std::vector<Passed>> further;  // of each body: what its further joints exert on it
  };
  const Machine& machine_;
  double length_;
  std::vector<Beam> beams_;
  std::vector<int> actuator_of_joint_;
  std::vector<double> misfit_;  // by element
  std::vector<Spring> mounts_;  // of base and platform, those of the platform in its own axes
};

}  // namespace pmreport::mechanics
