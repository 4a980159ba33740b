// Models as binary glTF 2.0 (ISO/IEC 12113): what CAD viewers, browsers, Blender and augmented reality open.
#pragma once

#include <reports/scene/scene.hpp>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pmreport::scene {

// Triangles of one colour, counter-clockwise seen from outside. Never empty.
struct Primitive {
  Color color;  // sRGB
  std::vector<std::array<float, 3>> positions, normals;
  std::vector<std::uint32_t> indices;

  bool operator==(const Primitive& other) const;
};

struct ModelNode {
  std::string name;
  int mesh = -1;  // of the model; -1: nothing is to be seen of it
  Eigen::Vector3d translation{0, 0, 0};
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  // unit
};

// How a node moves: one translation and one unit quaternion a time, each quaternion on the side of the one before.
struct ModelTrack {
  int node = 0;
  std::vector<Eigen::Vector3d> translation;
  std::vector<Eigen::Quaterniond> rotation;
};

// Metres, z up, as the machine's base has it.
struct Model {
  std::string name;
  std::vector<std::vector<Primitive>> meshes;
  std::vector<ModelNode> nodes;  // all children of one root, which turns z up into glTF's y up
  std::vector<float> times;      // [s], from zero or later, rising; of all tracks
  std::vector<ModelTrack> tracks;
  int platform = -1;  // the node that carries the load, with the reference point at its origin; -1: none is known to. Kept as "extras"
  double begin = 0;   // [s], of the motion whose times count from here; kept as "extras" where it is not zero
};

// One scene, one material a colour, one animation where there are tracks, between whose keys one goes linearly. The same bytes every time.
std::string to_glb(const Model& model);

}  // namespace pmreport::scene
