#include <reports/figure/palette.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace pmreport::figure {
namespace {

// After M. Okabe, K. Ito: Color Universal Design (2008), for white ground: yellow is left out; blue, sky blue, purple and orange (now
// ochre) are darkened until each stands out from white by 3:1 (WCAG 2.1, 1.4.11) and any two differ for protanopes and deuteranopes too.
// Wine, slate and indigo extend the set.
constexpr std::array<Colour, colours> palette{rgb(0x0060A8), rgb(0xD95F02), rgb(0x009068), rgb(0x000000), rgb(0xC0609A),
                                              rgb(0x3C97D3), rgb(0x6E5200), rgb(0x8A1C4F), rgb(0x5C6670), rgb(0x332288)};

const std::array<std::vector<double>, 10>& dashes() {
  static const std::array<std::vector<double>, 10> patterns{{{},
                                                             {4.5, 1.7},
                                                             {6, 1.6, 1.1, 1.6},
                                                             {1.1, 1.5},
                                                             {9, 2.2},
                                                             {2.4, 1.4},
                                                             {6, 1.5, 1.1, 1.5, 1.1, 1.5},
                                                             {8, 1.6, 2.6, 1.6},
                                                             {2.6, 1.4, 1.1, 1.4},
                                                             {5, 1.5, 2.4, 1.5, 2.4, 1.5}}};
  return patterns;
}

}  // namespace

LineStyle line_style(int style) {
  const auto index = static_cast<std::size_t>(style < 0 ? 0 : style);
  const std::size_t colour = index % palette.size();
  return {palette[colour], dashes()[(colour + index / palette.size()) % dashes().size()]};
}

int style_of(int colour, int dash) { return colour + colours * ((dash - colour + colours) % colours); }

LineStyle line_over_map(int style) { return {rgb(0x007A33), style == 0 ? std::vector<double>{} : std::vector<double>{4.5, 1.7}}; }

Colour as_text(const Colour& colour) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  Colour out = colour;
  while (1.05 / (0.2126 * linear(out.red) + 0.7152 * linear(out.green) + 0.0722 * linear(out.blue) + 0.05) < 4.5)
    out = {0.96 * out.red, 0.96 * out.green, 0.96 * out.blue};
  return out;
}

void set_colour(cairo_t* cr, const Colour& colour) { cairo_set_source_rgb(cr, colour.red, colour.green, colour.blue); }

}  // namespace pmreport::figure
