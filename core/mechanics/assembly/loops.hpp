// The joints and actuators of a mechanism as equations between its bodies, wherever these stand: what must vanish for a pose to be one.
// The plugin is asked for its home pose alone.
//
// With the centre C and the axes n of each joint as both bodies hold them at home (closure.hpp), d the way from A's centre to B's, n = n_A,
// e1 and e2 two directions across it that A carries, f2 the direction that was e2 at home as B carries it,
//     spherical    d                               revolute      d, e1 . n_B, e2 . n_B
//     universal    d, n_A . n_B of axes 1 and 2    cylindrical   e1 . d, e2 . d, e1 . n_B, e2 . n_B
//     prismatic    as cylindrical, and e1 . f2, unless one of the bodies may spin freely about the axis
//     linear actuator   n . d + value at home - value
//     rotary actuator   the angle about n from e1 to what was e1 at home + value at home - value, the smaller turn
// lengths by one that is given. They say no more than these products: bodies may have turned over, which closure.hpp tells.
//
// When A moves by a small displacement (dp_A; t_A), and B likewise, d changes by dp_B + t_B x (C_B - p_B) - dp_A - t_A x (C_A - p_A), a
// direction e that a body carries by t x e, and so
//     of e . d:   e . (change of d) + t_A . (e x d)         of e . f:   t_A . (e x f) + t_B . (f x e)
#pragma once

#include <core/mechanics/model/state.hpp>

#include <vector>

namespace pmreport::mechanics {

class LoopEquations {
 public:
  LoopEquations(const Machine& machine, double length);

  struct Value {
    Eigen::VectorXd error;
    Eigen::MatrixXd slope;  // by displacements of the bodies 1..n: six columns each, way of the origin by `length`, turn
  };
  Value at(const std::vector<BodyState>& bodies, const Eigen::VectorXd& actuators) const;
  // Moves all bodies by such displacements.
  void displace(std::vector<BodyState>& bodies, const Eigen::VectorXd& by) const;

 private:
  struct Seat {  // a joint as a body holds it, in the body's axes
    Eigen::Vector3d centre, axis[2], e1, e2;
  };
  struct Held {
    Seat a, b;
    bool spins = false;
  };
  const Machine& machine_;
  double length_;
  std::vector<Held> joints_;
  Eigen::VectorXd home_actuators_;
  int rows_ = 0;
};

}  // namespace pmreport::mechanics
