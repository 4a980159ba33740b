// The kinematic diagram of a mechanism, as papers draw it: lines for links, a symbol for each joint, hidden lines dashed.
#pragma once

#include <reports/scene/scene.hpp>
#include <string>
#include <vector>

namespace pmreport::scene {

struct Diagram {
  Scene scene;  // to be drawn plainly (vector/drawing.hpp): white symbols, grey ones where an actuator drives
  Camera camera;
};

// The home pose. The base is hatched along its lower side; a ball is a spherical joint, a cylinder a revolute one and a longer one with a
// rod a cylindrical one, a cross a universal one, a box a prismatic one. Axes of revolute and universal joints are dash-dot lines, named
// s1, s2, ... in the order of the joints: all of them where they are few, else those of the first limb. `drives`: what actuators are
// called.
Diagram diagram(const mechanics::Machine& machine, const std::vector<std::string>& drives, double azimuth, double elevation,
                const Quality& quality);

// What stands for what in it: "balls are spherical joints, boxes prismatic ones; grey joints are driven, dashed lines are hidden".
std::string legend(const mechanics::Machine& machine);

}  // namespace pmreport::scene
