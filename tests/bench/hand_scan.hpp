// Glazunov's grid as one would scan it for one mechanism alone: plain doubles, platform points turned once for all, the cheapest test first
// and out at the first that fails. A floor under what a general program may cost.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pmreport::bench {

class HandScan {
 public:
  struct Point {
    double x, y, z;
    friend Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Point operator*(double s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }
    friend double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  };
  static constexpr double pi = 3.14159265358979323846, deg = pi / 180;

  // Legs from a to b; with `crossed` the inner cross chains of the parallel-cross mechanism.
  HandScan(std::vector<Point> a, std::vector<Point> b, bool crossed, const std::vector<std::array<double, 3>>& orientations)
      : a_(std::move(a)), crossed_(crossed) {
    for (const auto& [alpha, beta, gamma] : orientations) {
      const double ca = std::cos(alpha), sa = std::sin(alpha), cb = std::cos(beta), sb = std::sin(beta), cc = std::cos(gamma),
                   sc = std::sin(gamma);
      Turned t{{}, {ca * sc + sa * sb * cc, sa * sc - ca * sb * cc, cb * cc}};
      for (std::size_t i = 0; i < b.size(); ++i)
        t.b[i] = {(ca * cc - sa * sb * sc) * b[i].x - sa * cb * b[i].y, (sa * cc + ca * sb * sc) * b[i].x + ca * cb * b[i].y,
                  -cb * sc * b[i].x + sb * b[i].y};
      turned_.push_back(t);
    }
  }
  static HandScan gough(const std::vector<std::array<double, 3>>& orientations) {
    std::vector<Point> a, b;
    for (int i = 0; i < 3; ++i)
      for (const int side : {-1, 1}) {
        const double at = (-150 + 120 * i) * deg, base = at + side * 10.6 * deg, platform = at + side * (pi / 3 - 15.2 * deg);
        a.push_back({0.3 * std::cos(base), 0.3 * std::sin(base), 0});
        b.push_back({0.2 * std::cos(platform), 0.2 * std::sin(platform), 0});
      }
    return {a, b, false, orientations};
  }
  static HandScan parallel_cross(const std::vector<std::array<double, 3>>& orientations) {
    std::vector<Point> a, b;
    for (int i = 0; i < 3; ++i) {
      const double at = (-150 + 120 * i) * deg;
      a.push_back({0.3 * std::cos(at), 0.3 * std::sin(at), 0});
      b.push_back({0.2 * std::cos(at), 0.2 * std::sin(at), 0});
    }
    return {a, b, true, orientations};
  }

  // Accepted orientations at a point.
  std::uint64_t count(const Point& p) const {
    for (const Point& a : a_) {
      const double squared = dot(p - a, p - a);
      if (squared > (longest + radius) * (longest + radius) || squared < (shortest - radius) * (shortest - radius)) return 0;
    }
    std::uint64_t n = 0;
    for (const Turned& t : turned_) n += crossed_ ? accepts<3>(p, t) : accepts<6>(p, t);
    return n;
  }

 private:
  static constexpr double shortest = 0.76, longest = 1.41, radius = 0.2, apart = 0.1, slack = 1e-12;
  struct Turned {
    std::array<Point, 6> b;
    Point normal;
  };
  struct Segment {
    Point from, along;
  };

  template <std::size_t legs>
  bool accepts(const Point& p, const Turned& t) const {
    std::array<Point, legs> v;
    std::array<double, legs> squared;
    for (std::size_t i = 0; i < legs; ++i) {
      v[i] = p + t.b[i] - a_[i];
      const double q = squared[i] = dot(v[i], v[i]), up = dot(v[i], t.normal);
      if (q < shortest * shortest - slack || q > longest * longest + slack) return false;
      if (v[i].z < 0 || v[i].z * v[i].z < 0.25 * q - slack || up < 0 || up * up < 0.25 * q - slack) return false;
    }
    if constexpr (legs == 6) {
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = i + 1; j < 6; ++j)
          if (!are_apart({a_[i], v[i]}, {a_[j], v[j]})) return false;
      return true;
    } else {
      return accepts_cross(v, squared);
    }
  }

  bool accepts_cross(const std::array<Point, 3>& v, const std::array<double, 3>& squared) const {
    constexpr double low = 0.15, high = 0.65, least = 0.30, most = 0.95;  // C and D on their legs; strokes of the cross drives
    static const double flattest = std::cos(15 * deg) * std::cos(15 * deg);
    std::array<Segment, 3> cross;
    std::array<Point, 3> u;
    for (std::size_t i = 0; i < 3; ++i) u[i] = (1 / std::sqrt(squared[i])) * v[i];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const Point c = a_[i] + low * u[i], w = a_[j] + high * u[j] - c;
      const double q = dot(w, w), at_c = dot(w, u[i]), at_d = dot(w, u[j]);
      if (q < least * least - slack || q > most * most + slack) return false;
      if (at_c * at_c > flattest * q + slack || at_d * at_d > flattest * q + slack) return false;
      cross[i] = {c, w};
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      if (!are_apart({a_[i], v[i]}, {a_[j], v[j]}) || !are_apart(cross[i], cross[j]) || !are_apart(cross[i], {a_[k], v[k]})) return false;
    }
    return true;
  }

  static bool are_apart(const Segment& p, const Segment& q) {
    const auto clamp = [](double x) { return x < 0 ? 0.0 : x > 1 ? 1.0 : x; };
    const Point &d = p.along, &e = q.along, r = p.from - q.from;
    const double a = dot(d, d), b = dot(d, e), ee = dot(e, e), c = dot(d, r), f = dot(e, r), divisor = a * ee - b * b;
    double s = divisor > 1e-12 * a * ee ? clamp((b * f - c * ee) / divisor) : 0.0;
    const double t = clamp((b * s + f) / ee);
    s = clamp((b * t - c) / a);
    const Point between = r + s * d - t * e;
    return dot(between, between) >= apart * apart - slack;
  }

  std::vector<Point> a_;
  bool crossed_;
  std::vector<Turned> turned_;
};

}  // namespace pmreport::bench
