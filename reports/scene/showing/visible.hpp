// What of a scene a camera sees: a small picture of which part is in front, made without OpenGL.
#pragma once

#include <reports/scene/scene.hpp>
#include <vector>

namespace pmreport::scene {

// Pixels that show a part, and those that would if it stood alone.
struct Visible {
  int seen = 0, alone = 0;
};

// Of each part, a number from 0 to `parts` - 1; `part` tells to which each solid of the scene belongs, -1: it only hides others; -2: as if
// it were not there. Joints and rods are drawn no thinner than a pixel.
std::vector<Visible> visible(const Scene& scene, const std::vector<int>& part, int parts, const Camera& camera, int width, int height);

}  // namespace pmreport::scene
