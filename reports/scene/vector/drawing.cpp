#include <algorithm>
#include <cmath>
#include <map>
#include <reports/scene/vector/shade.hpp>
#include <tuple>

namespace pmreport::scene {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Widths of lines on paper [pt].
constexpr double outline_width = 0.5, edge_width = 0.25, hidden_width = 0.3;
const std::vector<double> hidden_dash{1.8, 1.2};
constexpr float ghost_line = 0.4f;  // opacity of the lines of a ghost

// Lines about what is marked in the picture and no part of the machine, as arrows and frames are, have its colour; about parts they are
// nearly black, with a touch of it.
struct Ink {
  float dark, share;
};
constexpr Ink of_parts{0.05f, 0.28f}, of_marks{0, 0.75f}, plain_ink{0.08f, 0};
Color ink_for(const Color& c, const Ink& ink) {
  return {ink.dark + ink.share * c.r, ink.dark + ink.share * c.g, ink.dark + ink.share * c.b, c.a < 1 ? ghost_line : 1};
}

void add_outlines(std::vector<Stroke>& strokes, const Region& region, double width, const Color& color) {
  for (const ClipperLib::Path& path : region) {
    Stroke s{{}, color, width, true, {}};
    for (const ClipperLib::IntPoint& p : path) s.points.emplace_back(static_cast<double>(p.X) / fine, -static_cast<double>(p.Y) / fine);
    strokes.push_back(std::move(s));
  }
}

struct Split {
  std::vector<Curve> visible, hidden;
};

// A curve where it is seen and where solids hide it; each part stays one curve over its bends, so that its dashes run on.
template <class By>
Split split(const Curve& curve, const std::vector<Seen>& solids, By by) {
  Split out;
  std::vector<Curve>* last = nullptr;
  const auto add = [&](std::vector<Curve>& to, const Vector3d& p, const Vector3d& q) {
    if (last == &to)
      to.back().push_back(q);
    else
      to.push_back({p, q});
    last = &to;
  };
  for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
    const Vector3d &p = curve[k], &q = curve[k + 1];
    double at = 0;
    const auto point = [&](double t) { return Vector3d(p + t * (q - p)); };
    for (const Interval& i : hidden_intervals(p, q, solids, by)) {
      if (i.from > at) add(out.visible, point(at), point(i.from));
      add(out.hidden, point(std::max(at, i.from)), point(i.to));
      at = i.to;
    }
    if (at < 1) add(out.visible, point(at), q);
  }
  return out;
}

Stroke stroke_of(const Curve& curve, const Color& color, double width, std::vector<double> dash = {}) {
  Stroke s{{}, color, width, false, std::move(dash)};
  for (const Vector3d& p : curve) s.points.push_back(on_page(p));
  return s;
}

class Draughtsman {
 public:
  Draughtsman(const Scene& scene, const Camera& camera, const Quality& quality, Manner manner)
      : scene_(scene), view_(camera, quality.width, quality.height), quality_(quality), manner_(manner) {
    out_.manner = manner;
    out_.width = quality.width, out_.height = quality.height, out_.printed = quality.printed;
    solids_ = look_at(scene, view_, quality.width, quality.height);
    for (std::size_t k = 1; k < solids_.size(); ++k)
      if (continues(solids_[k - 1].solid, solids_[k].solid)) bent_[solids_[k - 1].solid] = bent_[solids_[k].solid] = true;
  }

  Drawing draw(const Camera& camera) {
    solids(false);
    films();
    solids(true);
    hidden_lines();
    out_.labels = find_spots(scene_, camera, quality_);
    for (const LabelSpot& s : out_.labels) out_.label_colors.push_back(scene_.labels[s.index].color);
    return std::move(out_);
  }

 private:
  // A round bar that goes on in the next one, as the pieces of a bent arrow do: no line parts them.
  bool continues(std::size_t i, std::size_t k) const {
    const Solid &a = scene_.solids[i], &b = scene_.solids[k];
    return k == i + 1 && a.kind == Solid::Kind::cylinder && b.kind == Solid::Kind::cylinder && a.radius == b.radius && same(a, b) &&
           (a.b - b.a).norm() < a.radius && (a.b - a.a).normalized().dot((b.b - b.a).normalized()) > 0.9;
  }
  bool bent(const Seen& s) const {
    const auto found = bent_.find(s.solid);
    return found != bent_.end() && found->second;
  }
  static auto key(const Solid& s) { return std::make_tuple(s.body, s.color.r, s.color.g, s.color.b, s.color.a, s.through > 0); }
  static bool same(const Solid& a, const Solid& b) { return key(a) == key(b); }
  const Solid& solid(const Seen& s) const { return scene_.solids[s.solid]; }

  // What is of one body and one colour has a dark line around it and thin ones within.
  void solids(bool ghosts) {
    Layer layer;
    std::map<decltype(key(Solid{})), Region> bodies;
    std::map<decltype(key(Solid{})), int> members;
    std::vector<Stroke> outlines;
    for (const Seen& s : solids_) ++members[key(solid(s))];
    for (const Seen& s : solids_) {
      if (s.ghost != ghosts || s.visible.empty()) continue;
      for (Area& a : shaded(solid(s), s, view_, manner_)) layer.areas.push_back(std::move(a));
      Region& body = bodies[key(solid(s))];
      body.insert(body.end(), s.visible.begin(), s.visible.end());
      if (bent(s)) continue;
      const Color ink = ink_for(solid(s).color, ink_of(solid(s).through > 0));
      if (members[key(solid(s))] > 1) add_outlines(layer.strokes, s.visible, edge_width, ink);
      for (const Curve& edge : s.facets.edges)
        for (const Curve& part : split(edge, solids_, [&](const Seen& by) { return &by != &s && (!by.ghost || ghosts); }).visible)
          layer.strokes.push_back(stroke_of(part, ink, edge_width));
    }
    for (auto& [of, region] : bodies) {
      const bool mark = std::get<5>(of);
      const Color ink = ink_for({std::get<1>(of), std::get<2>(of), std::get<3>(of), std::get<4>(of)}, ink_of(mark));
      add_outlines(outlines, tidy(closed(region)), mark ? edge_width : outline_width, ink);
    }
    layer.strokes.insert(layer.strokes.end(), outlines.begin(), outlines.end());
    if (!ghosts) lines(layer);
    if (!layer.areas.empty() || !layer.strokes.empty()) out_.layers.push_back(std::move(layer));
  }

  const Ink& ink_of(bool mark) const { return manner_ == Manner::plain ? plain_ink : mark ? of_marks : of_parts; }

  Curve seen(const Polyline& l) const {
    Curve curve;
    for (const Vector3d& p : l.points) {
      const Vector3d q = view_.see(p);
      if (q.allFinite()) curve.emplace_back(q.x(), -q.y(), q.z());
    }
    return curve;
  }

  void lines(Layer& layer) {
    const auto opaque = [](const Seen& by) { return !by.ghost; };
    for (const Polyline& l : scene_.lines) {
      const Split parts = split(seen(l), solids_, opaque);
      for (const Curve& c : parts.visible) layer.strokes.push_back(stroke_of(c, l.color, l.width * out_.points_per_pixel()));
      if (l.through > 0)
        for (const Curve& c : parts.hidden) hidden_.push_back(stroke_of(c, l.color, hidden_width, hidden_dash));
    }
  }

  void films() {
    for (const Surface& surface : scene_.surfaces)
      for (Layer& layer : shaded(surface, solids_, view_, out_.width, out_.height)) out_.layers.push_back(std::move(layer));
  }

  // Of a solid that shows through its contour where others hide it; of a thin bar its axis.
  void hidden_lines() {
    constexpr double thin = 1.8;  // [pt]
    for (const Seen& s : solids_) {
      const Solid& of = solid(s);
      if (!(of.through > 0) || s.ghost) continue;
      Curve curve = s.facets.contour;
      if (curve.size() > 1 && (curve.front() - curve.back()).norm() > 1e-9) curve.push_back(curve.front());
      if (of.kind == Solid::Kind::cylinder && (bent(s) || 2 * of.radius * view_.scale() * out_.points_per_pixel() < thin))
        curve = seen({{of.a, of.b}, of.color, 1, 0});
      for (const Curve& c : split(curve, solids_, [&](const Seen& by) { return !by.ghost && !same(solid(by), of); }).hidden)
        hidden_.push_back(stroke_of(c, of.color, hidden_width, hidden_dash));
    }
    if (!hidden_.empty()) out_.layers.push_back({1, {}, std::move(hidden_)});
  }

  const Scene& scene_;
  View view_;
  const Quality& quality_;
  Manner manner_;
  Drawing out_;
  std::vector<Seen> solids_;
  std::map<std::size_t, bool> bent_;  // by index in the scene
  std::vector<Stroke> hidden_;
};

}  // namespace

Drawing draw(const Scene& scene, const Camera& camera, const Quality& quality, Manner manner) {
  return Draughtsman(scene, camera, quality, manner).draw(camera);
}

}  // namespace pmreport::scene
