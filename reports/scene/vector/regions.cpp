#include <cmath>
#include <reports/scene/vector/regions.hpp>

namespace pmreport::scene {

namespace {

Region combined(ClipperLib::ClipType how, const Region& subject, const Region& clip) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(subject, ClipperLib::ptSubject, true);
  clipper.AddPaths(clip, ClipperLib::ptClip, true);
  Region out;
  clipper.Execute(how, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return out;
}

}  // namespace

ClipperLib::Path rounded(const Polygon& p) {
  ClipperLib::Path path;
  path.reserve(p.size());
  for (const Eigen::Vector2d& q : p) {
    const ClipperLib::IntPoint point(std::llround(q.x() * fine), std::llround(q.y() * fine));
    if (path.empty() || path.back() != point) path.push_back(point);
  }
  while (path.size() > 1 && path.front() == path.back()) path.pop_back();
  return path;
}

Region united(const Region& parts) { return combined(ClipperLib::ctUnion, parts, {}); }

Region difference(const Region& from, const Region& less) { return combined(ClipperLib::ctDifference, from, less); }

Region intersection(const Region& a, const Region& b) { return combined(ClipperLib::ctIntersection, a, b); }

Region tidy(const Region& r, double near) {
  constexpr double speck = 0.4;  // [px²]
  Region out;
  for (const ClipperLib::Path& path : r) {
    ClipperLib::Path clean;
    ClipperLib::CleanPolygon(path, clean, near * fine);
    if (clean.size() >= 3 && std::abs(ClipperLib::Area(clean)) > speck * fine * fine) out.push_back(std::move(clean));
  }
  return out;
}

Region grown(const Region& r, double by) {
  ClipperLib::ClipperOffset offset;
  offset.AddPaths(r, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  Region out;
  offset.Execute(out, by * fine);
  return out;
}

Region closed(const Region& parts) {
  constexpr double hair = 0.2;  // [px]
  return grown(grown(parts, hair), -hair);
}

double area(const Region& r) {
  double sum = 0;
  for (const ClipperLib::Path& path : r) sum += ClipperLib::Area(path);
  return sum / (fine * fine);
}

}  // namespace pmreport::scene
