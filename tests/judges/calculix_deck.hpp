// A structure of bars, springs and linear relations as CalculiX reads it, and what CalculiX finds of it.
//
// CalculiX 2.20 has a beam of two nodes with six freedoms each, user element U1 (Luo 2008). Measured, and held by the tests:
//   - Bent along its first direction it is right, across it is not: a cantilever gives way against its load. A bar is therefore two of them
//     with half the area each, one bending along x, one along y, the second moment of the other direction zero.
//   - It takes shear into account, with the wrong sign. `shear_share` makes that nothing: the beam is Euler's and Bernoulli's.
//   - Torsion is G (I1 + I2), and Poisson's ratio must be below a half. What a bar twists more than that is a spring in series.
//   - Its direction must be across its axis, or the element is nonsense without a word.
//   - It has no mass: *FREQUENCY stops. The caller gets flexibilities, and puts masses to them.
// A node's rotations exist only where such a beam ends: a rigid body's node carries a stub, a bar that ends in nothing.
// Each *EQUATION needs a freedom of its own that stands first in it and nowhere else, so the relations are eliminated here.
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pmreport::judges {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Displacements = Eigen::Matrix<double, 6, Eigen::Dynamic>;  // (translation; rotation) of a node in each column

class CalculixDeck {
 public:
  static constexpr int base = -1;  // in the place of a node: does not move

  struct Bar {
    double axial = 0, torsion = 0;                // E A [N], G J [N m^2]
    double bending_x = 0, bending_y = 0;          // E I about x and y [N m^2]
    Eigen::Vector3d x = Eigen::Vector3d::Zero();  // unit, across the bar
  };

  int add_node(const Eigen::Vector3d& at);
  int add_rigid(const Eigen::Vector3d& at);  // a node that no bar needs to end in
  void add_bar(int from, int to, const Bar& bar);
  // A spring: a node whose first freedom is by how much it gives, and which passes that times `stiffness`.
  int add_spring(double stiffness);

  struct Term {
    int node, freedom;  // 0 to 5: translations, rotations, base axes
    double coefficient;
  };
  // Sum of coefficients times freedoms is zero. Terms of the base may be among them. Relations that follow from others are welcome.
  void relate(std::vector<Term> terms) { relations_.push_back(std::move(terms)); }

  // A number of its own to read, to seven digits whatever they leave of the displacements that it is a difference of: a node without
  // stiffness, whose first freedom is the sum of these terms.
  int add_gauge(std::vector<Term> terms);

  const Eigen::Vector3d& place(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  int nodes() const { return static_cast<int>(nodes_.size()); }

  struct Load {
    int node;
    Vector6d wrench;  // about the node
  };
  using Loads = std::vector<Load>;  // at once, one a node
  // Displacements in each case, a column a node of `watched`; seven digits. Throws std::runtime_error with CalculiX's words.
  std::vector<Displacements> solve(const std::vector<Loads>& cases, const std::vector<int>& watched) const;

 private:
  struct Beam {
    int from, to;
    Eigen::Vector3d direction;
    double modulus, poisson, area, second, shear;
  };
  std::string input(const std::vector<Loads>& cases, const std::vector<int>& watched) const;
  std::string equations() const;

  std::vector<Eigen::Vector3d> nodes_;
  std::vector<Beam> beams_;
  struct Spring {
    int node;
    double stiffness;
  };
  std::vector<Spring> springs_;
  std::vector<std::vector<Term>> relations_;
  struct Gauge {
    int node;
    std::vector<Term> terms;
  };
  std::vector<Gauge> gauges_;
};

}  // namespace pmreport::judges
