// How a curve looks. Colour and dash both tell the curves apart, so that a figure reads in grey and for every eye.
#pragma once

#include <cairo.h>

#include <vector>

namespace pmreport::figure {

struct Colour {
  double red, green, blue;  // sRGB, 0 to 1
};

struct LineStyle {
  Colour colour;
  std::vector<double> dash;  // [pt] on, off, ...; empty: solid
};

// Ten colours by ten dashes: the first hundred styles differ from one another.
constexpr int colours = 10;
LineStyle line_style(int style);
// The style that has this colour and this dash, each 0 to 9; dash 0 is solid.
int style_of(int colour, int dash);

// A curve that lies over colours: green, which no map uses; solid for style 0, else dashed.
LineStyle line_over_map(int style);

constexpr double curve_width = 1.1;  // [pt]
constexpr double axis_width = 0.5;
constexpr double grid_width = 0.3;
constexpr double limit_width = 0.6;
constexpr double dot_radius = 1.1;
constexpr double mark_radius = 1.9;  // of a series of points

constexpr double title_size = 8;  // [pt] text sizes
constexpr double label_size = 7.5;
constexpr double tick_size = 7;

constexpr Colour rgb(unsigned hex) {
  return {static_cast<double>(hex >> 16 & 255U) / 255, static_cast<double>(hex >> 8 & 255U) / 255, static_cast<double>(hex & 255U) / 255};
}

constexpr Colour ink{0.10, 0.10, 0.10};
constexpr Colour quiet_ink{0.32, 0.32, 0.32};
constexpr Colour grid_ink{0.88, 0.88, 0.88};
constexpr Colour zero_ink{0.66, 0.66, 0.66};
constexpr Colour border_ink{0.75, 0.75, 0.75};
constexpr Colour limit_tint{1.00, 0.93, 0.78};
constexpr Colour limit_hatch{0.90, 0.66, 0.20};
constexpr Colour unreachable_tint{0.88, 0.88, 0.88};

// A colour darkened until it stands out from white by 4.5:1, as text must (WCAG 2.1, 1.4.3).
Colour as_text(const Colour& colour);

void set_colour(cairo_t* cr, const Colour& colour);

}  // namespace pmreport::figure
