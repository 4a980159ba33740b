// A machine as a model: the solids that the pictures show of it, each fixed to the body that carries it, and how the bodies move.
#pragma once

#include <reports/scene/gltf/glb.hpp>

#include <optional>
#include <vector>

namespace pmreport::scene {

// A pose of the motion that is PM_OK, at its time [s], from zero or later.
struct Moment {
  double time;
  mechanics::Pose pose;
};

// An axis of a joint that is fixed in the slender body and well off its z axis: it tells how the body turns about z.
struct Guide {
  int joint, k;
};
std::optional<Guide> guide_of(const mechanics::Machine& machine, int body);

// One node a body, in the machine's order, with what is drawn of it at home; bodies that look alike share a mesh. The nodes stand as at the
// first moment, without moments as at home; bodies that move between the moments, which rise in time, are animated. A body's frame is the
// machine's own. Of a slender body, of which the machine tells the z axis alone, x follows a joint's axis that is fixed in it, or else
// turns about z no more than it must. A link whose joints slide on it keeps its length at home. Labels, frames, loads, paths and centre
// lines are of pictures alone.
Model model_of(const mechanics::Machine& machine, const std::vector<Moment>& moments);

}  // namespace pmreport::scene
