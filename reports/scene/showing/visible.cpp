#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <reports/scene/showing/visible.hpp>
#include <reports/scene/view.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

class Canvas {
 public:
  Canvas(const View& view, int parts, int width, int height)
      : view_(view),
        width_(width),
        height_(height),
        depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -std::numeric_limits<double>::infinity()),
        front_(depth_.size(), -1),
        counted_(depth_.size() * static_cast<std::size_t>(parts), 0),
        counts_(static_cast<std::size_t>(parts)) {}

  void add(const Solid& s, int part) {
    part_ = part;
    switch (s.kind) {
      case Solid::Kind::ball:
        rod(s.a, s.a, s.radius, s.radius);
        break;
      case Solid::Kind::cylinder:
        rod(s.a, s.b, s.radius, s.radius);
        break;
      case Solid::Kind::cone:
        rod(s.a, s.b, s.radius, 0);
        break;
      case Solid::Kind::box:
        box(s);
        break;
      case Solid::Kind::plate:
        plate(s);
        break;
    }
  }

  std::vector<Visible> counts() {
    for (const int part : front_)
      if (part >= 0) ++counts_[static_cast<std::size_t>(part)].seen;
    return counts_;
  }

 private:
  void put(int x, int y, double depth) {
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    if (part_ >= 0) {
      char& was = counted_[at * counts_.size() + static_cast<std::size_t>(part_)];
      if (was == 0) was = 1, ++counts_[static_cast<std::size_t>(part_)].alone;
    }
    if (depth > depth_[at]) depth_[at] = depth, front_[at] = part_;
  }

  struct Range {
    int first, last;
  };
  static Range pixels(double low, double high, int size) {  // whose centres lie between
    return {std::max(0, static_cast<int>(std::ceil(low - 0.5))), std::min(size - 1, static_cast<int>(std::floor(high - 0.5)))};
  }

  // A bar with round ends: as near to the eye as a cylinder at this scale.
  void rod(const Vector3d& from, const Vector3d& to, double radius_from, double radius_to) {
    const Vector3d a = view_.see(from), b = view_.see(to);
    const double ra = std::max(0.5, radius_from * view_.scale()), rb = std::max(0.5, radius_to * view_.scale()), r = std::max(ra, rb);
    const Vector2d along = (b - a).head<2>();
    const double square = along.squaredNorm();
    const Range rows = pixels(std::min(a.y(), b.y()) - r, std::max(a.y(), b.y()) + r, height_);
    const Range columns = pixels(std::min(a.x(), b.x()) - r, std::max(a.x(), b.x()) + r, width_);
    for (int y = rows.first; y <= rows.last; ++y)
      for (int x = columns.first; x <= columns.last; ++x) {
        const Vector2d p(x + 0.5, y + 0.5);
        const double s = square > 0 ? std::clamp((p - a.head<2>()).dot(along) / square, 0.0, 1.0) : a.z() > b.z() ? 0.0 : 1.0;
        const double here = ra + s * (rb - ra), off = (p - a.head<2>() - s * along).squaredNorm();
        if (off <= here * here) put(x, y, a.z() + s * (b.z() - a.z()) + std::sqrt(here * here - off));
      }
  }

  // A convex polygon in space, in either sense.
  void polygon(const std::vector<Vector3d>& points) {
    if (points.size() < 3) return;
    std::vector<Vector3d> seen;
    for (const Vector3d& p : points) seen.push_back(view_.see(p));
    Vector3d normal = Vector3d::Zero(), low = seen[0], high = seen[0];
    for (std::size_t i = 0; i < seen.size(); ++i) {
      normal += (seen[i] - seen[0]).cross(seen[(i + 1) % seen.size()] - seen[0]);
      low = low.cwiseMin(seen[i]), high = high.cwiseMax(seen[i]);
    }
    if (std::abs(normal.z()) < 1e-9 * normal.norm() || normal.z() == 0) return;  // on edge
    const Range rows = pixels(low.y(), high.y(), height_);
    for (int y = rows.first; y <= rows.last; ++y) {
      const double level = y + 0.5;
      double left = std::numeric_limits<double>::infinity(), right = -left;
      for (std::size_t i = 0; i < seen.size(); ++i) {
        const Vector3d &a = seen[i], &b = seen[(i + 1) % seen.size()];
        if ((a.y() - level) * (b.y() - level) > 0 || a.y() == b.y()) continue;
        const double x = a.x() + (level - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        left = std::min(left, x), right = std::max(right, x);
      }
      if (!(left <= right)) continue;
      const Range columns = pixels(left, right, width_);
      for (int x = columns.first; x <= columns.last; ++x)
        put(x, y, seen[0].z() - (normal.x() * (x + 0.5 - seen[0].x()) + normal.y() * (level - seen[0].y())) / normal.z());
    }
  }

  void box(const Solid& s) {
    const auto c = corners(s);
    for (const std::size_t axis : {1U, 2U, 4U})
      for (const std::size_t side : {std::size_t{0}, axis}) {
        const std::size_t u = axis == 1 ? 2 : 1, v = axis == 4 ? 2 : 4;
        polygon({c[side], c[side | u], c[side | u | v], c[side | v]});
      }
  }

  void plate(const Solid& s) {
    if (s.outline.size() < 3) return;
    Vector3d area = Vector3d::Zero();
    for (std::size_t i = 0; i < s.outline.size(); ++i)
      area += (s.outline[i] - s.outline[0]).cross(s.outline[(i + 1) % s.outline.size()] - s.outline[0]);
    if (!(area.norm() > 0)) return;
    const Vector3d half = s.radius / 2 * area.normalized();
    std::vector<Vector3d> top, bottom;
    for (const Vector3d& p : s.outline) top.push_back(p + half), bottom.push_back(p - half);
    polygon(top), polygon(bottom);
    for (std::size_t i = 0; i < top.size(); ++i) {
      const std::size_t j = (i + 1) % top.size();
      polygon({top[i], top[j], bottom[j], bottom[i]});
    }
  }

  const View& view_;
  int width_, height_, part_ = -1;
  std::vector<double> depth_;
  std::vector<int> front_;
  std::vector<char> counted_;  // pixel by part: whether it has been counted
  std::vector<Visible> counts_;
};

}  // namespace

std::vector<Visible> visible(const Scene& scene, const std::vector<int>& part, int parts, const Camera& camera, int width, int height) {
  const View view(camera, width, height);
  Canvas canvas(view, parts, width, height);
  for (std::size_t k = 0; k < scene.solids.size(); ++k)
    if (part[k] >= -1) canvas.add(scene.solids[k], part[k]);
  return canvas.counts();
}

}  // namespace pmreport::scene
