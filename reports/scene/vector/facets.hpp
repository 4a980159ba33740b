// A solid as a vector drawing sees it: the flat faces turned to the viewer, the outline around them, the edges between them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <reports/scene/view.hpp>
#include <vector>

namespace pmreport::scene {

// All in axes right, up, towards the viewer [px]; the picture's rows run down, so that up is minus the row.
using Polygon = std::vector<Eigen::Vector2d>;  // convex, counter-clockwise
using Curve = std::vector<Eigen::Vector3d>;

struct Face {
  Polygon outline;
  Eigen::Vector3d normal;  // unit, towards the viewer
  Eigen::Vector3d slope;   // depth at (x, y): slope · (x, y, 1)
  int side = 0;            // faces of one side are shaded as one: of a cylinder 0 the mantle, 1 the end
  double depth(const Eigen::Vector2d& p) const { return slope.x() * p.x() + slope.y() * p.y() + slope.z(); }
};

struct Facets {
  std::vector<Face> faces;  // of a convex solid the least of their depths is its front, within the outline
  Polygon outline;
  Curve contour;                     // the same in space, closed
  std::vector<Curve> edges;          // between sides that are both seen
  Eigen::Vector2d low, high;         // of the outline
  double nearest = 0, farthest = 0;  // of the front
};

// How many chords a circle of `radius` [px] is drawn with: none leaves it by more than 0.25 px, up to a limit of 48.
int chords(double radius);

// None of a solid without extent, or out of all numbers.
std::optional<Facets> facets_of(const Solid& solid, const View& view);

double area(const Polygon& p);
// The part of a convex polygon where a(x) + b y + c >= 0.
Polygon cut(const Polygon& p, const Eigen::Vector3d& keep);
// The half planes, as for cut(), that bound a convex polygon moved outward by `grown` [px].
std::vector<Eigen::Vector3d> bounds_of(const Polygon& p, double grown);

}  // namespace pmreport::scene
