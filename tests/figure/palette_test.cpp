#include "reports/figure/palette.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace pmreport::figure;

namespace {

double linear(double channel) { return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4); }

double luminance(const Colour& c) { return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue); }

// What an eye without one kind of cones sees, in linear light: G. M. Machado et al., A Physiologically-based Model for Simulation of Color
// Vision Deficiency (2009), severity 1.
constexpr double protanopia[3][3] = {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}};
constexpr double deuteranopia[3][3] = {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};

struct Lab {
  double lightness, a, b;
};

Lab lab(const Colour& colour, const double (*vision)[3]) {
  const double light[3] = {linear(colour.red), linear(colour.green), linear(colour.blue)};
  double seen[3] = {light[0], light[1], light[2]};
  for (int i = 0; vision != nullptr && i < 3; ++i) seen[i] = vision[i][0] * light[0] + vision[i][1] * light[1] + vision[i][2] * light[2];
  const double x = (0.4124 * seen[0] + 0.3576 * seen[1] + 0.1805 * seen[2]) / 0.9505;
  const double y = 0.2126 * seen[0] + 0.7152 * seen[1] + 0.0722 * seen[2];
  const double z = (0.0193 * seen[0] + 0.1192 * seen[1] + 0.9505 * seen[2]) / 1.089;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

double difference(const Lab& p, const Lab& q) { return std::hypot(p.lightness - q.lightness, p.a - q.a, p.b - q.b); }

}  // namespace

TEST_CASE("every curve stands out from white paper") {
  // WCAG 2.1, success criterion 1.4.11: graphics need a contrast of 3:1.
  for (int style = 0; style < colours; ++style) {
    CAPTURE(style);
    CHECK(1.05 / (luminance(line_style(style).colour) + 0.05) >= 3);
  }
}

TEST_CASE("any two colours differ for every kind of eye") {
  const double(*const eyes[])[3] = {nullptr, protanopia, deuteranopia};
  for (int eye = 0; eye < 3; ++eye) {
    for (int i = 0; i < colours; ++i) {
      for (int j = 0; j < i; ++j) {
        CAPTURE(eye, i, j);
        // A difference of 2.3 is just noticeable between fields side by side; thin lines apart need some five times that.
        CHECK(difference(lab(line_style(i).colour, eyes[eye]), lab(line_style(j).colour, eyes[eye])) > 12);
      }
    }
  }
}

TEST_CASE("curves of one panel differ in their dashes too") {
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < i; ++j) {
      CAPTURE(i, j);
      const LineStyle p = line_style(i), q = line_style(j);
      const bool one_colour = p.colour.red == q.colour.red && p.colour.green == q.colour.green && p.colour.blue == q.colour.blue;
      if (i / 10 == j / 10 || one_colour) CHECK(p.dash != q.dash);
    }
  }
}
