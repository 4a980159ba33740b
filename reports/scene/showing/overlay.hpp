// Several poses in one picture: how a machine gets from the first to the last.
#pragma once

#include <reports/scene/scene.hpp>
#include <string>
#include <vector>

namespace pmreport::scene {

struct Mark {  // a dot on the path, and what is written at it
  Eigen::Vector3d at;
  std::string text;
  bool of_pose = false;  // of one that is shown; else its text is left out where there is no room
};

// The first pose solid, the last too where the motion ends in it, the others as ghosts, on the one base; the path with its marks. Of the
// labels those of the frames and the actuators of the first pose: names of joints, pose by pose, would hide what they name.
struct Overlay {
  std::vector<mechanics::Pose> poses;
  bool returns = false;  // the motion ends where it began, as far as one sees, and not in the last of these poses
  std::vector<Mark> marks;
};
Scene build(const mechanics::Machine& machine, const Overlay& overlay, const Extras& extras);

// Which of `poses` to lay over one another, `count` at most, in their order: the first, the last where it is another, then always the one
// that is farthest from those chosen, by points of the platform. Poses that no eye could tell apart are not taken twice.
std::vector<std::size_t> spread(const mechanics::Machine& machine, const std::vector<mechanics::Pose>& poses, std::size_t count);

}  // namespace pmreport::scene
