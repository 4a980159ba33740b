#include <reports/figure/colour_scale.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmreport::figure {
namespace {

constexpr double inside_quantile = 0.98;
constexpr double tail = 0.2;  // of the scale: what the farthest hundredth of the values may take of it

template <std::size_t N>
Colour between(const std::array<Colour, N>& anchors, double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (N - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), N - 2);
  const double part = at - static_cast<double>(i);
  const auto mix = [&](double Colour::*channel) { return anchors[i].*channel * (1 - part) + anchors[i + 1].*channel * part; };
  return {mix(&Colour::red), mix(&Colour::green), mix(&Colour::blue)};
}

std::vector<double> drawable_values(const ColourMap& map) {
  std::vector<double> all;
  for (const double v : map.values)
    if (std::isfinite(v)) all.push_back(std::clamp(v, -largest, largest));
  return all;
}

double quantile(std::vector<double>& values, double share) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

Interval even_range(std::vector<double> values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  Interval full{*least, *most};
  const Interval core{quantile(values, (1 - inside_quantile) / 2), quantile(values, (1 + inside_quantile) / 2)};
  const double allowed = tail * (core.high - core.low);
  if (allowed > 0 && full.high - core.high > allowed) full.high = core.high;
  if (allowed > 0 && core.low - full.low > allowed) full.low = core.low;
  return widened(full);
}

struct Fill {
  Colour tint, line;
  bool (*drawn)(int row, int column);  // whether the pixel is of the pattern's line
};

bool backslash(int r, int c) { return ((r - c) % 12 + 12) % 12 < 2; }
bool dots(int r, int c) {
  const int x = (c + (r / 10 % 2) * 5) % 10 - 5, y = r % 10 - 5;
  return x * x + y * y < 6;
}
bool level(int r, int) { return r % 10 < 2; }
bool upright(int, int c) { return c % 10 < 2; }
bool close_slash(int r, int c) { return (r + c) % 6 < 2; }
bool diamonds(int r, int c) { return (r + c) % 16 < 2 || ((r - c) % 16 + 16) % 16 < 2; }
bool squares(int r, int c) { return r % 14 < 2 || c % 14 < 2; }
bool dashes(int r, int c) { return r % 8 < 2 && (c + (r / 8 % 2) * 9) % 18 < 9; }
bool close_backslash(int r, int c) { return ((r - c) % 6 + 6) % 6 < 2; }
bool ticks_up(int r, int c) { return c % 8 < 2 && (r + (c / 8 % 2) * 9) % 18 < 9; }
bool plain(int, int) { return false; }
bool crosses(int r, int c) {
  const int x = (c + (r / 12 % 2) * 6) % 12, y = r % 12;
  return (x < 2 && y < 7) || (y >= 2 && y < 4 && (x < 4 || x > 9));
}

}  // namespace

Colour diverging(double value) {
  static constexpr std::array<Colour, 11> anchors{{{0.020, 0.188, 0.380},
                                                   {0.129, 0.400, 0.675},
                                                   {0.263, 0.576, 0.765},
                                                   {0.573, 0.773, 0.871},
                                                   {0.820, 0.898, 0.941},
                                                   {0.969, 0.969, 0.969},
                                                   {0.992, 0.859, 0.780},
                                                   {0.957, 0.647, 0.510},
                                                   {0.839, 0.376, 0.302},
                                                   {0.698, 0.094, 0.169},
                                                   {0.404, 0.000, 0.122}}};
  return between(anchors, (value + 1) / 2);
}

Colour sequential(double value) {
  static constexpr std::array<Colour, 11> anchors{rgb(0x440154), rgb(0x482475), rgb(0x414487), rgb(0x355F8D), rgb(0x2A788E), rgb(0x21918C),
                                                  rgb(0x22A884), rgb(0x44BF70), rgb(0x7AD151), rgb(0xBDDF26), rgb(0xFDE725)};
  return between(anchors, value);
}

Interval colour_range(const ColourMap& map) {
  std::vector<double> values = drawable_values(map);
  if (values.empty()) return {-1, 1};
  if (map.scale == ColourMap::Scale::sequential) return even_range(std::move(values));
  for (double& v : values) v = std::abs(v);
  const double limit = quantile(values, inside_quantile);
  return limit > 0 ? Interval{-limit, limit} : Interval{-1, 1};
}

std::string beyond_the_colours(const ColourMap& map) {
  if (map.scale == ColourMap::Scale::classes) return "";
  const std::vector<double> values = drawable_values(map);
  if (values.empty()) return "";
  const Interval range = colour_range(map);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const bool below = *least<range.low, above = *most> range.high;
  if (!below && !above) return "";
  if (map.scale == ColourMap::Scale::diverging) return "beyond the colours: up to " + typeset(std::max(-*least, *most), 2);
  return "beyond the colours: " + (below ? "down to " + typeset(*least, 2) : "") + (below && above ? ", " : "") +
         (above ? "up to " + typeset(*most, 2) : "");
}

Colour colour_of(const ColourMap& map, const Interval& range, double value) {
  const double share = std::clamp((value - range.low) / (range.high - range.low), 0.0, 1.0);
  const double step = (std::min(std::floor(share * colour_levels), colour_levels - 1.0) + 0.5) / colour_levels;
  return map.scale == ColourMap::Scale::sequential ? sequential(step) : diverging(2 * step - 1);
}

// Tints that are neighbours in number lie far apart in hue; the lines are the tint, darkened.
Colour fill_of(int number, int row, int column) {
  static constexpr std::array<Fill, classes> fills{{{rgb(0xEAF6E6), rgb(0xEAF6E6), plain},
                                                    {rgb(0xFBD9C4), rgb(0xDB9A72), backslash},
                                                    {rgb(0xCFE0F3), rgb(0x86A9D4), dots},
                                                    {rgb(0xF6E8B0), rgb(0xC9AE55), level},
                                                    {rgb(0xDDD0EA), rgb(0xA387C4), upright},
                                                    {rgb(0xC9E8E0), rgb(0x7DB8AA), close_slash},
                                                    {rgb(0xF5CEDA), rgb(0xCC86A0), diamonds},
                                                    {rgb(0xE3DCCB), rgb(0xA89A78), squares},
                                                    {rgb(0xB9CCDC), rgb(0x6C8FAE), dashes},
                                                    {rgb(0xE9C3AE), rgb(0xB97F60), close_backslash},
                                                    {rgb(0xD3DFA9), rgb(0x93A654), ticks_up},
                                                    {rgb(0xC6B9D0), rgb(0x9A86AE), crosses}}};
  static constexpr Colour out_of_reach{0.80, 0.80, 0.80}, hatch{0.66, 0.66, 0.66};
  if (number < 0) return (row + column) % 12 < 2 ? hatch : out_of_reach;
  const Fill& fill = fills[static_cast<std::size_t>(number) % fills.size()];
  return fill.drawn(row, column) ? fill.line : fill.tint;
}

}  // namespace pmreport::figure
