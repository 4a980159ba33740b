// The files of a new mechanism called my-robot, its class MyRobot; another name takes their places. README.md shows some of them too.
#pragma once

#include <string_view>

namespace pmreport::program::scaffold_text {

// A planar 3-RPR: the smallest mechanism that has everything, limbs with three joints each, a drive in each limb, and constraint wrenches.
inline constexpr std::string_view mechanism =
    R"text(// my-robot, so far a planar 3-RPR: three telescopic limbs move a platform in the plane, and turn it.
//
//     base   A_i R ===cylinder===[ P ]---piston--- R B_i   platform            i = 1, 2, 3; every hinge R along Z
//
// Limb i runs from A_i to B_i = p + R b_i. Its driven slide has the length, and with n_i along the limb the rate,
//     l_i = |B_i - A_i|                                                                                                            (1)
//     l_i' = n_i . (v + w x R b_i) = (n_i; R b_i x n_i) . (v; w),   n_i = (B_i - A_i) / l_i                                        (2)
// and the hinges hold the platform in its plane: no shift along Z, no turn about X or Y.
//
// To make it yours: draw your joints, count bodies and joints in `topology`, put every body and joint in its place in `place`, and write
// the wrenches that drive and hold the platform in `jacobian`. `pmreport check` tells what does not fit yet.
#include <pmreport/elastic.hpp>
#include <pmreport/mechanism.hpp>

using namespace pmreport;
using Eigen::Vector3d;

namespace {

constexpr double deg = std::numbers::pi / 180;
constexpr int platform = 1;
struct Limb {  // bodies and joints of limb i = 0..2, in the order in which `topology` adds them
  int i, cylinder = 2 + 2 * i, piston = 3 + 2 * i, a = 3 * i, p = 3 * i + 1, b = 3 * i + 2;
};
constexpr Limb limbs[] = {{0}, {1}, {2}};

class MyRobot : public Mechanism<3> {  // degrees of freedom
 public:
  static constexpr const char* name = "my-robot";
  static constexpr const char* title = "Planar 3-RPR: three driven limbs, 3 degrees of freedom";
  static constexpr const char* source = "the example of pmreport new mechanism";
  // What a scenario may set. Lengths in m, angles in rad, masses in kg; a report shows mm and degrees.
  static constexpr Parameter parameters[] = {
      Parameter::length("base_radius", 0.5, "distance of A1 to A3 from O", {0.01, 100}),
      Parameter::length("platform_radius", 0.15, "distance of B1 to B3 from p", {0.01, 100}),
      Parameter::mass("platform_mass", 2, "mass of the platform, centre of mass at p"),
      Parameter::choice("material", material_names, 0, "material of the limbs"),
  };

  explicit MyRobot(const Parameters& p) : mass_(p["platform_mass"]), material_(material_of(p, "material")) {
    // A quarter turn between the two triangles: with the limbs pointing at p the mechanism would be singular.
    for (const Limb& limb : limbs) {
      const double azimuth = (-90 + 120 * limb.i) * deg;
      a_[limb.i] = p["base_radius"] * Vector3d(cos(azimuth), sin(azimuth), 0);
      b_[limb.i] = p["platform_radius"] * Vector3d(-sin(azimuth), cos(azimuth), 0);
    }
    home_length_ = (b_[0] - a_[0]).norm();
  }

  // What is connected to what: body 0 is the base, which is there already. Kutzbach: 8 links, 9 joints with 9 freedoms, and 6
  // constraints more than needed, as in every planar mechanism: 6 (8 - 9 - 1) + 9 + 6 = 3.
  Topology topology() const {
    Topology t;
    t.coordinates = {{"x", "X position", "m", 0, {-0.2 * home_length_, 0.2 * home_length_}},
                     {"y", "Y position", "m", 0, {-0.2 * home_length_, 0.2 * home_length_}},
                     {"phi", "turn about Z", "rad", 0, {-20 * deg, 20 * deg}}};
    t.platform = t.add(Body{"platform", 0, false, Inertia::solid_cylinder(mass_, 0.02, b_[0].norm(), 0)});
    for (const Limb& limb : limbs) {
      const std::string n = std::to_string(limb.i + 1);
      t.add(Body{"cylinder " + n, limb.i + 1, false, Inertia::solid_cylinder(1, 0.5 * home_length_, 0.02, 0.25 * home_length_)});
      t.add(Body{"piston " + n, limb.i + 1, false, Inertia::solid_cylinder(0.4, 0.5 * home_length_, 0.01, -0.25 * home_length_)});
      t.add(Joint{"A" + n, JointKind::revolute, 0, limb.cylinder, {{-45 * deg, 45 * deg}}});
      t.add(Joint{"P" + n, JointKind::prismatic, limb.cylinder, limb.piston, {}});
      t.add(Joint{"B" + n, JointKind::revolute, limb.piston, platform, {{-60 * deg, 60 * deg}}});
      t.add(Actuator{"l" + n, "length of limb " + n, "m", limb.p, {0.55 * home_length_, 1.45 * home_length_}});
      // What gives way under load, for the section `stiffness`: the limb as a tube from hinge to hinge, and its drive [N/m].
      t.add(beam("limb" + n, limb.a, limb.b, material_, tube(0.030, 0.020)));
      t.add(spring_drive("drive" + n, limb.i, 30e6));
      // The platform is drawn as a triangle of bars. What has no shapes is drawn from its joints.
      t.shapes.push_back({platform, ShapeKind::cylinder, b_[limb.i], b_[(limb.i + 1) % 3], 0.08 * b_[0].norm()});
    }
    t.constraints = {{"fz", "force that holds the platform along Z", "N"},
                     {"mx", "couple that holds it about X", "N*m"},
                     {"my", "couple that holds it about Y", "N*m"}};
    return t;
  }

  // Where everything is, at coordinates q. T is not always a double: the same lines give rates, accelerations and partial
  // derivatives.
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> p(q[0], q[1], T(0.0)), z = Vector3d::UnitZ().cast<T>();
    const Matrix3<T> r = rotation_z(q[2]);
    at.body(platform, p, r);
    for (const Limb& limb : limbs) {
      const Vector3<T> a = a_[limb.i].cast<T>(), b = p + r * b_[limb.i];
      const T l = length<T>(b - a);  // (1)
      const Vector3<T> n = (b - a) * (1.0 / l);
      at.body(limb.cylinder, a, frame_xz(z, n));  // body axes: x along the hinges, z along the limb
      at.body(limb.piston, b, frame_xz(z, n));
      at.joint(limb.a, a, z);
      at.joint(limb.p, b, n);
      at.joint(limb.b, b, z);
      at.actuator(limb.i, l);
    }
  }

  // What carries the load: G times the platform's twist (v; w) gives (actuator rates, 0). Row i is also the wrench of actuator i,
  // or of constraint i, on the platform.
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    Matrix6<T> g = Matrix6<T>::Zero();
    for (const Limb& limb : limbs) force_row<T>(g, limb.i, at.axis(limb.p), at.centre(limb.b) - at.origin(platform));  // (2)
    g(3, 2) = g(4, 3) = g(5, 4) = T(1.0);
    return g;
  }

 private:
  Vector3d a_[3], b_[3];  // A_i in base axes, b_i in platform axes
  double home_length_ = 0, mass_;
  Material material_;
};

}  // namespace

PMREPORT_PLUGIN(MyRobot)
)text";

inline constexpr std::string_view cmake = R"text(cmake_minimum_required(VERSION 3.25)
project(my-robot LANGUAGES CXX)
find_package(pmreport 1.0 REQUIRED)
pmreport_add_mechanism(my-robot mechanism.cpp)
)text";

inline constexpr std::string_view scenario = R"text(title = "my-robot: once around a circle"

[mechanism]
use = "my-robot"

[motion]
duration = "4 s"
samples = 161
x = "60 mm * sin(2*pi*t/4 s)"
y = "60 mm * (1 - cos(2*pi*t/4 s)) / 2"
phi = "10 deg * sin(2*pi*t/4 s)"

[load]
force = ["20 N", "0 N", "0 N"]

[[section]]
kind = "mechanism"

[[section]]
kind = "snapshots"
times = ["0 s", "1 s"]

[[section]]
kind = "displacement"

[[section]]
kind = "velocity"

[[section]]
kind = "acceleration"

[[section]]
kind = "statics"

[[check]]
that = "max(abs(actuator_force))"
below = "100 N"
)text";

inline constexpr std::string_view readme = R"text(# my-robot

A mechanism for pmreport. With the folder of `pmreport` on the PATH:

```sh
cmake -S . -B build && cmake --build build
pmreport check build/my-robot.so
pmreport scenario.toml --plugin-path build
```

The first builds the plugin, the second holds its geometry against its joints at a thousand random poses, and the third makes the report in
`scenario-report`.
)text";

}  // namespace pmreport::program::scaffold_text
