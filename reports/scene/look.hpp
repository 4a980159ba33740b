// Sizes and colours that make a machine of 5 cm and one of 5 m look alike, and parts tell what they are.
#pragma once

#include <reports/scene/scene.hpp>
#include <vector>

namespace pmreport::scene {

// From the home pose: the same in every picture of a machine.
struct Sizes {
  double overall = 1;          // mean edge of the box around the joints [m]
  double joint = 0.025;        // radius of a joint's symbol [m]
  std::vector<double> joints;  // of each joint: as above, or more where a thicker limb would swallow it
};
Sizes measure(const mechanics::Machine& machine);

constexpr Color rgb(unsigned hex) {
  return {static_cast<float>(hex >> 16 & 255) / 255, static_cast<float>(hex >> 8 & 255) / 255, static_cast<float>(hex & 255) / 255, 1};
}

namespace palette {  // joints differ in lightness as well as in hue
inline constexpr Color base = rgb(0x66727f), platform = rgb(0x4d86bd), post = rgb(0x6d7884), tube = rgb(0x8f979f), rod = rgb(0xd4d9dd);
inline constexpr Color spherical = rgb(0xec9a2c), revolute = rgb(0x1f9e7a), universal = rgb(0xc777a8), cylindrical = rgb(0x5fb4e3);
inline constexpr Color x = rgb(0xc8342b), y = rgb(0x2f8f3c), z = rgb(0x2a5fc4);
inline constexpr Color load = rgb(0x8f1d78), path = rgb(0xd2560a), ink = rgb(0x1c232c), reaction = rgb(0xc3102f);
}  // namespace palette

// Whose curve a body is coloured by: the actuator, -1 none, and whether this body is the one that it moves.
struct Drive {
  int actuator = -1;
  bool driven = false;
};
std::vector<Drive> drives_of_bodies(const Topology& topology);
Color curve_color(int actuator);                       // that the plots give its curves, by its position among the actuators
Color tinted(const Color& plain, const Drive& drive);  // towards that colour

// The pieces of a picture; each adds to the scene.
void add_bodies(Scene& scene, const mechanics::Machine& machine, const mechanics::Pose& pose, const Sizes& sizes);
void add_joints(Scene& scene, const mechanics::Machine& machine, const mechanics::Pose& pose, const Sizes& sizes);
void add_frame(Scene& scene, const Eigen::Vector3d& origin, const Eigen::Matrix3d& axes, const char* const names[4], double length);
void add_extras(Scene& scene, const mechanics::Machine& machine, const mechanics::Pose& pose, const Sizes& sizes, const Extras& extras);

// Beside the longest part that an actuator moves, at its middle; where nothing is drawn of it, at its joint. `names`: as of extras.
void add_drive_names(Scene& scene, const mechanics::Machine& machine, const mechanics::Pose& pose, const std::vector<std::string>& names);

// A plate that carries `points`, on its side away from `towards`, and a post from it to each of them.
struct Carried {
  Eigen::Vector3d at;
  double radius;  // of the joint there
};
struct Plate {
  std::vector<Solid> solids;
  Eigen::Vector3d normal{0, 0, 1};  // from the plate to the points
};
Plate make_plate(const std::vector<Carried>& points, const Eigen::Vector3d& towards, const Eigen::Vector3d& normal_in_doubt,
                 double thickness, const Color& color);

inline Solid cylinder(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius, const Color& color, float through = 0) {
  return {Solid::Kind::cylinder, a, b, radius, Eigen::Matrix3d::Identity(), {}, color, through};
}
inline Solid ball(const Eigen::Vector3d& centre, double radius, const Color& color, float through = 0) {
  return {Solid::Kind::ball, centre, {0, 0, 0}, radius, Eigen::Matrix3d::Identity(), {}, color, through};
}
inline Solid cone(const Eigen::Vector3d& base, const Eigen::Vector3d& tip, double radius, const Color& color, float through = 0) {
  return {Solid::Kind::cone, base, tip, radius, Eigen::Matrix3d::Identity(), {}, color, through};
}

}  // namespace pmreport::scene
