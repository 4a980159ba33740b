#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <core/numbers.hpp>
#include <map>
#include <reports/scene/vector/facets.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double edge_on = 1e-3;  // a face whose normal has no more than this towards the viewer is not seen
constexpr double farthest = 1e7;  // [px] what reaches beyond is not drawn

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Andrew's monotone chain.
Polygon convex_hull(Polygon p) {
  std::sort(p.begin(), p.end(), [](const Vector2d& a, const Vector2d& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  Polygon hull(2 * p.size());
  std::size_t n = 0;
  const auto add = [&](const Vector2d& q, std::size_t from) {
    while (n >= from + 2 && cross(hull[n - 1] - hull[n - 2], q - hull[n - 2]) <= 1e-9) --n;
    hull[n++] = q;
  };
  for (const Vector2d& q : p) add(q, 0);
  const std::size_t lower = n - 1;
  for (auto q = p.rbegin() + 1; q != p.rend(); ++q) add(*q, lower);
  hull.resize(n - 1);
  return hull;
}

// A closed convex surface of flat faces. An edge belongs to two of them.
struct Polyhedron {
  std::vector<Vector3d> points;
  struct Ring {
    std::vector<int> points;
    int side;
  };
  std::vector<Ring> rings;
};

Vector3d normal_of(const Polyhedron& body, const Polyhedron::Ring& ring) {
  Vector3d sum = Vector3d::Zero();
  const Vector3d& first = body.points[static_cast<std::size_t>(ring.points[0])];
  for (std::size_t k = 1; k + 1 < ring.points.size(); ++k)
    sum += (body.points[static_cast<std::size_t>(ring.points[k])] - first)
               .cross(body.points[static_cast<std::size_t>(ring.points[k + 1])] - first);
  return sum.normalized();
}

// Joins pieces that share ends into the fewest curves.
std::vector<Curve> chained(const Polyhedron& body, std::vector<std::pair<int, int>> pieces) {
  std::vector<Curve> curves;
  while (!pieces.empty()) {
    std::vector<int> chain{pieces.back().first, pieces.back().second};
    pieces.pop_back();
    for (std::size_t k = 0; k < pieces.size();) {
      const auto [a, b] = pieces[k];
      bool joined = true;
      if (a == chain.back())
        chain.push_back(b);
      else if (b == chain.back())
        chain.push_back(a);
      else if (a == chain.front())
        chain.insert(chain.begin(), b);
      else if (b == chain.front())
        chain.insert(chain.begin(), a);
      else
        joined = false;
      if (!joined) {
        ++k;
        continue;
      }
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k));
      k = 0;
    }
    Curve curve;
    for (const int i : chain) curve.push_back(body.points[static_cast<std::size_t>(i)]);
    curves.push_back(std::move(curve));
  }
  return curves;
}

void add_face(Facets& out, Polygon outline, const Vector3d& normal, const Vector3d& through, int side) {
  Face face{std::move(outline), normal, {}, side};
  face.slope << -normal.x() / normal.z(), -normal.y() / normal.z(), normal.dot(through) / normal.z();
  out.faces.push_back(std::move(face));
}

void measure(Facets& out) {
  out.low = out.high = out.outline.front();
  for (const Vector2d& p : out.outline) out.low = out.low.cwiseMin(p), out.high = out.high.cwiseMax(p);
  out.nearest = -HUGE_VAL, out.farthest = HUGE_VAL;
  for (const Face& f : out.faces)
    for (const Vector2d& p : f.outline) out.nearest = std::max(out.nearest, f.depth(p)), out.farthest = std::min(out.farthest, f.depth(p));
}

std::optional<Facets> seen(const Polyhedron& body) {
  for (const Vector3d& p : body.points)
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > farthest) return std::nullopt;
  Facets out;
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& p : body.points) middle += p / static_cast<double>(body.points.size());
  std::vector<bool> front;
  struct Between {
    int rings[2] = {-1, -1};
  };
  std::map<std::pair<int, int>, Between> edges;
  for (std::size_t r = 0; r < body.rings.size(); ++r) {
    const auto& ring = body.rings[r];
    Vector3d normal = normal_of(body, ring);
    if (normal.dot(body.points[static_cast<std::size_t>(ring.points[0])] - middle) < 0) normal = -normal;
    front.push_back(normal.z() > edge_on);
    for (std::size_t k = 0; k < ring.points.size(); ++k) {
      const auto edge = std::minmax(ring.points[k], ring.points[(k + 1) % ring.points.size()]);
      Between& b = edges[edge];
      b.rings[b.rings[0] < 0 ? 0 : 1] = static_cast<int>(r);
    }
    if (!front.back()) continue;
    Polygon outline;
    for (const int i : ring.points) outline.push_back(body.points[static_cast<std::size_t>(i)].head<2>());
    if (area(outline) < 0) std::reverse(outline.begin(), outline.end());
    if (area(outline) < 1e-9) {
      front.back() = false;
      continue;
    }
    add_face(out, std::move(outline), normal, body.points[static_cast<std::size_t>(ring.points[0])], ring.side);
  }
  if (out.faces.empty()) return std::nullopt;
  std::vector<std::pair<int, int>> around, between;
  for (const auto& [edge, b] : edges) {
    if (b.rings[1] < 0) continue;
    const auto one = static_cast<std::size_t>(b.rings[0]), other = static_cast<std::size_t>(b.rings[1]);
    if (front[one] != front[other]) around.push_back(edge);
    if (front[one] && front[other] && body.rings[one].side != body.rings[other].side) between.push_back(edge);
  }
  const std::vector<Curve> contours = chained(body, std::move(around));
  if (contours.empty()) return std::nullopt;
  out.contour = *std::ranges::max_element(contours, {}, &Curve::size);
  out.edges = chained(body, std::move(between));
  Polygon flat;
  for (const Vector3d& p : body.points) flat.push_back(p.head<2>());
  out.outline = convex_hull(std::move(flat));
  if (out.outline.size() < 3) return std::nullopt;
  measure(out);
  return out;
}

// A ring of points about each end, or one about `a` and the tip b. The first point stands where the mantle is seen edge on, so that the
// outline is as wide as the true one.
Polyhedron turned(const Vector3d& a, const Vector3d& b, double radius, bool pointed) {
  const int n = chords(radius);
  const Vector3d d = (b - a).normalized();
  Vector3d u = Vector3d::UnitZ().cross(d);
  u = u.norm() > 1e-9 ? Vector3d(u.normalized()) : Vector3d::UnitX();
  const Vector3d v = d.cross(u);
  Polyhedron body;
  Polyhedron::Ring start{{}, 1}, end{{}, 2};
  for (int k = 0; k < n; ++k) {
    const Vector3d out = radius * (std::cos(2 * pi * k / n) * u + std::sin(2 * pi * k / n) * v);
    body.points.emplace_back(a + out);
    if (!pointed) body.points.emplace_back(b + out);
  }
  if (pointed) body.points.push_back(b);
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    if (pointed) {
      body.rings.push_back({{k, next, n}, 0});
      start.points.insert(start.points.begin(), k);
    } else {
      body.rings.push_back({{2 * k, 2 * next, 2 * next + 1, 2 * k + 1}, 0});
      start.points.insert(start.points.begin(), 2 * k);
      end.points.push_back(2 * k + 1);
    }
  }
  body.rings.push_back(std::move(start));
  if (!pointed) body.rings.push_back(std::move(end));
  return body;
}

Polyhedron box(const std::array<Vector3d, 8>& c) {
  Polyhedron body{{c.begin(), c.end()}, {}};
  body.rings = {{{0, 4, 6, 2}, 0}, {{1, 3, 7, 5}, 1}, {{0, 1, 5, 4}, 2}, {{2, 6, 7, 3}, 3}, {{0, 2, 3, 1}, 4}, {{4, 5, 7, 6}, 5}};
  return body;
}

// The points of a ring of which none is missed by more than 0.25 px.
std::vector<Vector3d> thinned(const std::vector<Vector3d>& ring) {
  constexpr double missed = 0.25;
  std::vector<Vector3d> kept;
  for (std::size_t i = 0; i < ring.size();) {
    kept.push_back(ring[i]);
    std::size_t next = i + 1;
    while (next + 1 < ring.size()) {
      const Vector3d along = (ring[next + 1] - ring[i]).normalized();
      double most = 0;
      for (std::size_t k = i + 1; k <= next; ++k) most = std::max(most, (ring[k] - ring[i]).cross(along).norm());
      if (most > missed) break;
      ++next;
    }
    i = next;
  }
  return kept;
}

Polyhedron slab(std::vector<Vector3d> ring, double thickness) {
  Polyhedron body;
  ring = thinned(ring);
  const int n = static_cast<int>(ring.size());
  if (n < 3) return body;
  Vector3d normal = Vector3d::Zero();
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) normal += (ring[k] - ring[0]).cross(ring[k + 1] - ring[0]);
  normal.normalize();
  Polyhedron::Ring bottom{{}, 1}, top{{}, 2};
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    const Vector3d& p = ring[static_cast<std::size_t>(k)];
    body.points.emplace_back(p - thickness / 2 * normal);
    body.points.emplace_back(p + thickness / 2 * normal);
    body.rings.push_back({{2 * k, 2 * next, 2 * next + 1, 2 * k + 1}, 0});
    bottom.points.insert(bottom.points.begin(), 2 * k);
    top.points.push_back(2 * k + 1);
  }
  body.rings.push_back(std::move(bottom));
  body.rings.push_back(std::move(top));
  return body;
}

// Rings about the line of sight. The corners stand half a sagitta outside, so that faces lie as much outside as inside the ball.
std::optional<Facets> seen_ball(const Vector3d& c, double radius) {
  if (!c.allFinite() || !(radius > 1e-6) || c.cwiseAbs().maxCoeff() + radius > farthest) return std::nullopt;
  Facets out;
  const int n = chords(radius), rows = std::max(4, n / 4);
  const double step = pi / 2 / rows, r = radius * (1 + 0.5 * (1 - std::cos(step / 2)));
  const auto at = [&](int row, int k) {
    const double from_sight = step * row, around = 2 * pi * (k % n) / n;
    return Vector3d(c +
                    r * Vector3d(std::sin(from_sight) * std::cos(around), std::sin(from_sight) * std::sin(around), std::cos(from_sight)));
  };
  Polygon middle;
  for (int k = 0; k < n; ++k) middle.push_back(at(1, k).head<2>());
  add_face(out, std::move(middle), Vector3d::UnitZ(), at(1, 0), 0);
  for (int row = 1; row < rows; ++row)
    for (int k = 0; k < n; ++k) {
      const Vector3d p = at(row, k), q = at(row + 1, k), s = at(row + 1, k + 1), t = at(row, k + 1);
      const Vector3d normal = (q - p).cross(t - p).normalized();
      if (normal.z() > edge_on) add_face(out, {p.head<2>(), q.head<2>(), s.head<2>(), t.head<2>()}, normal, p, 0);
    }
  const int around = std::max(24, n);
  for (int k = 0; k < around; ++k) {
    const double angle = 2 * pi * k / around;
    out.contour.push_back(c + radius * Vector3d(std::cos(angle), std::sin(angle), 0));
    out.outline.push_back(out.contour.back().head<2>());
  }
  out.contour.push_back(out.contour.front());
  measure(out);
  return out;
}

}  // namespace

int chords(double radius) {
  constexpr double missed = 0.25;
  if (!(radius > missed)) return 12;
  const double n = pi / std::acos(1 - missed / radius);
  return 4 * static_cast<int>(std::clamp(std::ceil(n / 4), 3.0, 12.0));
}

double area(const Polygon& p) {
  double doubled = 0;
  for (std::size_t k = 2; k < p.size(); ++k) doubled += cross(p[k - 1] - p[0], p[k] - p[0]);
  return doubled / 2;
}

Polygon cut(const Polygon& p, const Vector3d& keep) {
  const auto height = [&](const Vector2d& q) { return keep.x() * q.x() + keep.y() * q.y() + keep.z(); };
  Polygon out;
  if (p.empty()) return out;
  out.reserve(p.size() + 2);
  Vector2d last = p.back();
  double h_last = height(last);
  for (const Vector2d& q : p) {
    const double h = height(q);
    if ((h < 0) != (h_last < 0)) out.emplace_back(last + (q - last) * (h_last / (h_last - h)));
    if (h >= 0) out.push_back(q);
    last = q, h_last = h;
  }
  return out;
}

std::vector<Vector3d> bounds_of(const Polygon& p, double grown) {
  std::vector<Vector3d> all;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Vector2d &a = p[k], &b = p[(k + 1) % p.size()];
    const double length = (b - a).norm();
    if (length < 1e-9) continue;
    const Vector2d inward = Vector2d(a.y() - b.y(), b.x() - a.x()) / length;
    all.emplace_back(inward.x(), inward.y(), grown - inward.dot(a));
  }
  return all;
}

std::optional<Facets> facets_of(const Solid& s, const View& view) {
  const double scale = view.scale(), r = s.radius * scale;
  const auto at = [&](const Vector3d& p) {
    const Vector3d q = view.see(p);
    return Vector3d(q.x(), -q.y(), q.z());
  };
  switch (s.kind) {
    case Solid::Kind::ball:
      return seen_ball(at(s.a), r);
    case Solid::Kind::cylinder:
    case Solid::Kind::cone:
      if (!(r > 1e-6) || !((s.b - s.a).norm() * scale > 1e-6)) return std::nullopt;
      return seen(turned(at(s.a), at(s.b), r, s.kind == Solid::Kind::cone));
    case Solid::Kind::box: {
      std::array<Vector3d, 8> c = corners(s);
      for (Vector3d& p : c) p = at(p);
      if (!(s.b.minCoeff() * scale > 1e-6)) return std::nullopt;
      return seen(box(c));
    }
    case Solid::Kind::plate: {
      std::vector<Vector3d> ring;
      for (const Vector3d& p : s.outline) ring.push_back(at(p));
      if (ring.size() < 3 || !(r > 1e-6)) return std::nullopt;
      return seen(slab(std::move(ring), r));
    }
  }
  return std::nullopt;
}

}  // namespace pmreport::scene
