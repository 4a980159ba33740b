// Where the forces of actuators and constraints enter the platform: what a mechanism's indices of transmission are taken at. Found from its
// topology and from the rows of G, once a machine.
//
// Row i of G is the wrench (f; m) that a unit force of actuator i, the others without one, puts on the platform about its reference point.
// It is a single force where f . m = 0, f not zero, and acts at every point r of its line, m = r x f. What is true of the rows at home and
// at random poses is taken as a property of the mechanism: its rows are analytic in the coordinates.
#pragma once

#include <core/mechanics/machine/limb_line.hpp>
#include <core/mechanics/machine/machine.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

// A point of a body: the mean of the centres of joints that it holds, or its origin where there is none.
struct BodyPoint {
  int body = -1;  // -1: there is no such point
  std::vector<int> joints;
  bool exists() const { return body >= 0; }
};

struct DrivePath {
  std::optional<TelescopicDrive> telescope;  // a drive along the line between two joints
  BodyPoint entry;                           // of any other drive: where its limb holds the platform, or a body of it
  BodyPoint output;                          // on the platform, on the line of the actuator's force
  std::vector<int> next;                     // of a rotary drive: the joints that it moves
  std::string no_pressure, no_output;        // completes "rho1 has no pressure angle: ..."; empty: it has
};

struct ConstraintPath {
  bool couple = false;  // by a couple alone
  BodyPoint point;      // else: a joint of the platform on the line of its force
  std::string none;     // completes "couple1 has no transmission index: ..."; empty: it has
};

struct TransmissionPaths {
  std::vector<DrivePath> drives;            // one an actuator
  std::vector<ConstraintPath> constraints;  // one a constraint
  // The constraints are three couples, and the three actuators meet a platform that only translates: their forces alone tell how well it
  // moves, and no length enters.
  bool translates = false;
};
// `length`: characteristic_length(machine) [m].
TransmissionPaths transmission_paths(const Machine& machine, double length);

// "B1", "C11 and C12", "the platform's reference point".
std::string words_of(const Topology& topology, const BodyPoint& point);

}  // namespace pmreport::mechanics
