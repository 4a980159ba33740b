#include "reports/figure/palette.hpp"

#include <array>
#include <cstddef>

namespace pmreport::figure {
namespace {

constexpr Colour rgb(unsigned hex) {
  return {static_cast<double>(hex >> 16 & 255U) / 255, static_cast<double>(hex >> 8 & 255U) / 255, static_cast<double>(hex & 255U) / 255};
}

// M. Okabe, K. Ito: Color Universal Design (2008). On white ground yellow is unreadable and left out; sky blue, orange and purple are
// darkened until they stand out from white by 3:1 (WCAG 2.1, 1.4.11). Wine, indigo, olive and grey extend the set (after P. Tol's "muted").
constexpr std::array<Colour, colours> palette{rgb(0x0072B2), rgb(0xD55E00), rgb(0x009068), rgb(0x000000), rgb(0xBC5C93),
                                              rgb(0xB87A00), rgb(0x3591CE), rgb(0x882255), rgb(0x7A7A7A), rgb(0x332288)};

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

void set_colour(cairo_t* cr, const Colour& colour) { cairo_set_source_rgb(cr, colour.red, colour.green, colour.blue); }

}  // namespace pmreport::figure
