// What is connected to what: bodies, joints, actuators, coordinates. An author fills one in; the host reads the same struct.
#pragma once

#include <pmreport/plugin.h>

#include <Eigen/Core>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport {

enum class JointKind {
  revolute = PM_REVOLUTE,
  prismatic = PM_PRISMATIC,
  universal = PM_UNIVERSAL,
  spherical = PM_SPHERICAL,
  cylindrical = PM_CYLINDRICAL
};
enum class ShapeKind { cylinder = PM_CYLINDER, ball = PM_BALL, box = PM_BOX };

// Number of axes that a joint shows in a placement, and of relative freedoms that it allows.
constexpr int axes_of(JointKind k) { return k == JointKind::universal ? 2 : k == JointKind::spherical ? 0 : 1; }
constexpr int freedoms_of(JointKind k) {
  return k == JointKind::spherical ? 3 : (k == JointKind::universal || k == JointKind::cylindrical) ? 2 : 1;
}

struct Range {
  double min, max;
};

// What a coordinate, an actuator or a wrench measures: "m" and "N" along a line, "rad" and "N*m" about one.
enum class Sense { linear, rotary };
constexpr Sense sense_of(std::string_view unit) { return unit == "rad" || unit == "N*m" ? Sense::rotary : Sense::linear; }

struct Coordinate {               // independent coordinate of the platform
  std::string name, title, unit;  // unit: "m" or "rad"
  double home = 0;
  Range box{-0.1, 0.1};  // sane values around home, for random poses

  Sense sense() const { return sense_of(unit); }

  static Coordinate around(double home, double half_box, std::string name, std::string title, std::string unit) {
    return {std::move(name), std::move(title), std::move(unit), home, {home - half_box, home + half_box}};
  }
};

struct Inertia {
  double mass = 0;                                         // [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();        // centre of mass from the body's origin, body axes [m]
  Eigen::Matrix3d about_centre = Eigen::Matrix3d::Zero();  // body axes [kg m^2]

  // A body of revolution about its z axis, its centre of mass at height `z`.
  static Inertia axisymmetric(double mass, double z, double transverse, double axial) {
    return {mass, {0, 0, z}, Eigen::Vector3d(transverse, transverse, axial).asDiagonal()};
  }
  // A solid cylinder of uniform density along its z axis, its centre of mass at height `z`.
  static Inertia solid_cylinder(double mass, double length, double radius, double z) {
    return axisymmetric(mass, z, mass * (3 * radius * radius + length * length) / 12, mass * radius * radius / 2);
  }
  // A body with its centre of mass at its origin; `i` is xx yy zz xy xz yz.
  static Inertia central(double mass, std::span<const double> i) {
    Inertia out{mass, Eigen::Vector3d::Zero(), {}};
    out.about_centre << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
    return out;
  }
};

struct Body {
  std::string name;
  int limb = 0;          // 1, 2, ...; 0 for base and platform
  bool slender = false;  // a leg that may spin freely about its own z axis; see plugin.h
  Inertia inertia;
};

struct Joint {
  std::string name;
  JointKind kind = JointKind::spherical;
  int a = 0, b = 0;  // bodies; motion is that of b relative to a
  std::vector<Range>
      limits;     // two for a universal joint, else one; meaning by kind, see plugin.h. Left empty: half a turn (or 10 m) either way
  int stud = -1;  // spherical: the body whose z axis the limit follows. Left at -1: b, or a where b is the platform
  Eigen::Vector3d from = Eigen::Vector3d::Zero();  // spherical: what the limit counts from, in axes of the other body. Zero: from home
};

struct Actuator {
  std::string name, title, unit;  // "m" or "rad"
  int joint = 0;
  Range stroke{0, 0};

  Sense sense() const { return sense_of(unit); }
};

struct Derived {
  std::string name, title, unit;
  bool dependent = false;  // a dependent (parasitic) coordinate of the platform
};

struct Constraint {               // constraint wrench of the limbs on the platform: a row of the overall Jacobian below the actuators
  std::string name, title, unit;  // "N" or "N*m"

  Sense sense() const { return sense_of(unit); }
};

enum class Rates { coordinates = PM_COORDINATE_RATES, actuators = PM_ACTUATOR_RATES, twist = PM_TWIST, none = PM_NO_RATES };

// A matrix that the source states. Matrices of one relation, each times the rates that it acts on, sum to what they give.
struct SourceMatrix {
  std::string name, title;
  int rows = 0, columns = 0;
  Rates acts_on = Rates::coordinates, gives = Rates::none;
  int relation = 0;
};

struct Reading {  // a number of the source at a pose, without rates; see plugin.h
  std::string name, title, unit;
};

struct Shape {
  int body = 0;
  ShapeKind kind = ShapeKind::cylinder;
  Eigen::Vector3d a = Eigen::Vector3d::Zero(), b = Eigen::Vector3d::Zero();  // body axes [m]; see plugin.h
  double radius = 0;                                                         // [m]
};

enum class ElementKind { beam = PM_BEAM, rail = PM_RAIL, drive = PM_DRIVE, bearing = PM_BEARING };
enum class Bending { none = PM_BENDING_NONE, couples = PM_BENDING_COUPLES, full = PM_BENDING_FULL };

// What a bar is made of; elastic.hpp has a table of the usual ones.
struct Material {
  double modulus = 0, shear_modulus = 0;  // [Pa]
  double expansion = 0;                   // by temperature [1/K]
};
struct CrossSection {
  double area = 0;      // [m^2]
  double bending[2]{};  // second moments of area about x and y [m^4]
  double torsion = 0;   // torsion constant [m^4]
};

// A part that gives way. What each kind means: plugin.h; elastic.hpp makes one in a line.
struct Element {
  static constexpr double rigid = std::numeric_limits<double>::infinity();

  std::string name, title;
  ElementKind kind = ElementKind::beam;
  int from = -1, to = -1, beside = -1, actuator = -1;
  Material material{};
  CrossSection section{};
  Bending bends = Bending::full;
  double buckling_length = 1, offset = 0;
  double stiffness[4] = {rigid, rigid, rigid, rigid};
};

struct Topology {
  std::vector<Coordinate> coordinates;
  std::vector<Body> bodies{Body{"base", 0, false, {}}};
  std::vector<Joint> joints;
  std::vector<Actuator> actuators;
  std::vector<Derived> derived;
  std::vector<Constraint> constraints;
  std::vector<Shape> shapes;
  std::vector<SourceMatrix> matrices;  // what the mechanism's `matrices` fills in, in this order
  std::vector<Reading> readings;       // what its `readings` gives, in this order
  std::vector<Element> elements;       // what gives way; all else is rigid
  int platform = 0;
  int idle = 0;  // idle freedoms: spins of legs that move nothing else

  // A coordinate of the platform's pose: independent, or dependent on the others.
  void add(Coordinate x, bool dependent) {
    if (dependent)
      derived.push_back({x.name, x.title, x.unit, true});
    else
      coordinates.push_back(std::move(x));
  }
  int add(Body x) { return push(bodies, std::move(x)); }
  int add(Joint x) { return push(joints, std::move(x)); }
  int add(Actuator x) { return push(actuators, std::move(x)); }
  int add(Element x) { return push(elements, std::move(x)); }
  // Draws a solid cylinder fixed to a body along its z axis, from height `low` to `high` [m].
  void draw_along_axis(int body, double low, double high, double radius) {
    shapes.push_back({body, ShapeKind::cylinder, {0, 0, low}, {0, 0, high}, radius});
  }

 private:
  template <class T>
  static int push(std::vector<T>& list, T x) {
    list.push_back(std::move(x));
    return static_cast<int>(list.size()) - 1;
  }
};

// Where each scalar of a placement stands (the rule is in plugin.h).
class Layout {
 public:
  Layout() = default;
  explicit Layout(const Topology& t) {
    std::size_t next = 1;  // 0 is the reach
    bodies_.push_back(0);
    for (std::size_t i = 1; i < t.bodies.size(); ++i) {
      bodies_.push_back(next);
      next += t.bodies[i].slender ? 6 : 12;
    }
    for (const Joint& j : t.joints) {
      joints_.push_back(next);
      next += 3 + 3 * static_cast<std::size_t>(axes_of(j.kind));
    }
    actuators_ = next;
    derived_ = actuators_ + t.actuators.size();
    size_ = derived_ + t.derived.size();
  }
  std::size_t body(int i) const { return bodies_[static_cast<std::size_t>(i)]; }
  std::size_t joint(int i) const { return joints_[static_cast<std::size_t>(i)]; }
  std::size_t actuator(int i) const { return actuators_ + static_cast<std::size_t>(i); }
  std::size_t derived(int i) const { return derived_ + static_cast<std::size_t>(i); }
  std::size_t size() const { return size_; }

 private:
  std::vector<std::size_t> bodies_, joints_;
  std::size_t actuators_ = 0, derived_ = 0, size_ = 0;
};

}  // namespace pmreport
