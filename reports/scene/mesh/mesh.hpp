// Solids, lines and surfaces as triangles in the coordinates of a view, fine enough that no facet shows at that scale.
#pragma once

#include <array>
#include <cstdint>
#include <reports/scene/view.hpp>
#include <vector>

namespace pmreport::scene {

struct Vertex {
  std::array<float, 3> position;      // of the view [px]
  std::array<float, 3> normal;        // right, up, towards the viewer; zero: shown in its plain colour (lines)
  std::array<std::uint8_t, 4> color;  // sRGB; alpha counts on ghosts and surfaces
};

// The triangles of one solid, ghost, line or surface, or of all translucent surfaces, and the part of the picture they can touch.
struct Part {
  std::uint32_t first = 0, count = 0;                                        // of the indices
  float left = 0, top = 0, right = 0, bottom = 0;                            // [px]
  float near = 0, far = 0;                                                   // depth [px], near >= far
  enum class Kind { solid, ghost, line, surface, film } kind = Kind::solid;  // film: of translucent surfaces, the farthest triangle first
  float through = 0;                                                         // opacity where hidden
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<Part> parts;
  std::size_t shadow_vertices = 0;  // those of solids and lines come first
};

Mesh tessellate(const Scene& scene, const View& view);

}  // namespace pmreport::scene
