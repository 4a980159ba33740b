#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <reports/scene/vector/shade.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Color toned(const Color& c, double tone) {
  const auto channel = [&](float x) { return static_cast<float>(tone <= 1 ? x * tone : x + (1 - x) * std::min(1.0, 2.2 * (tone - 1))); };
  return {channel(c.r), channel(c.g), channel(c.b), c.a};
}

double tone_of(const Vector3d& normal) {
  static const Vector3d light = Vector3d(-0.45, 0.62, 0.64).normalized();
  return 0.66 + 0.46 * std::max(0.0, normal.dot(light));
}

// Across the line of the axis, where the mantle's normals change; a cone's change likewise.
Paint rounded_paint(const Solid& s, const View& view) {
  const Vector3d a(view.see(s.a).x(), -view.see(s.a).y(), view.see(s.a).z()), b(view.see(s.b).x(), -view.see(s.b).y(), view.see(s.b).z());
  const Vector3d d = (b - a).normalized();
  Vector3d u = Vector3d::UnitZ().cross(d);
  if (u.norm() < 1e-6) return flat(lit(s.color, Vector3d::UnitZ()));
  u.normalize();
  const Vector3d v = d.cross(u);
  const double r = s.radius * view.scale();
  Paint paint{Paint::Kind::across, on_page(a - r * u), on_page(a + r * u), 0, {}};
  for (const double at : {0.0, 0.3, 0.65, 1.0}) {
    const double x = 2 * at - 1;
    paint.stops.push_back({at, lit(s.color, x * u + std::sqrt(1 - x * x) * v)});
  }
  return paint;
}

Paint ball_paint(const Solid& s, const View& view) {
  const Vector3d c = view.see(s.a);
  Paint paint{Paint::Kind::round, {0, 0}, c.head<2>(), s.radius * view.scale(), {}};
  paint.from = paint.to + paint.radius * Vector2d(-0.34, -0.46);
  paint.stops = {{0, toned(s.color, 1.2)}, {0.45, toned(s.color, 1.0)}, {1, toned(s.color, 0.62)}};
  return paint;
}

}  // namespace

Color lit(const Color& color, const Vector3d& normal) { return toned(color, tone_of(normal)); }

Paint flat(const Color& color) { return {Paint::Kind::flat, {0, 0}, {0, 0}, 0, {{0, color}}}; }

std::vector<Area> shaded(const Solid& s, const Seen& seen, const View& view, Manner manner) {
  if (manner == Manner::plain) return {{seen.visible, flat(s.color)}};
  if (s.color.a < 1) return {{seen.visible, flat(s.color)}};  // a ghost has no body
  if (s.kind == Solid::Kind::ball) return {{seen.visible, ball_paint(s, view)}};
  const bool round = s.kind == Solid::Kind::cylinder || s.kind == Solid::Kind::cone;
  struct Side {
    double size = 0;
    Vector3d normal{0, 0, 0};
    Region region;
  };
  std::map<int, Side> sides;
  for (const Face& f : seen.facets.faces) {
    Side& side = sides[f.side];
    side.size += area(f.outline);
    side.normal += area(f.outline) * f.normal;
    side.region.push_back(rounded(f.outline));
  }
  constexpr double thin = 5;  // [px] of radius: no gradient shows
  const auto paint_of = [&](int side) {
    return round && side == 0 && s.radius * view.scale() > thin ? rounded_paint(s, view)
                                                                : flat(lit(s.color, sides[side].normal.normalized()));
  };
  const int largest = std::ranges::max_element(sides, {}, [](const auto& x) { return x.second.size; })->first;
  std::vector<Area> areas{{seen.visible, paint_of(largest)}};
  for (const auto& [k, side] : sides) {
    if (k == largest) continue;
    if (Region part = tidy(intersection(seen.visible, united(side.region))); !part.empty()) areas.push_back({std::move(part), paint_of(k)});
  }
  return areas;
}

namespace {

bool sound(const Surface& surface, const std::array<int, 3>& triangle) {
  return std::ranges::all_of(triangle, [&](int k) {
    return k >= 0 && static_cast<std::size_t>(k) < surface.points.size() && surface.points[static_cast<std::size_t>(k)].allFinite();
  });
}

// A triangle as it is seen, corners counter-clockwise, and how much the surface faces the viewer at each: 0 edge on, 1 in full.
struct Shard {
  Vector3d corners[3];
  double facing[3];
  Vector3d slope;  // depth at (x, y): slope · (x, y, 1)
  bool towards;    // else the viewer sees its other side
};

std::vector<Shard> shards_of(const Surface& surface, const View& view, int width, int height) {
  std::vector<Vector3d> at, normals(surface.points.size(), Vector3d::Zero());
  for (const Vector3d& p : surface.points) {
    const Vector3d q = view.see(p);
    at.emplace_back(q.x(), -q.y(), q.z());
  }
  std::vector<Shard> shards;
  std::vector<std::array<std::size_t, 3>> corners;
  for (const auto& t : surface.triangles) {
    if (!sound(surface, t)) continue;
    std::array<std::size_t, 3> k{static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2])};
    const Vector3d doubled = (at[k[1]] - at[k[0]]).cross(at[k[2]] - at[k[0]]);
    for (const std::size_t i : k) normals[i] += doubled;
    Vector3d normal = doubled.normalized();
    Shard s{};
    s.towards = normal.z() > 0;
    if (!s.towards) normal = -normal, std::swap(k[1], k[2]);
    Vector2d low = at[k[0]].head<2>(), high = low;
    for (const std::size_t i : k) low = low.cwiseMin(at[i].head<2>()), high = high.cwiseMax(at[i].head<2>());
    const bool outside = high.x() < 0 || low.x() > width || high.y() < -height || low.y() > 0;
    if (!(normal.z() > 1e-4) || outside || low.cwiseAbs().maxCoeff() > 1e6 || high.cwiseAbs().maxCoeff() > 1e6) continue;
    for (std::size_t i = 0; i < 3; ++i) s.corners[i] = at[k[i]];
    s.slope << -normal.x() / normal.z(), -normal.y() / normal.z(), normal.dot(s.corners[0]) / normal.z();
    shards.push_back(s);
    corners.push_back(k);
  }
  for (std::size_t n = 0; n < shards.size(); ++n)
    for (std::size_t i = 0; i < 3; ++i)
      shards[n].facing[i] = std::max(0.0, (shards[n].towards ? 1 : -1) * normals[corners[n][i]].normalized().z());
  return shards;
}

// Where solids hide a shard; nothing when they hide all of it.
std::optional<Region> hidden_of(const Shard& shard, const Polygon& flat, const std::vector<Seen>& solids) {
  Vector2d low = flat[0], high = low;
  for (const Vector2d& q : flat) low = low.cwiseMin(q), high = high.cwiseMax(q);
  const double farthest = std::min({shard.corners[0].z(), shard.corners[1].z(), shard.corners[2].z()});
  Region hidden;
  for (const Seen& s : solids) {
    const Facets& f = s.facets;
    if (s.ghost || f.nearest < farthest || f.low.x() > high.x() || f.high.x() < low.x() || f.low.y() > high.y() || f.high.y() < low.y())
      continue;
    const Polygon part = hidden_part(flat, shard.slope, f);
    if (part.size() < 3) continue;
    if (area(part) > area(flat) * (1 - 1e-6)) return std::nullopt;
    if (ClipperLib::Path path = rounded(part); path.size() >= 3) hidden.push_back(std::move(path));
  }
  return hidden;
}

// The part of a shard that faces the viewer by `least` or more and by less than `most`, `facing` taken as linear over it.
Polygon facing_part(const Shard& shard, const Polygon& flat, double least, double most) {
  const auto [low, high] = std::minmax({shard.facing[0], shard.facing[1], shard.facing[2]});
  if (high < least || low >= most) return {};
  if (low >= least && high < most) return flat;
  Eigen::Matrix3d places;
  for (int k = 0; k < 3; ++k) places.row(k) << flat[static_cast<std::size_t>(k)].transpose(), 1;
  const Vector3d facing = places.partialPivLu().solve(Vector3d(shard.facing[0], shard.facing[1], shard.facing[2]));
  if (!facing.allFinite()) return (low + high) / 2 >= least && (low + high) / 2 < most ? flat : Polygon{};
  return cut(cut(flat, facing - Vector3d(0, 0, least)), Vector3d(0, 0, most) - facing);
}

}  // namespace

// Each tone reaches a little over the next darker one: no slit of another brightness stays between them.
std::vector<Layer> shaded(const Surface& surface, const std::vector<Seen>& solids, const View& view, int width, int height) {
  constexpr int tones = 6;
  constexpr double overlap = 0.3, soft = 0.4;  // [px]: the edges of tones are no lines
  constexpr double darkest = 0.55, lightest = 1.12;
  std::array<std::array<Region, tones>, 2> parts;  // away, towards
  for (const Shard& shard : shards_of(surface, view, width, height)) {
    const Polygon flat{shard.corners[0].head<2>(), shard.corners[1].head<2>(), shard.corners[2].head<2>()};
    const std::optional<Region> hidden = hidden_of(shard, flat, solids);
    if (!hidden) continue;
    for (std::size_t k = 0; k < tones; ++k) {
      const double least = static_cast<double>(k) / tones, most = k + 1 < tones ? static_cast<double>(k + 1) / tones : 2;
      const Polygon part = facing_part(shard, flat, least, most);
      if (part.size() < 3) continue;
      ClipperLib::Path path = rounded(part);
      if (path.size() < 3) continue;
      Region& into = parts[shard.towards ? 1 : 0][k];
      if (hidden->empty()) {
        into.push_back(std::move(path));
      } else {
        const Region rest = difference({path}, *hidden);
        into.insert(into.end(), rest.begin(), rest.end());
      }
    }
  }
  std::vector<Layer> layers;
  Color plain = surface.color;
  plain.a = 1;
  for (const auto& side : parts) {
    Layer layer{surface.color.a, {}, {}};
    Region whole;
    for (std::size_t k = 0; k < tones; ++k)
      if (Region region = tidy(grown(tidy(united(side[k])), overlap), soft); !region.empty()) {
        whole.insert(whole.end(), region.begin(), region.end());
        layer.areas.push_back(
            {std::move(region), flat(toned(plain, darkest + (lightest - darkest) * (static_cast<double>(k) + 0.5) / tones))});
      }
    if (layer.areas.empty()) continue;
    for (const ClipperLib::Path& path : tidy(closed(whole), 0.25)) {
      Stroke stroke{{}, toned(plain, 0.45), 0.35, true, {}};
      for (const ClipperLib::IntPoint& p : path)
        stroke.points.emplace_back(static_cast<double>(p.X) / fine, -static_cast<double>(p.Y) / fine);
      layer.strokes.push_back(std::move(stroke));
    }
    layers.push_back(std::move(layer));
  }
  return layers;
}

}  // namespace pmreport::scene
