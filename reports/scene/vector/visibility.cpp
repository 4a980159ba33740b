#include <algorithm>
#include <cmath>
#include <reports/scene/vector/visibility.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double tie = 1e-4;      // [px] depths that differ by less are equal
constexpr double overlap = 0.05;  // [px] by which the pieces of one region reach into one another, so that no slit stays between them
constexpr double nothing = 0.05;  // [px²]

Polygon common(const Polygon& a, const Polygon& b) {
  Polygon out = a;
  for (const Vector3d& side : bounds_of(b, 0)) {
    out = cut(out, side);
    if (out.size() < 3) return {};
  }
  return out;
}

Polygon nearer(Polygon p, const Vector3d& slope, const Facets& solid, double by) {
  for (const Face& f : solid.faces) {
    const Vector3d above = f.slope - slope;
    p = cut(p, {above.x(), above.y(), above.z() - by});
    if (p.size() < 3) return {};
  }
  return p;
}

// The front of a convex solid is the least of the depths of its faces, a concave function. So where one solid's front is nearer than a face
// of the other is a convex polygon, and where it is nearer than the other is the union of one such polygon a face. The solid with fewer
// faces, `e`, is taken face by face; what is not f's is e's.
struct Order {
  enum class Kind { apart, e_in_front, f_in_front, mixed } kind = Kind::apart;
  Polygon both;  // where their outlines overlap
  Region f_in_front;
};

Order order_of(const Facets& e, const Facets& f, bool f_is_later) {
  Order order;
  if (e.low.x() >= f.high.x() || f.low.x() >= e.high.x() || e.low.y() >= f.high.y() || f.low.y() >= e.high.y()) return order;
  order.both = common(e.outline, f.outline);
  const double whole = area(order.both);
  if (whole < nothing) return order;
  order.kind = Order::Kind::e_in_front;
  if (e.farthest > f.nearest) return order;
  order.kind = Order::Kind::f_in_front;
  if (f.farthest > e.nearest) return order;

  double nearer_area = 0;
  Vector2d low = order.both.front(), high = low;
  for (const Vector2d& p : order.both) low = low.cwiseMin(p), high = high.cwiseMax(p);
  for (const Face& face : e.faces) {
    Vector2d from = face.outline.front(), to = from;
    for (const Vector2d& p : face.outline) from = from.cwiseMin(p), to = to.cwiseMax(p);
    if (from.x() > high.x() || to.x() < low.x() || from.y() > high.y() || to.y() < low.y()) continue;
    Polygon p = order.both;
    for (const Vector3d& side : bounds_of(face.outline, overlap)) {
      p = cut(p, side);
      if (p.size() < 3) break;
    }
    if (p.size() < 3) continue;
    p = nearer(std::move(p), face.slope, f, f_is_later ? -tie : tie);
    if (p.size() < 3) continue;
    nearer_area += area(p);
    if (ClipperLib::Path path = rounded(p); path.size() >= 3) order.f_in_front.push_back(std::move(path));
  }
  if (nearer_area < nothing) {
    order.kind = Order::Kind::e_in_front;
    return order;
  }
  order.kind = Order::Kind::mixed;
  order.f_in_front = united(order.f_in_front);
  if (whole - area(order.f_in_front) < nothing) order.kind = Order::Kind::f_in_front;
  return order;
}

}  // namespace

std::vector<Seen> look_at(const Scene& scene, const View& view, int width, int height) {
  constexpr double rim = 40;  // [px] beyond the picture, so that no outline runs along its edge
  const Polygon window{{-rim, -height - rim}, {width + rim, -height - rim}, {width + rim, rim}, {-rim, rim}};
  std::vector<Seen> all;
  for (std::size_t k = 0; k < scene.solids.size(); ++k) {
    std::optional<Facets> facets = facets_of(scene.solids[k], view);
    if (!facets || facets->low.x() > width + rim || facets->high.x() < -rim || facets->low.y() > rim || facets->high.y() < -height - rim)
      continue;
    all.push_back({k, std::move(*facets), scene.solids[k].color.a < 1, {}});
  }
  std::vector<Region> hiding(all.size());
  std::vector<bool> hidden(all.size(), false);
  const auto hide = [&](std::size_t what, std::size_t by, const Polygon& both) {
    if (area(both) > area(all[what].facets.outline) - nothing)
      hidden[what] = true;
    else
      hiding[what].push_back(rounded(all[by].facets.outline));
  };
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      const bool i_hides = !all[i].ghost || all[k].ghost, k_hides = !all[k].ghost || all[i].ghost;
      if ((!i_hides || hidden[k]) && (!k_hides || hidden[i])) continue;
      const bool swapped = all[k].facets.faces.size() < all[i].facets.faces.size();
      const std::size_t e = swapped ? k : i, f = swapped ? i : k;
      const bool e_hides = swapped ? k_hides : i_hides, f_hides = swapped ? i_hides : k_hides;
      const Order order = order_of(all[e].facets, all[f].facets, f > e);
      switch (order.kind) {
        case Order::Kind::apart:
          break;
        case Order::Kind::e_in_front:
          if (e_hides) hide(f, e, order.both);
          break;
        case Order::Kind::f_in_front:
          if (f_hides) hide(e, f, order.both);
          break;
        case Order::Kind::mixed: {
          if (f_hides) hiding[e].insert(hiding[e].end(), order.f_in_front.begin(), order.f_in_front.end());
          if (!e_hides) break;
          const Region rest = difference({rounded(order.both)}, order.f_in_front);
          hiding[f].insert(hiding[f].end(), rest.begin(), rest.end());
        }
      }
    }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (hidden[i]) continue;
    const Polygon inside = common(all[i].facets.outline, window);
    if (inside.size() < 3) continue;
    all[i].visible = tidy(difference({rounded(inside)}, hiding[i]));
  }
  return all;
}

Polygon hidden_part(const Polygon& p, const Vector3d& slope, const Facets& by) {
  Polygon out = common(p, by.outline);
  return out.size() < 3 ? Polygon{} : nearer(std::move(out), slope, by, tie);
}

Interval hidden_interval(const Vector3d& p, const Vector3d& q, const Facets& by) {
  constexpr double clear = 0.3;  // [px] nearer than this a line lies on the solid, and is seen
  Interval out{0, 1};
  if (std::max(p.x(), q.x()) < by.low.x() || std::min(p.x(), q.x()) > by.high.x() || std::max(p.y(), q.y()) < by.low.y() ||
      std::min(p.y(), q.y()) > by.high.y() || std::min(p.z(), q.z()) > by.nearest)
    return {0, 0};
  const auto keep = [&](double at_p, double at_q) {
    if (at_p < 0 && at_q < 0) out.to = -1;
    if ((at_p < 0) == (at_q < 0)) return;
    const double at = at_p / (at_p - at_q);
    at_p < 0 ? out.from = std::max(out.from, at) : out.to = std::min(out.to, at);
  };
  for (const Vector3d& side : bounds_of(by.outline, 0)) {
    keep(side.x() * p.x() + side.y() * p.y() + side.z(), side.x() * q.x() + side.y() * q.y() + side.z());
    if (out.from >= out.to) return out;
  }
  for (const Face& f : by.faces) {
    keep(f.depth(p.head<2>()) - p.z() - clear, f.depth(q.head<2>()) - q.z() - clear);
    if (out.from >= out.to) return out;
  }
  return out;
}

std::vector<Interval> merged(std::vector<Interval> all) {
  std::sort(all.begin(), all.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
  std::vector<Interval> out;
  for (const Interval& i : all)
    if (!out.empty() && i.from <= out.back().to)
      out.back().to = std::max(out.back().to, i.to);
    else
      out.push_back(i);
  return out;
}

}  // namespace pmreport::scene
