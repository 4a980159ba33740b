#include <reports/section/workspace/surface.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>

namespace pmreport::section {

namespace {

using Eigen::Vector3d;
using Index = std::array<std::size_t, 3>;

// A cube falls into six tetrahedra, one for each order in which its axes can be walked from its first corner to its last (Freudenthal
// 1942, Kuhn 1960): neighbouring cubes cut the face between them along the same diagonal. In a tetrahedron the values are linear, and where
// they are zero is one triangle or two. The values count as differing from zero at every corner, so the surface has no place at which more
// than two triangles meet in an edge.
constexpr std::array<std::array<int, 3>, 6> walks{{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

constexpr double nearest = 1e-3;  // of an edge: the surface keeps so far from its ends, or triangles would shrink to nothing

// Where on an edge from a point inside to one outside the set ends: where the first of its margins is zero. The least of them, taken by
// itself, would bend towards the grid wherever one margin takes over from another.
double share_of(const std::vector<const std::vector<double>*>& margins, std::size_t in, std::size_t out) {
  double share = 1;
  for (const std::vector<double>* margin : margins) {
    const double a = (*margin)[in], b = (*margin)[out];
    if (b < 0) share = std::min(share, std::isfinite(a / (a - b)) ? a / (a - b) : 0.5);
  }
  return share < 1 ? std::clamp(share, nearest, 1 - nearest) : 0.5;  // only numbers that are missing are outside
}

class Mesher {
 public:
  Mesher(const std::vector<scan::Axis>& axes, std::vector<const std::vector<double>*> margins)
      : axes_(axes), margins_(std::move(margins)), inside_(margins_.front()->size(), true) {
    for (std::size_t m = 0; m < margins_.size(); ++m)
      for (std::size_t k = 0; k < inside_.size(); ++k)
        if (!((*margins_[m])[k] >= 0)) inside_[k] = false;
    for (const scan::Axis& a : axes) turns_ = (a.step() < 0) != turns_;
  }

  scene::Surface mesh() {
    const Index last{axes_[0].count - 1, axes_[1].count - 1, axes_[2].count - 1};
    for (std::size_t i = 0; i < last[0]; ++i)
      for (std::size_t j = 0; j < last[1]; ++j)
        for (std::size_t k = 0; k < last[2]; ++k)
          for (const auto& walk : walks) {
            std::array<Index, 4> corner;
            corner.fill({i, j, k});
            for (std::size_t n = 0; n < 3; ++n)
              for (std::size_t m = n + 1; m < 4; ++m) ++corner[m][static_cast<std::size_t>(walk[n])];
            cut(corner);
          }
    for (std::size_t axis = 0; axis < 3; ++axis) close_face(axis, 0), close_face(axis, last[axis]);
    return std::move(out_);
  }

 private:
  const std::vector<scan::Axis>& axes_;
  std::vector<const std::vector<double>*> margins_;
  std::vector<bool> inside_;
  bool turns_ = false;  // an odd number of axes runs downward, which mirrors the grid
  scene::Surface out_;
  std::unordered_map<std::uint64_t, int> numbers_;  // of the surface's points, by the two grid points between which they lie

  std::uint64_t number(const Index& at) const { return (at[0] * axes_[1].count + at[1]) * axes_[2].count + at[2]; }
  bool inside(const Index& at) const { return inside_[number(at)]; }
  Vector3d place(const Index& at) const { return {axes_[0].value(at[0]), axes_[1].value(at[1]), axes_[2].value(at[2])}; }
  static Vector3d step(const Index& at) { return {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])}; }

  int point(const Index& in, const Index& out, double share) {
    const auto [at, fresh] = numbers_.try_emplace(number(in) * inside_.size() + number(out), static_cast<int>(out_.points.size()));
    if (fresh) out_.points.push_back(place(in) + share * (place(out) - place(in)));
    return at->second;
  }
  int on_edge(const Index& in, const Index& out) { return point(in, out, share_of(margins_, number(in), number(out))); }
  int at_corner(const Index& in) { return point(in, in, 0); }

  // The corners in the order that shows `outward`, steps of the grid, the front.
  void triangle(std::array<int, 3> t, const std::array<Vector3d, 3>& steps, const Vector3d& outward) {
    const bool front = (steps[1] - steps[0]).cross(steps[2] - steps[0]).dot(outward) > 0;
    if (front == turns_) std::swap(t[1], t[2]);
    out_.triangles.push_back(t);
  }

  // The middle of an edge stands for the point on it: which side of a triangle is outside does not depend on where on the edges it is.
  void cut(const std::array<Index, 4>& corner) {
    std::vector<Index> in, out;
    for (const Index& c : corner) (inside(c) ? in : out).push_back(c);
    if (in.empty() || out.empty()) return;
    Vector3d outward = Vector3d::Zero();
    for (const Index& c : out) outward += step(c) / static_cast<double>(out.size());
    for (const Index& c : in) outward -= step(c) / static_cast<double>(in.size());
    std::vector<std::array<Index, 2>> edges;
    if (in.size() == 2)  // four edges, round about
      edges = {{in[0], out[0]}, {in[0], out[1]}, {in[1], out[1]}, {in[1], out[0]}};
    else
      for (const Index& a : in)
        for (const Index& b : out) edges.push_back({a, b});
    for (std::size_t k = 1; k + 1 < edges.size(); ++k) {
      std::array<int, 3> t;
      std::array<Vector3d, 3> steps;
      const std::array<std::size_t, 3> use{0, k, k + 1};
      for (std::size_t n = 0; n < 3; ++n) {
        const auto& [a, b] = edges[use[n]];
        t[n] = on_edge(a, b), steps[n] = (step(a) + step(b)) / 2;
      }
      triangle(t, steps, outward);
    }
  }

  // Where the set reaches the end of the grid it ends there: the part of the face that is inside, triangle by triangle of the tetrahedra.
  void close_face(std::size_t axis, std::size_t layer) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Vector3d outward = Vector3d::Zero();
    outward[static_cast<Eigen::Index>(axis)] = layer == 0 ? -1 : 1;
    for (std::size_t a = 0; a + 1 < axes_[u].count; ++a)
      for (std::size_t b = 0; b + 1 < axes_[v].count; ++b) {
        std::array<Index, 4> corner;
        for (std::size_t n = 0; n < 4; ++n) corner[n][axis] = layer, corner[n][u] = a + (n & 1), corner[n][v] = b + (n >> 1);
        close({corner[0], corner[1], corner[3]}, outward);
        close({corner[0], corner[2], corner[3]}, outward);
      }
  }

  void close(const std::array<Index, 3>& corner, const Vector3d& outward) {
    std::vector<int> polygon;
    std::vector<Vector3d> steps;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index &here = corner[k], &next = corner[(k + 1) % 3];
      if (inside(here)) polygon.push_back(at_corner(here)), steps.push_back(step(here));
      if (inside(here) != inside(next)) {
        polygon.push_back(inside(here) ? on_edge(here, next) : on_edge(next, here));
        steps.push_back((step(here) + step(next)) / 2);
      }
    }
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
      triangle({polygon[0], polygon[k], polygon[k + 1]}, {steps[0], steps[k], steps[k + 1]}, outward);
  }
};

scene::Surface surface_of(const std::vector<scan::Axis>& axes, const std::vector<const std::vector<double>*>& margins) {
  if (axes.size() != 3) throw std::invalid_argument("expected a grid of three axes for a surface, saw " + std::to_string(axes.size()));
  std::size_t points = 1;
  for (const scan::Axis& a : axes) {
    if (a.count < 2) throw std::invalid_argument("expected two values or more on each axis for a surface, saw one");
    points *= a.count;
  }
  if (margins.empty()) throw std::invalid_argument("expected a margin or more for a surface, saw none");
  for (const std::vector<double>* margin : margins)
    if (margin->size() != points)
      throw std::invalid_argument("expected " + std::to_string(points) + " values for a surface, saw " + std::to_string(margin->size()));
  return Mesher(axes, margins).mesh();
}

}  // namespace

scene::Surface boundary_surface(const std::vector<scan::Axis>& axes, const std::vector<double>& value) {
  return surface_of(axes, {&value});
}

scene::Surface boundary_surface(const scan::Field& field, const std::vector<double>& rounding) {
  std::vector<std::vector<double>> margins = field.margins;
  std::vector<const std::vector<double>*> all;
  for (std::size_t m = 0; m < margins.size(); ++m) {
    for (double& x : margins[m]) x += rounding.at(m);
    all.push_back(&margins[m]);
  }
  return surface_of(field.axes, all);
}

// About a point of the surface: volumes of tetrahedra about a far one would cancel.
double enclosed_volume(const scene::Surface& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles) {
    const auto at = [&](std::size_t k) { return Vector3d(surface.points[static_cast<std::size_t>(t[k])] - surface.points.front()); };
    sum += at(0).dot(at(1).cross(at(2))) / 6;
  }
  return sum;
}

}  // namespace pmreport::section
