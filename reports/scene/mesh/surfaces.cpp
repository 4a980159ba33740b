#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <reports/scene/mesh/surfaces.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector3d;

std::uint8_t byte(float x) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0f, 1.0f))); }

bool sound(const Surface& surface, const std::array<int, 3>& triangle) {
  return std::ranges::all_of(triangle, [&](int k) {
    return k >= 0 && static_cast<std::size_t>(k) < surface.points.size() && surface.points[static_cast<std::size_t>(k)].allFinite();
  });
}

// Of each point: the mean of the normals about it, each by the area of its triangle.
std::vector<Vector3d> normals_of(const Surface& surface) {
  std::vector<Vector3d> normals(surface.points.size(), Vector3d::Zero());
  for (const auto& t : surface.triangles) {
    if (!sound(surface, t)) continue;
    const auto at = [&](int k) { return surface.points[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])]; };
    const Vector3d doubled = (at(1) - at(0)).cross(at(2) - at(0));
    for (const int k : t) normals[static_cast<std::size_t>(k)] += doubled;
  }
  for (Vector3d& n : normals)
    if (const double length = n.norm(); length > 0) n /= length;
  return normals;
}

Part part_from(const Mesh& mesh, std::size_t first_index, Part::Kind kind) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  Part part;
  part.first = static_cast<std::uint32_t>(first_index);
  part.count = static_cast<std::uint32_t>(mesh.indices.size() - first_index);
  part.left = part.top = part.far = inf, part.right = part.bottom = part.near = -inf;
  part.kind = kind;
  for (std::size_t i = first_index; i < mesh.indices.size(); ++i) {
    const auto& p = mesh.vertices[mesh.indices[i]].position;
    part.left = std::min(part.left, p[0]), part.right = std::max(part.right, p[0]);
    part.top = std::min(part.top, p[1]), part.bottom = std::max(part.bottom, p[1]);
    part.far = std::min(part.far, p[2]), part.near = std::max(part.near, p[2]);
  }
  return part;
}

struct Film {
  float depth;
  std::array<std::uint32_t, 3> corners;
};

}  // namespace

void add_surfaces(const Scene& scene, const View& view, Mesh& mesh) {
  std::vector<Film> films;
  for (const Surface& surface : scene.surfaces) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const std::vector<Vector3d> normals = normals_of(surface);
    const std::array<std::uint8_t, 4> color{byte(surface.color.r), byte(surface.color.g), byte(surface.color.b), byte(surface.color.a)};
    for (std::size_t k = 0; k < surface.points.size(); ++k) {
      const Vector3d p = view.see(surface.points[k]), n = view.turn(normals[k]);
      const auto triple = [](const Vector3d& v) {
        return std::array<float, 3>{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
      };
      mesh.vertices.push_back({triple(p), triple(n), color});
    }
    const std::size_t first_index = mesh.indices.size();
    for (const auto& t : surface.triangles) {
      if (!sound(surface, t)) continue;
      std::array<std::uint32_t, 3> corners;
      float depth = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = first + static_cast<std::uint32_t>(t[k]);
        depth += mesh.vertices[corners[k]].position[2];
      }
      if (color[3] == 255)
        mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
      else
        films.push_back({depth, corners});
    }
    if (mesh.indices.size() > first_index) mesh.parts.push_back(part_from(mesh, first_index, Part::Kind::surface));
  }
  std::ranges::stable_sort(films, {}, &Film::depth);
  const std::size_t first_index = mesh.indices.size();
  for (const Film& film : films) mesh.indices.insert(mesh.indices.end(), film.corners.begin(), film.corners.end());
  if (!films.empty()) mesh.parts.push_back(part_from(mesh, first_index, Part::Kind::film));
}

}  // namespace pmreport::scene
