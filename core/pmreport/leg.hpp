// Telescopic legs, the commonest limb there is: a cylinder and a piston on one line, with a joint at either end and a drive between.
//
//     base ==low== cylinder ==slide, driven== piston ==high== platform          (or any other two bodies)
//
// A leg from `from` to `to` has the length, and with n along it the rate,
//     l = |to - from|,   l' = n . (to' - from'),   n = (to - from) / l
// so that a leg on the base has the row force_row(g, leg.drive, at.axis(leg.slide), at.centre(leg.high) - at.origin(platform)).
// Its bodies have their z axes along n, their origins at `from` and `to`; the slide's centre is `to`.
//
// A leg takes three steps: number it (`legs`), declare it (`add_leg`), place it (`place_ups`, `place_spu`, `place_sps`, or `place_leg` and
// the joints at its ends, for any other).
#pragma once

#include <pmreport/placement.hpp>
#include <pmreport/rotation.hpp>

#include <array>
#include <stdexcept>
#include <string>

namespace pmreport {

// -- numbering ------------------------------------------------------------------------------------------------------------------------

struct Leg {
  int limb, drive;       // 1, 2, ...; its actuator, and so its row of the Jacobian
  int cylinder, piston;  // bodies
  int low, slide, high;  // joints
};

// Legs of which each is a limb of its own, declared one after the other: the first has body, joint and actuator of these numbers.
template <std::size_t Count>
constexpr std::array<Leg, Count> legs(int body, int joint = 0, int drive = 0) {
  std::array<Leg, Count> out{};
  for (int i = 0; i < static_cast<int>(Count); ++i) {
    const int b = body + 2 * i, j = joint + 3 * i;
    out[static_cast<std::size_t>(i)] = {i + 1, drive + i, b, b + 1, j, j + 1, j + 2};
  }
  return out;
}

// -- declaring ------------------------------------------------------------------------------------------------------------------------

// What the legs of one make have in common.
struct Telescope {
  std::string cylinder, piston, drive, length;  // what stands before a leg's number: "cylinder ", "piston ", "l", "length of leg "
  Inertia of_cylinder, of_piston;               // z axes along the leg: from `from` upwards, from `to` downwards
  Range stroke;                                 // of the length [m]
  bool slender = false;                         // may spin freely about itself, as between two balls
};

// Declares bodies, joints and drive of a leg whose names end in `n`, in the order of its numbers. Throws std::logic_error where the
// topology has come to other numbers.
inline void add_leg(Topology& t, const Leg& leg, const std::string& n, const Telescope& made, const Joint& low, const Joint& high) {
  const bool agree = t.add(Body{made.cylinder + n, leg.limb, made.slender, made.of_cylinder}) == leg.cylinder &&
                     t.add(Body{made.piston + n, leg.limb, made.slender, made.of_piston}) == leg.piston && t.add(low) == leg.low &&
                     t.add(Joint{"P" + n, JointKind::prismatic, leg.cylinder, leg.piston, {}}) == leg.slide && t.add(high) == leg.high &&
                     t.add(Actuator{made.drive + n, made.length + n, "m", leg.slide, made.stroke}) == leg.drive;
  if (!agree) throw std::logic_error("leg " + n + " is declared in another order than it is numbered");
}

// Draws both parts as cylinders of one length, which should be less than the shortest leg's [m].
inline void draw_leg(Topology& t, const Leg& leg, double length, double cylinder_radius, double piston_radius) {
  t.draw_along_axis(leg.cylinder, 0, length, cylinder_radius);
  t.draw_along_axis(leg.piston, -length, 0, piston_radius);
}

// -- placing --------------------------------------------------------------------------------------------------------------------------

template <class T>
struct Line {
  Vector3<T> from, to;
  T length;
  Vector3<T> n;  // unit, from `from` to `to`

  Line(const Vector3<T>& a, const Vector3<T>& b) : from(a), to(b) {
    const Vector3<T> along = b - a;
    length = pmreport::length(along);
    n = along * T(1.0 / length);
  }
};

// A leg without length points nowhere: there is no such pose.
template <class T>
void require_length(Placement<T>& at, const Line<T>& line) {
  constexpr double least = 1e-12;  // [m]: shorter is rounding of the two points
  at.require(line.length - least, "a leg has no length, and so no direction");
}

// Places bodies, slide and drive of a leg; the joints at its ends are left to the caller. `x` is the x axis of its bodies, a unit vector
// across the leg: the hinge of a leg that has one at an end. Returns the bodies' rotation.
template <class T>
Matrix3<T> place_leg(Placement<T>& at, const Leg& leg, const Line<T>& line, const Vector3<T>& x) {
  require_length(at, line);
  const Matrix3<T> frame = frame_xz(x, line.n);
  at.body(leg.cylinder, line.from, frame);
  at.body(leg.piston, line.to, frame);
  at.joint(leg.slide, line.to, line.n);
  at.actuator(leg.drive, line.length);
  return frame;
}

// A leg between two balls, slender: it may spin about itself, and is placed without spin.
template <class T>
void place_sps(Placement<T>& at, const Leg& leg, const Line<T>& line) {
  require_length(at, line);
  at.slender(leg.cylinder, line.from, line.n);
  at.slender(leg.piston, line.to, line.n);
  at.joint(leg.low, line.from);
  at.joint(leg.slide, line.to, line.n);
  at.joint(leg.high, line.to);
  at.actuator(leg.drive, line.length);
}

// The second axis of a Cardan joint on a leg along n. The first, e1, is fixed in what carries the leg (unit, base axes); the second is
// fixed in the leg and lies across both, so that the leg does not spin:  e2 = e1 x n / |e1 x n|.  `why` says that there is none where the
// leg points along e1.
template <class T>
Vector3<T> second_axis(Placement<T>& at, const Vector3<T>& e1, const Vector3<T>& n, const char* why) {
  const Vector3<T> across = e1.cross(n);
  const T sine = length(across);
  at.require(sine - 1e-6, why);
  return across * T(1.0 / sine);
}
inline constexpr const char* spin_undetermined = "a leg points along the first axis of its Cardan joint, and its spin is undetermined";

// A leg with a Cardan joint below, whose first axis e1 is fixed in what carries it, and a ball above. Returns the bodies' rotation.
template <class T>
Matrix3<T> place_ups(Placement<T>& at, const Leg& leg, const Line<T>& line, const Vector3<T>& e1, const char* why = spin_undetermined) {
  require_length(at, line);
  const Vector3<T> e2 = second_axis(at, e1, line.n, why);
  at.joint(leg.low, line.from, e1, e2);
  at.joint(leg.high, line.to);
  return place_leg(at, leg, line, e2);
}

// The same leg upside down: a ball below, and above the Cardan joint, whose first axis e1 is fixed in the body that the leg carries.
template <class T>
Matrix3<T> place_spu(Placement<T>& at, const Leg& leg, const Line<T>& line, const Vector3<T>& e1, const char* why = spin_undetermined) {
  require_length(at, line);
  const Vector3<T> e2 = second_axis(at, e1, line.n, why);
  at.joint(leg.low, line.from);
  at.joint(leg.high, line.to, e1, e2);
  return place_leg(at, leg, line, e2);
}

}  // namespace pmreport
