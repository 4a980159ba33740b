// The inverse displacement of the 4SPS-SPR as one would write it for itself alone: plain doubles, default geometry, nothing but the
// dependent coordinate, five lengths and five directions. A floor under what a general contract may cost.
#pragma once

#include <array>
#include <cmath>

namespace pmreport::bench {

struct HandWritten {
  struct Point {
    double x, y, z;
  };
  std::array<Point, 5> a, b;  // base joints; platform joints in platform axes
  double nx, ny;              // revolute axis in platform axes, horizontal
  double offset;              // of B5 along it

  HandWritten() {
    constexpr double pi = 3.14159265358979323846;
    for (int i = 0; i < 5; ++i) {
      const double at_base = pi * (0.25 + 0.5 * (i - 1)), on_platform = 0.4 * pi * i;
      const auto k = static_cast<std::size_t>(i);
      a[k] = i == 0 ? Point{0.5, 0, 0} : Point{0.4 * std::cos(at_base), 0.4 * std::sin(at_base), 0};
      b[k] = {0.1 * std::cos(on_platform), 0.1 * std::sin(on_platform), 0};
    }
    const double ux = a[4].x - b[4].x, uy = a[4].y - b[4].y, horizontal = std::hypot(ux, uy);
    nx = -uy / horizontal;
    ny = ux / horizontal;
    offset = nx * b[4].x + ny * b[4].y;
  }

  // q: x z alpha beta gamma. Fills the lengths [m] and the directions of the limbs, and returns y [m].
  double operator()(const double* q, double* length, Point* direction) const {
    const double ca = std::cos(q[2]), sa = std::sin(q[2]), cb = std::cos(q[3]), sb = std::sin(q[3]), cc = std::cos(q[4]),
                 sc = std::sin(q[4]);
    const double r00 = ca * cb, r01 = ca * sb * sc - sa * cc, r10 = sa * cb, r11 = sa * sb * sc + ca * cc, r20 = -sb, r21 = cb * sc;
    const double wx = r00 * nx + r01 * ny, wy = r10 * nx + r11 * ny, wz = r20 * nx + r21 * ny;
    const double y = (wx * (a[4].x - q[0]) + wy * a[4].y - wz * q[1] - offset) / wy;
    for (std::size_t i = 0; i < 5; ++i) {
      const double dx = q[0] + r00 * b[i].x + r01 * b[i].y - a[i].x, dy = y + r10 * b[i].x + r11 * b[i].y - a[i].y,
                   dz = q[1] + r20 * b[i].x + r21 * b[i].y;
      length[i] = std::sqrt(dx * dx + dy * dy + dz * dz);
      const double scale = 1 / length[i];
      direction[i] = {dx * scale, dy * scale, dz * scale};
    }
    return y;
  }
};

}  // namespace pmreport::bench
