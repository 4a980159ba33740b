// What a pose of a mechanism must keep: reach, strokes, joints, and what a designer asks besides, as one program of margins.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/program/guided.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pmreport::mechanics {

constexpr double open_end = std::numeric_limits<double>::infinity();

// A number of the pose between two ends, both included.
struct PoseLimit {
  enum class Group { reach, strokes, joints, angles, values, distances, pressure, condition, transmission, compliance };
  Group group = Group::reach;
  std::string name;   // "rho1", "A1_deflection", "base cone 1"; of the reach "reach"
  std::string title;  // "length of leg 1"
  std::string unit;   // SI
  double min = -open_end, max = open_end;
  std::string value = {};  // of a value with a name that was asked for: its own
};
const char* name_of(PoseLimit::Group group);  // "strokes"

// A direction that angles are measured against: of a body, or fixed to the base.
struct Direction {
  int body = 0;                                     // in whose axes it is given; 0: the base
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // need not be unit
};

// What is asked besides the limits of the mechanism. Limbs count from 1, as bodies name them; a limb's line runs from the joint that is
// lowest on its axis at home to the highest.
struct AskedAngle {  // between a limb's line and a direction
  std::vector<int> limbs;
  Direction against;
};
struct AskedValue {  // an actuator, a joint's motion, a derived quantity or a reading; or a group: "actuator", "joint_angle", "derived",
                     // "reading"
  std::string name;
};
struct AskedDistance {  // between limbs as finite segments, of `limbs` among each other, or to those `with` them; limbs that share a joint,
                        // or start in one point at home, are no pair. With `surfaces` the limbs' radii are taken off.
  std::vector<int> limbs, with;
  bool surfaces = false;
};
struct AskedPressure {};      // pressure angle of every actuator [rad]
struct AskedCondition {};     // condition number of G, moments over the characteristic length
struct AskedTransmission {};  // local transmission index, which the mechanism must have
struct AskedCompliance {  // largest displacement of the platform's reference point by a force of 1 N there, the drives alone yielding [m/N]
  double drive_stiffness = 0;  // of each, [N/m] or [N m/rad]
  bool horizontal = false;     // the force lies in the base's xy plane
};
struct AskedLimit {
  std::string name;  // for the tables; empty: its own. Of a group of values it stands before the name of each
  std::variant<AskedAngle, AskedValue, AskedDistance, AskedPressure, AskedCondition, AskedCompliance, AskedTransmission> what;
  double min = -open_end, max = open_end;
  // Of an index: a point of a scan counts only where all orientations that keep the other limits keep this one too.
  bool every = false;
};

// One end of a limit: "rho1<" is broken below the least, "rho1>" above the most.
struct PoseMargin {
  int limit = 0;
  bool upper = false;
  std::string name;     // "rho1<"; of the reach "reach"
  double rounding = 0;  // of the margin: nearer to zero, rounding decides
};

struct PoseMargins {
  // Inputs: the coordinates. Output k: margin k, zero on the limit and negative beyond, of any scale: of a length its square may be held
  // against the limit's, of an angle its cosine. In the order in which reasons are told: reach; actuators; joints as declared; then what
  // was asked, in its order; of a limit the lower end first.
  program::Program program;
  std::vector<PoseLimit> limits;    // the reach first
  std::vector<PoseMargin> margins;  // those of the program, then the late ones
  // What no program gives: readings, pressure angles, condition numbers, transmission indices. As scan::LateMargins.
  std::size_t late = 0;
  std::size_t every = 0;  // the last so many of the late ones must hold at every orientation that the others accept
  std::function<void(std::size_t count, const double* poses, double* out)> judge_late;
  std::optional<program::Guided> late_over_boxes;  // the same margins for boxes of poses, where all of them have them
  std::vector<std::string> left_out;               // joints whose motion the geometry leaves open: not judged
};

struct LimitChoice {
  bool strokes = true, joints = true;
  std::vector<AskedLimit> asked;
};
// A sentence that completes "..." when a limit names what the mechanism does not have; nothing when all is well.
std::optional<std::string> refusal(const Machine& machine, const AskedLimit& asked);
// SI unit of the value, or of the first of the group, of that name; empty where there is none, or where it is a plain number.
std::string unit_of_value(const Machine& machine, const std::string& name);
// Nothing where the mechanism has no program; `why` then gets a sentence.
std::optional<PoseMargins> pose_margins(const Machine& machine, const LimitChoice& choice, std::string* why = nullptr);

// det G of the overall Jacobian, as a program of the coordinates.
program::Program determinant_program(const Machine& machine);

}  // namespace pmreport::mechanics
