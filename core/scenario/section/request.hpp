// The sections that a scenario asks for.
#pragma once

#include <Eigen/Core>
#include <core/scenario/measured.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

struct View {
  std::string name;           // "isometric", "front", "side", "top", or "azimuth 30°, elevation 20°"
  double azimuth, elevation;  // of the camera as seen from the platform [rad]; front looks along +Y
};

// A map of det G over two coordinates.
struct MapRequest {
  int coordinate[2] = {0, 1};  // indices
  double from[2] = {0, 0}, to[2] = {0, 0};
  Eigen::VectorXd at;  // the other coordinates; home unless given
  int points = 61;     // along each
};

// One line of a comparison with published values.
struct ComparisonRow {
  enum class Expected { nothing, reproduces, differs } expected = Expected::nothing;  // a gate, unless nothing
  std::string what;
  Measured here;
  double published = 0, tolerance = 0;  // SI
  std::string source, note;             // may be empty
  int line = 0;
};

// The options of a section, by kind. A section has its kind's options only; the rest stays at its default.
struct SectionRequest {
  std::string kind;   // "mechanism", "snapshots", "displacement", ... (see section.cpp)
  std::string title;  // empty: the kind's own
  int line = 0;
  // snapshots
  std::vector<double> times;        // [s]
  std::vector<View> views;          // default: isometric
  int width = 1600, height = 1200;  // [px]
  bool transparent = false;         // else white ground
  bool path = true, labels = true, frames = true, load = true;
  // mobility
  int random_poses = 100;
  // singularity
  std::optional<double> length;        // [m] makes moments comparable with forces; default: the characteristic length
  std::vector<Eigen::VectorXd> poses;  // coordinates, besides those of the motion
  std::optional<MapRequest> map;
  // assembly: actuator values at a time of the motion, unless given
  double time = 0;            // [s]
  Eigen::VectorXd actuators;  // SI; empty: those at `time`
  bool working_modes = true;  // with every word of the choices of working mode, else as the scenario sets them
  // dynamics: mass matrix, Coriolis and gravity terms at these times
  std::vector<double> equations;  // [s]
  // reactions: the joints whose reactions are drawn; empty: those with the largest
  std::vector<int> joints;
  // comparison
  std::string source;  // of all rows; may be empty
  std::vector<ComparisonRow> rows;
};

// Largest number of poses of a section singularity.
inline constexpr std::size_t most_poses = 100;

}  // namespace pmreport::scenario
