// Which solid a line of sight meets first, by the equations of the solids: knows nothing of facets.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <reports/scene/view.hpp>

namespace pmreport::scene::test {

using Eigen::Vector3d;

struct Span {
  double from = -HUGE_VAL, to = HUGE_VAL;  // of the line inside the solid
  bool empty() const { return !(from < to); }
  void keep(double a, double b) { from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b)); }
  void none() { from = 1, to = 0; }
  // n · (o + t d) <= limit
  void below(double no, double nd, double limit) {
    if (nd == 0) {
      if (no > limit) none();
    } else if (const double t = (limit - no) / nd; nd > 0) {
      to = std::min(to, t);
    } else {
      from = std::max(from, t);
    }
  }
  // a t² + 2 b t + c <= 0 with a > 0
  void within(double a, double b, double c) {
    const double root = b * b - a * c;
    root < 0 ? none() : keep((-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a);
  }
};

// The line o + t d, d unit; of a cone, the farthest t inside it is found by walking, for its equation has a second nappe.
inline Span inside(const Solid& s, const Vector3d& o, const Vector3d& d) {
  Span span;
  switch (s.kind) {
    case Solid::Kind::ball: {
      const Vector3d q = o - s.a;
      span.within(1, q.dot(d), q.squaredNorm() - s.radius * s.radius);
      break;
    }
    case Solid::Kind::cylinder: {
      const Vector3d u = (s.b - s.a).normalized(), q = o - s.a;
      span.below(q.dot(u), d.dot(u), (s.b - s.a).norm());
      span.below(-q.dot(u), -d.dot(u), 0);
      const Vector3d across = d - d.dot(u) * u, off = q - q.dot(u) * u;
      if (across.squaredNorm() > 1e-18)
        span.within(across.squaredNorm(), off.dot(across), off.squaredNorm() - s.radius * s.radius);
      else if (off.norm() > s.radius)
        span.none();
      break;
    }
    case Solid::Kind::cone: {
      // From the tip, along the axis v: |q - (q·v) v| <= k q·v, 0 <= q·v <= h.
      const Vector3d v = (s.a - s.b).normalized(), q = o - s.b;
      const double h = (s.a - s.b).norm(), k = s.radius / h;
      span.below(q.dot(v), d.dot(v), h);
      span.below(-q.dot(v), -d.dot(v), 0);
      if (span.empty() || !std::isfinite(span.from + span.to)) break;
      const auto outside = [&](double t) {
        const Vector3d p = q + t * d;
        return (p - p.dot(v) * v).norm() - k * p.dot(v);  // convex in t
      };
      double a = span.from, b = span.to;
      for (int i = 0; i < 100; ++i) {
        const double m = a + (b - a) / 3, n = b - (b - a) / 3;
        outside(m) < outside(n) ? b = n : a = m;
      }
      const double best = (a + b) / 2;
      if (outside(best) > 0) {
        span.none();
        break;
      }
      const auto edge = [&](double in, double out) {
        if (outside(out) <= 0) return out;
        for (int i = 0; i < 60; ++i) (outside((in + out) / 2) <= 0 ? in : out) = (in + out) / 2;
        return in;
      };
      const double from = edge(best, span.from), to = edge(best, span.to);
      span.keep(from, to);
      break;
    }
    case Solid::Kind::box:
      for (int k = 0; k < 3; ++k) {
        const Vector3d n = s.axes.col(k);
        span.below(n.dot(o), n.dot(d), n.dot(s.a) + s.b(k));
        span.below(-n.dot(o), -n.dot(d), -n.dot(s.a) + s.b(k));
      }
      break;
    case Solid::Kind::plate: {
      const std::size_t size = s.outline.size();
      const Vector3d n = (s.outline[1] - s.outline[0]).cross(s.outline[2] - s.outline[1]).normalized();
      span.below(n.dot(o), n.dot(d), n.dot(s.outline[0]) + s.radius / 2);
      span.below(-n.dot(o), -n.dot(d), -n.dot(s.outline[0]) + s.radius / 2);
      for (std::size_t k = 0; k < size; ++k) {
        const Vector3d out = (s.outline[(k + 1) % size] - s.outline[k]).cross(n);
        span.below(out.dot(o), out.dot(d), out.dot(s.outline[k]));
      }
    }
  }
  return span;
}

// Index of the nearest solid at a place of the picture [px]; -1: none.
inline int nearest(const Scene& scene, const View& view, double x, double y) {
  const Vector3d o = view.world({x, y, 0}), d = view.towards();
  int best = -1;
  double most = -HUGE_VAL;
  for (std::size_t k = 0; k < scene.solids.size(); ++k)
    if (const Span s = inside(scene.solids[k], o, d); !s.empty() && s.to > most) most = s.to, best = static_cast<int>(k);
  return best;
}

}  // namespace pmreport::scene::test
