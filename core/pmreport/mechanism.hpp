// What the author of a mechanism includes. This is the guide: read it from here to `#pragma once`, and write a plugin.
//
// A mechanism is one class. It says what is connected to what, where everything is, and what carries the load; nobody differentiates.
// A whole one: a table carried by six telescopic legs, each between a Cardan joint on the base and a ball on the table.
//
//   #include <pmreport/free_platform.hpp>
//   #include <pmreport/leg.hpp>
//   #include <pmreport/mechanism.hpp>
//
//   using namespace pmreport;
//   using Eigen::Vector3d;
//
//   class Table : public Mechanism<6> {                                       // degrees of freedom
//    public:
//     static constexpr const char* name = "table";                            // what a scenario calls it
//     static constexpr const char* title = "A table on six legs";             // a line for people
//     static constexpr const char* source = "the guide for authors";          // the paper
//     static constexpr Parameter parameters[] = {                             // what a scenario may set
//         Parameter::length("base_radius", 0.5, "distance of A1 to A6 from O", {0.1, 10}),
//         Parameter::mass("platform_mass", 5, "mass of the table"),
//     };
//
//     explicit Table(const Parameters& p) : mass_(p["platform_mass"]) {
//       if (p["base_radius"] < 2 * radius) refuse("base_radius must be at least ", 2 * radius, " m");
//       for (std::size_t i = 0; i < 6; ++i) {                                 // joints in pairs, 20 degrees to either side
//         const double vertex = double(i / 2) * 2 * std::numbers::pi / 3, side = i % 2 == 0 ? -0.35 : 0.35;
//         const double at_base = vertex + side, at_table = vertex + side * 2;
//         a_[i] = p["base_radius"] * Vector3d(cos(at_base), sin(at_base), 0);
//         b_[i] = radius * Vector3d(cos(at_table), sin(at_table), 0);
//         e_[i] = {-sin(at_base), cos(at_base), 0};
//       }
//     }
//
//     Topology topology() const {                                             // what is connected to what
//       Topology t;
//       t.coordinates = free_pose({0, 0, 0.6, 0, 0, 0}, 0.1, 0.2);
//       t.platform = t.add(Body{"table", 0, false, Inertia::solid_cylinder(mass_, 0.02, radius, 0)});
//       const Telescope made{"cylinder ", "piston ", "l", "length of leg ", Inertia::solid_cylinder(1, 0.4, 0.02, 0.2),
//                            Inertia::solid_cylinder(0.5, 0.4, 0.01, -0.2), {0.4, 1.1}};
//       for (const Leg& leg : legs_) {
//         const std::string n = std::to_string(leg.limb);
//         add_leg(t, leg, n, made, {"A" + n, JointKind::universal, 0, leg.cylinder, {{-1, 1}, {-1, 1}}},
//                 {"B" + n, JointKind::spherical, leg.piston, platform, {{0, 1}}});
//       }
//       return t;
//     }
//
//     template <class T>
//     void place(const Coordinates<T>& q, Placement<T>& at) const {           // where everything is
//       const Vector3<T> p(q[0], q[1], q[2]);
//       const Matrix3<T> r = place_free(at, platform, q);
//       for (std::size_t i = 0; i < 6; ++i) place_ups<T>(at, legs_[i], {a_[i].cast<T>(), p + r * b_[i]}, e_[i].cast<T>());
//     }
//
//     template <class T>
//     Matrix6<T> jacobian(const Placement<T>& at) const {                     // what carries the load
//       Matrix6<T> g;
//       for (const Leg& leg : legs_) force_row<T>(g, leg.drive, at.axis(leg.slide), at.centre(leg.high) - at.origin(platform));
//       return g;
//     }
//
//    private:
//     static constexpr int platform = 1;
//     static constexpr double radius = 0.2;
//     static constexpr auto legs_ = legs<6>(platform + 1);
//     double mass_;
//     Vector3d a_[6], b_[6], e_[6];                                           // A_i, first axes: base axes; B_i: the table's
//   };
//   PMREPORT_PLUGIN(Table)                                                    // or several: PMREPORT_PLUGIN(One, Another)
//
// The members
//   parameters  number, length, angle, mass, inertia, numbers, choice, working_mode: parameter.hpp. A mechanism without any has
//               `static constexpr std::array<Parameter, 0> parameters{};`. Values are in SI and within their ranges. `unless("NAME")`
//               after one says which other parameter, once given, stands in its place.
//   constructor reads them: p["NAME"] a number, p.numbers("NAME") a list, p.choice("NAME") a word. What fits no machine it refuses
//               with a sentence for the user, as above; home must be a pose that can be assembled. Afterwards nothing changes any more:
//               threads share the object.
//   topology    coordinates (as many as degrees of freedom), bodies, joints, actuators (as many as degrees of freedom), derived
//               quantities, constraint wrenches (what is missing to six), shapes: topology.hpp. Body 0 is the base, and is there
//               already. `add` gives the number of what it added; `place` and `jacobian` speak in these numbers. Bodies without shapes
//               are drawn from their joints. `idle` counts the spins of legs that move nothing else. A joint's limits count from home,
//               a ball's from `from` where that is given. README.md has a table of the joints and words.
//   place       says for coordinates q the place of every body (origin, rotation from body to base axes; a slender one: origin, z axis),
//               of every joint (centre, and its axes: one of a hinge or slide, two of a universal joint, none of a ball), the value of
//               every actuator and derived quantity. at.require(margin, "why not") says how far the mechanism reaches: only while
//               margin is positive. All in base axes, m and rad.
//   jacobian    6 x 6. G times the platform's twist (v; w), v of its origin, gives the actuators' rates, and zero for each constraint.
//               So row i is the wrench (force; moment about that origin) on the platform of actuator i pushing with one, or of
//               constraint i: force_row and couple_row of wrench.hpp write one. `at` answers where everything is.
//   matrices    optional: what the source states, as it states it.
//                 std::vector<Eigen::MatrixXd> matrices(const Coordinates<double>&, const Placement<double>&) const;
//               declared in Topology::matrices with the rates that they act on, so that the program can prove them.
//   elements    what gives way, for stiffness, deflection and vibration, a line each in `topology`:
//                 t.add(beam("leg1", joint, joint, steel, tube(0.030, 0.020)));  t.add(spring_drive("drive1", actuator, 30e6));
//               elastic.hpp has beams, rails, drives, bearings, materials and sections. All else is rigid.
//   readings    optional: numbers of the source at a pose, without rates, declared in Topology::readings.
//                 std::vector<double> readings(const Coordinates<double>&, const Placement<double>&) const;
//
// Scalars. `place` and `jacobian` run on numbers that carry rates, partial derivatives, or several poses at a time, and once on numbers
// that write down what is done with them (recorded.hpp): from that list the program proves what holds between samples. So they
// do the same operations whatever the coordinates are: write T, not double, for what depends on q; no `if` on a T or on what type it is,
// but choose(mask, a, b), smaller and larger; length(v) and unit(v) in place of Eigen's norm() and normalized(): scalar.hpp; the
// compiler's error names them. A constant vector becomes one of T by c.cast<T>(). Loops of a fixed length are welcome, and an iteration
// takes a fixed number of steps: README.md shows one.
//
// Helpers. elastic.hpp: what gives way. rotation.hpp: rotations and frames. leg.hpp: telescopic legs. free_platform.hpp: a platform with
// six freedoms. parts.hpp: limits and inertias from parameters. plugin.h says to the last digit what every number means.
//
// Then `pmreport check` holds joints, axes, rates, mobility and wrenches against each other, and says what does not fit by its name.
#pragma once

#include <pmreport/contract.hpp>
#include <pmreport/rotation.hpp>
#include <pmreport/wrench.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace pmreport {

// The base of a mechanism with so many degrees of freedom, and actuators.
template <int Dof>
class Mechanism {
 public:
  static constexpr int dof = Dof;
  template <class T>
  using Coordinates = std::array<T, static_cast<std::size_t>(Dof)>;
};

}  // namespace pmreport

// Exports the mechanisms of this library: its only visible symbol.
#define PMREPORT_PLUGIN(...)                                                                      \
  extern "C" __attribute__((visibility("default"))) constinit const pm_plugin_table pm_plugin = { \
      sizeof(pm_plugin_table),                                                                    \
      PM_ABI_MAJOR,                                                                               \
      PM_ABI_MINOR,                                                                               \
      "C++ " __VERSION__,                                                                         \
      pmreport::contract::mechanisms<__VA_ARGS__>.size(),                                         \
      pmreport::contract::mechanisms<__VA_ARGS__>.data()};
