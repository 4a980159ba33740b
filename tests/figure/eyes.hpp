// What eyes see of a colour.
#pragma once

#include <reports/figure/palette.hpp>

#include <cmath>

namespace pmreport::figure::eyes {

inline double linear(double channel) { return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4); }

inline double luminance(const Colour& c) { return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue); }

// What an eye without one kind of cones sees, in linear light: G. M. Machado et al., A Physiologically-based Model for Simulation of Color
// Vision Deficiency (2009), severity 1.
constexpr double protanopia[3][3] = {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}};
constexpr double deuteranopia[3][3] = {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};

struct Lab {
  double lightness, a, b;
};

inline Lab lab(const Colour& colour, const double (*vision)[3]) {
  const double light[3] = {linear(colour.red), linear(colour.green), linear(colour.blue)};
  double seen[3] = {light[0], light[1], light[2]};
  for (int i = 0; vision != nullptr && i < 3; ++i) seen[i] = vision[i][0] * light[0] + vision[i][1] * light[1] + vision[i][2] * light[2];
  const double x = (0.4124 * seen[0] + 0.3576 * seen[1] + 0.1805 * seen[2]) / 0.9505;
  const double y = 0.2126 * seen[0] + 0.7152 * seen[1] + 0.0722 * seen[2];
  const double z = (0.0193 * seen[0] + 0.1192 * seen[1] + 0.9505 * seen[2]) / 1.089;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

inline double difference(const Lab& p, const Lab& q) { return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b); }

// All cones, none of the long ones, none of the middle ones.
using Vision = const double (*)[3];
constexpr Vision all[] = {nullptr, protanopia, deuteranopia};

}  // namespace pmreport::figure::eyes
