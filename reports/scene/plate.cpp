#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <reports/scene/look.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double standoff = 1.35;    // of the plate's face from the joint centres, in joint radii
constexpr double rim = 1.5;          // of the plate around the joints, in joint radii
constexpr double post_width = 0.62;  // in joint radii

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Andrew's monotone chain; counter-clockwise, without points on the edges.
std::vector<Vector2d> convex_hull(std::vector<Vector2d> p) {
  std::sort(p.begin(), p.end(), [](const Vector2d& a, const Vector2d& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Vector2d> hull(2 * p.size());
  std::size_t n = 0;
  for (const Vector2d& q : p) {
    while (n >= 2 && cross(hull[n - 1] - hull[n - 2], q - hull[n - 2]) <= 0) --n;
    hull[n++] = q;
  }
  const std::size_t lower = n + 1;
  for (auto q = p.rbegin() + 1; q != p.rend(); ++q) {
    while (n >= lower && cross(hull[n - 1] - hull[n - 2], *q - hull[n - 2]) <= 0) --n;
    hull[n++] = *q;
  }
  hull.resize(n - 1);
  return hull;
}

// The plane of least squares through the points, if they lie in one and only one.
bool fit_plane(const std::vector<Carried>& points, Vector3d& normal) {
  constexpr double flat = 0.03, slim = 0.02;  // thickness and width in terms of the length
  Vector3d mean = Vector3d::Zero();
  for (const Carried& c : points) mean += c.at / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Carried& c : points) spread += (c.at - mean) * (c.at - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Vector3d extent = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  if (!(extent(1) > slim * extent(2)) || extent(0) > flat * extent(2)) return false;
  normal = solver.eigenvectors().col(0);
  return true;
}

}  // namespace

Plate make_plate(const std::vector<Carried>& points, const Vector3d& towards, const Vector3d& normal_in_doubt, double thickness,
                 const Color& color) {
  Plate plate;
  if (points.empty()) return plate;
  Vector3d n = normal_in_doubt;
  fit_plane(points, n);
  if (n.dot(towards) < 0) n = -n;
  double face = HUGE_VAL;
  for (const Carried& c : points) face = std::min(face, n.dot(c.at) - standoff * c.radius);

  // The convex hull of a disc about every joint: rounded corners, and a sound shape even for one joint, or for joints in a row.
  constexpr int corners = 64;
  const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
  std::vector<Vector2d> discs;
  for (const Carried& c : points)
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * k / corners;
      discs.emplace_back(u.dot(c.at) + rim * c.radius * std::cos(angle), v.dot(c.at) + rim * c.radius * std::sin(angle));
    }
  Solid slab{Solid::Kind::plate, {0, 0, 0}, {0, 0, 0}, thickness, Eigen::Matrix3d::Identity(), {}, color, 0};
  for (const Vector2d& p : convex_hull(discs)) slab.outline.push_back(p.x() * u + p.y() * v + (face - thickness / 2) * n);
  plate.solids.push_back(std::move(slab));
  for (const Carried& c : points)
    plate.solids.push_back(cylinder(c.at + (face - n.dot(c.at) - thickness / 4) * n, c.at, post_width * c.radius, palette::post));
  plate.normal = n;
  return plate;
}

}  // namespace pmreport::scene
