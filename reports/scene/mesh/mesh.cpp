#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <core/numbers.hpp>
#include <limits>
#include <reports/scene/mesh/mesh.hpp>
#include <reports/scene/mesh/surfaces.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Edges are rounded a little: they catch the light as real ones do, and one normal per vertex then serves for shading and for the outline.
constexpr double bevel_share = 0.08;  // of the thickness or radius
constexpr double bevel_max = 2.5;     // [px]

// A regular n-gon leaves its circle of radius r by r (1 - cos(pi/n)), about r pi^2 / (2 n^2).
int segments_of(double radius_px) {
  constexpr double deviation = 0.10;  // [px]
  const double n = pi * std::sqrt(std::max(radius_px, 1.0) / (2 * deviation));
  return std::clamp(4 * static_cast<int>(std::ceil(n / 4)), 12, 160);
}

struct Ring {             // of a surface of revolution
  double radius, height;  // [m]
  double outward, along;  // normal
};

class Mesher {
 public:
  Mesher(const View& view, Mesh& mesh) : view_(view), mesh_(mesh) {}

  void add(const Solid& solid) {
    begin(solid.color);
    switch (solid.kind) {
      case Solid::Kind::cylinder:
        cylinder(solid);
        break;
      case Solid::Kind::cone:
        cone(solid);
        break;
      case Solid::Kind::ball:
        ball(solid);
        break;
      case Solid::Kind::box:
        box(solid);
        break;
      case Solid::Kind::plate:
        plate(solid.outline, solid.radius);
        break;
    }
    end(solid.color.a < 1 ? Part::Kind::ghost : Part::Kind::solid, solid.through);
  }

  void add(const Polyline& line) {
    begin(line.color);
    ribbon(line);
    end(Part::Kind::line, line.through);
  }

 private:
  void begin(const Color& c) {
    const auto byte = [](float x) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0f, 1.0f))); };
    color_ = {byte(c.r), byte(c.g), byte(c.b), byte(c.a)};
    first_index_ = mesh_.indices.size();
    first_vertex_ = mesh_.vertices.size();
  }

  void end(Part::Kind kind, float through) {
    if (mesh_.indices.size() == first_index_) return;
    constexpr float inf = std::numeric_limits<float>::infinity();
    Part part{static_cast<std::uint32_t>(first_index_),
              static_cast<std::uint32_t>(mesh_.indices.size() - first_index_),
              inf,
              inf,
              -inf,
              -inf,
              -inf,
              inf,
              kind,
              through};
    for (std::size_t i = first_vertex_; i < mesh_.vertices.size(); ++i) {
      const auto& p = mesh_.vertices[i].position;
      part.left = std::min(part.left, p[0]), part.right = std::max(part.right, p[0]);
      part.top = std::min(part.top, p[1]), part.bottom = std::max(part.bottom, p[1]);
      part.far = std::min(part.far, p[2]), part.near = std::max(part.near, p[2]);
    }
    mesh_.parts.push_back(part);
  }

  std::uint32_t vertex_seen(const Vector3d& seen, const Vector3d& normal) {
    const auto triple = [](const Vector3d& v) {
      return std::array<float, 3>{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
    };
    mesh_.vertices.push_back({triple(seen), triple(normal), color_});
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }
  std::uint32_t vertex(const Vector3d& point, const Vector3d& normal) { return vertex_seen(view_.see(point), view_.turn(normal)); }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_.indices.insert(mesh_.indices.end(), {a, b, c}); }

  // Joins two loops of n vertices each that start at `lower` and `upper`; counter-clockwise seen from outside.
  void band(std::uint32_t lower, std::uint32_t upper, std::uint32_t n) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      triangle(lower + i, lower + j, upper + j);
      triangle(lower + i, upper + j, upper + i);
    }
  }

  void revolve(const Vector3d& base, const Vector3d& axis, const std::vector<Ring>& rings, int segments) {
    const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
    std::uint32_t before = 0;
    for (std::size_t k = 0; k < rings.size(); ++k) {
      const Ring& ring = rings[k];
      const auto start = static_cast<std::uint32_t>(mesh_.vertices.size());
      for (int i = 0; i < segments; ++i) {
        const double angle = 2 * pi * i / segments;
        const Vector3d radial = std::cos(angle) * u + std::sin(angle) * v;
        vertex(base + ring.radius * radial + ring.height * axis, ring.outward * radial + ring.along * axis);
      }
      if (k > 0) band(before, start, static_cast<std::uint32_t>(segments));
      before = start;
    }
  }

  double bevel(double size) const { return std::min(bevel_share * size, bevel_max / view_.scale()); }

  void cylinder(const Solid& s) {
    const Vector3d along = s.b - s.a;
    const double length = along.norm();
    if (!(length > 0) || !(s.radius > 0)) return;
    const double r = s.radius, c = bevel(std::min(2 * r, length));
    revolve(s.a, along / length,
            {{0, 0, 0, -1}, {r - c, 0, 0, -1}, {r, c, 1, 0}, {r, length - c, 1, 0}, {r - c, length, 0, 1}, {0, length, 0, 1}},
            segments_of(r * view_.scale()));
  }

  void cone(const Solid& s) {
    const Vector3d along = s.b - s.a;
    const double length = along.norm();
    if (!(length > 0) || !(s.radius > 0)) return;
    const double r = s.radius, slant = std::hypot(r, length), outward = length / slant, up = r / slant;
    revolve(s.a, along / length, {{0, 0, 0, -1}, {0.97 * r, 0, 0, -1}, {r, 0.03 * length, outward, up}, {0, length, outward, up}},
            segments_of(r * view_.scale()));
  }

  void ball(const Solid& s) {
    if (!(s.radius > 0)) return;
    const int segments = segments_of(s.radius * view_.scale()), levels = segments / 2;
    std::vector<Ring> rings;
    for (int k = 0; k <= levels; ++k) {
      const double latitude = pi * k / levels, across = std::sin(latitude), along = -std::cos(latitude);
      rings.push_back({s.radius * across, s.radius * along, across, along});
    }
    revolve(s.a, Vector3d::UnitZ(), rings, segments);
  }

  void box(const Solid& s) {
    if (!(s.b.array() > 0).all()) return;
    const Vector3d x = s.b.x() * s.axes.col(0), y = s.b.y() * s.axes.col(1);
    plate({s.a - x - y, s.a + x - y, s.a + x + y, s.a - x + y}, 2 * s.b.z(), 2 * std::min(s.b.x(), s.b.y()));
  }

  // A convex polygon of nonzero area, with its corners rounded where they are sharp, given thickness. `width`: of a slim one, whose bevels
  // must not meet.
  void plate(const std::vector<Vector3d>& outline, double thickness, double width = std::numeric_limits<double>::infinity()) {
    if (outline.size() < 3 || !(thickness > 0)) return;
    Vector3d area = Vector3d::Zero(), middle = Vector3d::Zero();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      area += (outline[i] - outline[0]).cross(outline[(i + 1) % outline.size()] - outline[0]);
      middle += outline[i] / static_cast<double>(outline.size());
    }
    if (!(area.norm() > 0)) return;
    const Vector3d up = area.normalized(), u = up.unitOrthogonal(), v = up.cross(u);
    std::vector<Vector2d> flat;
    for (const Vector3d& p : outline) flat.emplace_back(u.dot(p - middle), v.dot(p - middle));
    const double c = std::min(bevel(thickness), width / 5), half = thickness / 2;
    const auto [rim, normals] = rounded(flat, 1.5 * c);
    const auto ring = [&](double inset, double height, bool flat_normal) {
      const auto start = static_cast<std::uint32_t>(mesh_.vertices.size());
      for (std::size_t i = 0; i < rim.size(); ++i) {
        const Vector2d p = rim[i] - inset * normals[i];
        const Vector3d n = flat_normal ? Vector3d(std::copysign(1, height) * up) : Vector3d(normals[i].x() * u + normals[i].y() * v);
        vertex(middle + p.x() * u + p.y() * v + height * up, n);
      }
      return start;
    };
    const auto n = static_cast<std::uint32_t>(rim.size());
    const std::uint32_t bottom = ring(c, -half, true), low = ring(0, -half + c, false), high = ring(0, half - c, false),
                        top = ring(c, half, true);
    band(bottom, low, n), band(low, high, n), band(high, top, n);
    for (std::uint32_t i = 1; i + 1 < n; ++i) triangle(bottom, bottom + i + 1, bottom + i), triangle(top, top + i, top + i + 1);
  }

  // Corners of more than 20° become arcs of radius r (less where an edge is short); the rest keep one vertex with the mean normal.
  static std::pair<std::vector<Vector2d>, std::vector<Vector2d>> rounded(const std::vector<Vector2d>& polygon, double r) {
    std::vector<Vector2d> rim, normals;
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vector2d &before = polygon[(i + n - 1) % n], &at = polygon[i], &after = polygon[(i + 1) % n];
      const double shortest = std::min((at - before).norm(), (after - at).norm());
      if (!(shortest > 0)) continue;
      const Vector2d in = (at - before).normalized(), out = (after - at).normalized();
      const Vector2d n_in(in.y(), -in.x()), n_out(out.y(), -out.x());
      const double turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
      if (turn < pi / 9) {
        rim.push_back(at);
        normals.push_back((n_in + n_out).normalized());
        continue;
      }
      const double radius = std::min(r, 0.4 * shortest / std::tan(turn / 2));
      const Vector2d centre = at - radius / std::cos(turn / 2) * (n_in + n_out).normalized();
      const int steps = std::max(2, static_cast<int>(std::ceil(turn / (pi / 12))));
      for (int k = 0; k <= steps; ++k) {
        const double angle = turn * k / steps;
        const Vector2d normal = std::cos(angle) * n_in + std::sin(angle) * in;
        rim.push_back(centre + radius * normal);
        normals.push_back(normal);
      }
    }
    return {rim, normals};
  }

  // A line is a ribbon that faces the viewer, with discs at its points to join the pieces. It lies a little nearer than what it is drawn
  // on.
  void ribbon(const Polyline& line) {
    const double half = line.width / 2, lift = 1.5 + half;
    const Vector3d none = Vector3d::Zero();
    std::vector<Vector3d> seen;
    for (const Vector3d& p : line.points) {
      const Vector3d s = view_.see(p) + lift * Vector3d::UnitZ();
      if (s.allFinite() && (seen.empty() || (s - seen.back()).head<2>().norm() > 0.3)) seen.push_back(s);
    }
    if (seen.size() < 2) return;
    for (std::size_t i = 0; i + 1 < seen.size(); ++i) {
      const Vector2d along = (seen[i + 1] - seen[i]).head<2>().normalized();
      const Vector3d across = half * Vector3d(-along.y(), along.x(), 0);
      const std::uint32_t a = vertex_seen(seen[i] + across, none), b = vertex_seen(seen[i] - across, none),
                          c = vertex_seen(seen[i + 1] - across, none), d = vertex_seen(seen[i + 1] + across, none);
      triangle(a, b, c), triangle(a, c, d);
    }
    constexpr int corners = 8;
    for (const Vector3d& s : seen) {
      const std::uint32_t hub = vertex_seen(s, none);
      for (int k = 0; k < corners; ++k)
        vertex_seen(s + half * Vector3d(std::cos(2 * pi * k / corners), -std::sin(2 * pi * k / corners), 0), none);
      for (std::uint32_t k = 0; k < corners; ++k) triangle(hub, hub + 1 + k, hub + 1 + (k + 1) % corners);
    }
  }

  const View& view_;
  Mesh& mesh_;
  std::array<std::uint8_t, 4> color_{};
  std::size_t first_index_ = 0, first_vertex_ = 0;
};

}  // namespace

Mesh tessellate(const Scene& scene, const View& view) {
  Mesh mesh;
  Mesher mesher(view, mesh);
  for (const Solid& s : scene.solids) mesher.add(s);
  for (const Polyline& l : scene.lines) mesher.add(l);
  mesh.shadow_vertices = mesh.vertices.size();
  add_surfaces(scene, view, mesh);
  return mesh;
}

}  // namespace pmreport::scene
