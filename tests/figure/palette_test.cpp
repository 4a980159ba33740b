#include "reports/figure/palette.hpp"

#include <catch2/catch.hpp>

#include <tests/figure/eyes.hpp>

using namespace pmreport::figure;
using namespace pmreport::figure::eyes;

TEST_CASE("every curve stands out from white paper") {
  // WCAG 2.1, success criterion 1.4.11: graphics need a contrast of 3:1.
  for (int style = 0; style < colours; ++style) {
    CAPTURE(style);
    CHECK(1.05 / (luminance(line_style(style).colour) + 0.05) >= 3);
  }
}

TEST_CASE("any two colours differ for every kind of eye") {
  for (int eye = 0; eye < 3; ++eye) {
    for (int i = 0; i < colours; ++i) {
      for (int j = 0; j < i; ++j) {
        CAPTURE(eye, i, j);
        // A difference of 2.3 is just noticeable between fields side by side; thin lines apart need some five times that.
        CHECK(difference(lab(line_style(i).colour, all[eye]), lab(line_style(j).colour, all[eye])) > 12);
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

TEST_CASE("a name in the colour of its curve reads as text, and looks like the curve's colour") {
  for (int style = 0; style < colours; ++style) {
    CAPTURE(style);
    const Colour curve = line_style(style).colour, name = as_text(curve);
    CHECK(1.05 / (luminance(name) + 0.05) >= 4.5);  // WCAG 2.1, 1.4.3
    // The nearest of all colours is its own.
    for (int other = 0; other < colours; ++other)
      if (other != style)
        CHECK(difference(lab(name, nullptr), lab(curve, nullptr)) < difference(lab(name, nullptr), lab(line_style(other).colour, nullptr)));
  }
}
