// A picture of a mechanism: solids, lines and labels in space, seen by a camera that frames the whole motion.
#pragma once

#include <Eigen/Core>
#include <array>
#include <core/mechanics/machine/machine.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace pmreport::scene {

struct Color {
  float r, g, b, a = 1;  // sRGB, 0 to 1
};

struct Solid {
  enum class Kind { cylinder, ball, cone, box, plate } kind;
  Eigen::Vector3d a{0, 0, 0}, b{0, 0, 0};  // cylinder, cone: ends (cone: base, tip); ball: centre a; box: centre a, half edges b
  double radius = 0;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // of a box
  std::vector<Eigen::Vector3d> outline;                // of a plate: convex polygon at mid-thickness, `radius` its thickness
  Color color;        // alpha below 1: a ghost, whose nearest surface lies over what is behind; it casts no shadow
  float through = 0;  // opacity of what other solids hide of it: 0 not seen, 1 as if nothing were in front
  int body = 0;       // that carries it; of what belongs to none, as arrows and frames, without meaning
};

std::array<Eigen::Vector3d, 8> corners(const Solid& box);  // neighbours differ by one bit of the index

struct Polyline {
  std::vector<Eigen::Vector3d> points;
  Color color;
  double width;       // [px] of the final picture
  float through = 0;  // as of a solid
};

struct Label {
  Eigen::Vector3d at;
  std::string text;  // "A1": letters then digits are set as a subscript
  Color color;
  double clear = 0;       // [m] radius of what stands there and is not to be covered
  bool optional = false;  // left out where there is no room close by that no other label wants
};

struct Bounds {
  Eigen::Vector3d low{0, 0, 0}, high{0, 0, 0};
  bool empty = true;
  std::vector<Eigen::Vector3d> extremes;  // the point that reaches farthest, for each of a fixed set of directions
  void include(const Eigen::Vector3d& p, double margin = 0);
};

struct Surface {  // seen from both sides; casts no shadow
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<int, 3>> triangles;
  Color color;  // translucent where its alpha is below 1
};

struct Scene {
  std::vector<Solid> solids;
  std::vector<Surface> surfaces;
  std::vector<Polyline> lines;
  std::vector<Label> labels;
  double ground = 0;  // height of the ground plane, with grid and shadow [m]
  double grid = 0.1;  // grid spacing [m]
};

struct Camera {  // orthographic by default: lengths compare across pictures of a report
  Eigen::Vector3d target{0, 0, 0};
  double azimuth = 0, elevation = 0;  // [rad]; azimuth 0 looks along +Y (front), 90° looks along -X (from the right side)
  double height = 1;                  // of the visible window at the target [m]
};

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // rows from the top, straight alpha
};

struct Quality {
  int width = 1600, height = 1200;
  bool transparent = false;  // else white
  int supersample = 2;       // and 4x multisampling
  double printed = 85;       // [mm] width on paper, at which labels are 7 pt: half a page where not told
};

// A screw: its axis through a point, as a long line, with an arrow along it (pitch infinite: a translation or a couple), around it (pitch
// zero: a rotation or a force) or both.
struct Screw {
  Eigen::Vector3d point{0, 0, 0}, direction{0, 0, 1};  // [m], unit
  double pitch = 0;                                    // [m]; infinite: along only
  std::string label;
  Color color;
};

// A force that is drawn at a joint's centre, to the scale of the load, and is seen through bodies.
struct JointForce {
  int joint = 0;
  Eigen::Vector3d force{0, 0, 0};  // [N], base axes
  std::string label;               // empty: none
};

// What else is drawn at a snapshot.
struct Extras {
  std::vector<Eigen::Vector3d> path;                // of the platform's reference point over the motion
  Eigen::Vector3d force{0, 0, 0}, moment{0, 0, 0};  // applied to the platform, drawn as an arrow, a curved arrow
  double full_force = 0, full_moment = 0;           // [N], [N m] for which they are drawn full size; zero: for their own
  std::string force_label = "F", moment_label = "M";
  bool labels = true, joint_names = true, frames = true;  // without labels nothing has a name
  std::vector<std::string> drives;                        // names of the actuators, where they are not to be those of the topology
  float base_opacity = 1;                                 // below 1: the base is a ghost, that hides nothing
  std::vector<JointForce> joint_forces;
  std::vector<Screw> screws;
  std::vector<Surface> surfaces;
  std::vector<Polyline> lines;
};

// The scene of one pose: base, platform, bodies by their shapes or joints, joints by kind (ball, hinge with its axis, cross), labels by
// joint name, frames O and o. What an actuator moves has the colour that plots give its curves, and its name beside it.
Scene build(const mechanics::Machine& machine, const mechanics::Pose& pose, const Extras& extras);
constexpr double longest_force = 0.25;                   // of the overall size: the arrow of the full force
double overall_size(const mechanics::Machine& machine);  // mean edge of the box around the joints at home [m]

// Bounds of all that is drawn of a pose; a report includes all its samples, then frames every picture alike.
void include(Bounds& bounds, const mechanics::Machine& machine, const mechanics::Pose& pose);
void include(Bounds& bounds, const mechanics::Machine& machine, const mechanics::Pose& pose, const Screw& screw);  // its drawn part
void include(Bounds& bounds, const Surface& surface);
// A parallel view of all that is in the bounds, with a rim of 7 % of the height all round, from `azimuth` about the base's z axis and
// `elevation` above its xy plane [rad]; `aspect`: width over height of the picture. Of empty bounds the camera as it is made.
Camera frame(const Bounds& bounds, double azimuth, double elevation, double aspect);

// Off-screen rendering; throws std::runtime_error with the reason when OpenGL fails (too large, no memory).
Image render(const Scene& scene, const Camera& camera, const Quality& quality);
std::string to_png(const Image& image);  // same bytes every time

// Where a point appears [px from the top left], and which label boxes were placed where: for tests.
double label_size(int width, double printed);  // [px] of 7 pt in a picture `width` [px], printed that wide [mm]
Eigen::Vector2d project(const Camera& camera, const Eigen::Vector3d& point, int width, int height);
struct PlacedLabel {
  std::string text;
  double x, y, width, height;  // box [px], top left corner
};
std::vector<PlacedLabel> place_labels(const Scene& scene, const Camera& camera, const Quality& quality);

}  // namespace pmreport::scene
