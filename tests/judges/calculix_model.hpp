// A machine at a pose as a structure of finite elements: of beams between the centres of its joints, rigid bodies, joints that hold what
// they hold, drives that stand. Nothing of the force method enters, no reaction and no self-stress.
//
// A beam is one bar along the line from its root to its end, cut where the bodies of its chain meet; each has the bar on its own side, the
// further joints of a body and its mass are fixed to the bar where they lie along it. A body without beams is rigid. A joint relates the
// two places: their relative displacement at its centre, along every wrench that the joint can pass, is nothing, or what springs there
// give.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <tests/judges/calculix_deck.hpp>

#include <span>
#include <vector>

namespace pmreport::judges {

class CalculixModel {
 public:
  enum class Mass {
    of_bodies,   // at the centre of each, with its rotary inertia
    along_beams  // a body that one beam runs through is a rod of uniform density along it, of such length as gives its transverse inertia
  };
  // Actuators locked. `elements`: of a beam, and more where something is fixed to it. Throws std::invalid_argument for what it cannot
  // express: a compliant base or platform, beams of infinite rigidity, temperature.
  CalculixModel(const mechanics::Machine& machine, std::span<const double> coordinates, Mass mass = Mass::of_bodies, int elements = 8);

  // What an element carries, largest along it, of a beam: axial force (tension positive), bending moment, torque. Of a drive or a rail: the
  // force that shortens it [N], [N m] is `axial`, negative.
  struct Carried {
    double axial = 0, bending = 0, torque = 0;
  };
  struct Answer {
    Vector6d platform;             // its displacement at its reference point
    std::vector<Carried> carried;  // by element of the topology
  };
  // Of each load on the platform (force; moment about its reference point) by itself.
  std::vector<Answer> under(std::span<const Vector6d> loads) const;
  Matrix6d compliance() const;

  // Kinetic energy 1/2 w' . M w' of all bodies in the shapes of static displacement under wrenches w on the platform.
  Matrix6d inertia() const;
  // Displacement of the platform under the weight of all bodies.
  Vector6d sag(const Eigen::Vector3d& gravity) const;

  struct Mode {
    double frequency;   // [Hz]
    Vector6d platform;  // of kinetic energy 1/2 at unit rate
  };
  // All of them, lowest first: by the flexibilities that CalculiX finds between the masses.
  enum class Platform { free, held };
  std::vector<Mode> modes(Platform platform = Platform::free) const;

 private:
  // The machine as nodes, bars, springs, relations and lumps of inertia: calculix_structure.cpp, its beams calculix_beams.cpp.
  struct Part {  // the bar of one body of a beam: nodes from its near end to its far one
    int body;
    std::vector<int> nodes;
    std::vector<double> along;       // from the root of the beam [m]
    std::vector<std::size_t> stops;  // of the nodes: where something is fixed, and the ends
    std::vector<int> gauges;         // six a stretch between two stops: axial force, torque, moments about x and y at either end
  };
  struct Beam {
    int element;
    Eigen::Vector3d root, n, x;
    double length;
    std::vector<int> joints;
    std::vector<Part> parts;
  };
  struct Elastic {  // at a joint: gives by `wrench` (about its centre) times what the spring gives
    Vector6d wrench;
    int spring;
    bool of_drive;
  };
  struct Lump {
    int node;
    Matrix6d inertia;  // about the node
  };
  struct SpringOf {
    int node, element;
    double stiffness;
  };

  void add_beam(int element, int elements);
  void add_stretch(const Beam& beam, int from, int to);
  void add_springs();
  int add_spring(int element, double stiffness);
  void add_joint(int joint);
  void connect(int a, int b, const Eigen::Vector3d& centre, const Vector6d& held, const std::vector<Elastic>& gives);
  void add_bodies();
  void add_masses(Mass mass);
  void add_lump(int node, const Eigen::Vector3d& centre, double mass, const Eigen::Matrix3d& about_centre);
  void add_gauges(const Beam& beam, Part& part);
  int place_on(int body, const Eigen::Vector3d& point) const;  // node that carries a point of a body
  int end_at(int body, int joint) const;                       // node of a body at a joint of it

  const mechanics::Machine& machine_;
  mechanics::Pose pose_;
  CalculixDeck deck_;
  std::vector<int> rigid_;  // by body: its node, where it is rigid; or the common root of its beams; -1 before either
  std::vector<Beam> beams_;
  std::vector<std::vector<Elastic>> elastic_;  // by joint
  std::vector<SpringOf> springs_;
  std::vector<Lump> lumps_;
  int platform_ = -1;
};

}  // namespace pmreport::judges
