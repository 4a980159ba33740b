// Limbs as lines: what their angles and distances are told by.
#pragma once

#include <core/mechanics/machine/machine.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

// The last straight stretch of a limb: the body that its far joint holds, and those that slide on it. The far joint is the one to the
// platform; of a chain between other limbs that of its last body.
struct LimbLine {
  int limb = 0;             // from 1
  int from = 0, to = 0;     // joints at its ends, by which it points; `to` is the far one
  int low = 0, high = 0;    // joints on the line that lie farthest apart at home: the ends of its segment
  std::vector<int> joints;  // to bodies that are not its own
  double radius = 0;        // of the thickest cylinder that its bodies show along the line [m]
};

// Nothing, with a sentence that completes "limb 3 ": it has no line, or there is no such limb.
std::optional<LimbLine> limb_line(const Machine& machine, int limb, std::string* why = nullptr);
int limbs_of(const Topology& topology);  // how many there are: the largest number

// A drive that pushes along the line between two joints: a slide between one at its near end, towards the base, and one at its far end.
struct TelescopicDrive {
  int near = 0, far = 0;  // joints
};
// Of an actuator whose slide is that of its limb's line, or of a chain of its own within a limb: each of the two bodies that slide on one
// another holds one joint more, and both centres lie on the slide's axis at home. Nothing of any other drive.
std::optional<TelescopicDrive> telescopic_drive(const Machine& machine, int actuator);

// They share a joint, or end in joints whose centres meet at home: no distance is asked between them.
bool adjacent(const Machine& machine, const LimbLine& a, const LimbLine& b);

}  // namespace pmreport::mechanics
