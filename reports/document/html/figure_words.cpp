#include <reports/document/html/figure_words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <reports/figure/layout/axis.hpp>

namespace pmreport::document {

namespace {

using figure::Axis;
using figure::Panel;

std::string number(double value) { return figure::typeset(value == 0 ? 0 : value, 4); }

std::string with_unit(double value, const Axis& axis) { return number(value) + (axis.unit.empty() ? "" : " " + axis.unit); }

std::string of_axis(const Axis& axis, const char* unnamed) {
  return (axis.label.empty() ? unnamed : axis.label) + (axis.unit.empty() ? "" : " [" + axis.unit + "]");
}

std::string counted(std::size_t n, const char* one, const char* many) { return std::to_string(n) + " " + (n == 1 ? one : many); }

struct Extremes {
  double low = 0, high = 0, at_low = 0, at_high = 0;
  std::size_t points = 0;
  bool gaps = false;
};

Extremes extremes_of(const std::vector<double>& x, const std::vector<double>& y) {
  Extremes e;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
      e.gaps = true;
      continue;
    }
    if (e.points == 0 || y[i] < e.low) e.low = y[i], e.at_low = x[i];
    if (e.points == 0 || y[i] > e.high) e.high = y[i], e.at_high = x[i];
    ++e.points;
  }
  return e;
}

// "from 812.4 mm (at 0.5 s) to 900.1 mm (at 1.5 s), with gaps"
std::string told(const Extremes& e, const Axis& x, const Axis& y) {
  if (e.points == 0) return "no data";
  std::string out;
  if (e.high - e.low <= 1e-12 * std::max(std::abs(e.low), std::abs(e.high)))
    out = with_unit(e.low, y) + (e.points > 1 ? " throughout" : " at " + with_unit(e.at_low, x));
  else
    out = "from " + with_unit(e.low, y) + " (at " + with_unit(e.at_low, x) + ") to " + with_unit(e.high, y) + " (at " +
          with_unit(e.at_high, x) + ")";
  return out + (e.gaps ? ", with gaps" : "");
}

// Where curves stand on rows that have names, the rows are what they say.
std::string rows_told(const figure::Series& s, const Panel& panel) {
  std::string out;
  for (std::size_t row = 0; row < panel.y.names.size(); ++row) {
    double from = 0, to = 0;
    bool any = false;
    for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
      if (!std::isfinite(s.x[i]) || !std::isfinite(s.y[i]) || std::lround(s.y[i]) != static_cast<long>(row)) continue;
      from = any ? std::min(from, s.x[i]) : s.x[i];
      to = any ? std::max(to, s.x[i]) : s.x[i];
      any = true;
    }
    if (!any) continue;
    out += (out.empty() ? "" : "; ") + panel.y.names[row] + ": ";
    out += number(from) == number(to) ? "at " + with_unit(from, panel.x)
                                      : "between " + with_unit(from, panel.x) + " and " + with_unit(to, panel.x);
  }
  return out.empty() ? "no data" : out;
}

void tell_map(const figure::ColourMap& map, std::vector<std::string>& lines) {
  const std::size_t all = map.values.size();
  const auto share = [&](std::size_t n) {
    return number(all == 0 ? 0 : 100 * static_cast<double>(n) / static_cast<double>(all)) + " % of the map";
  };
  std::size_t missing = 0, known = 0;
  double low = 0, high = 0;
  std::vector<std::size_t> members(map.classes.size());
  for (const double v : map.values) {
    if (!std::isfinite(v)) {
      ++missing;
      continue;
    }
    low = known == 0 ? v : std::min(low, v);
    high = known == 0 ? v : std::max(high, v);
    ++known;
    if (v >= 0 && v < static_cast<double>(members.size())) ++members[static_cast<std::size_t>(v)];
  }
  if (map.scale == figure::ColourMap::Scale::classes) {
    for (std::size_t k = 0; k < members.size(); ++k)
      if (members[k] > 0) lines.push_back(map.classes[k] + ": " + share(members[k]));
  } else if (known > 0) {
    lines.push_back("colours: " + of_axis(map.bar, "values") + " from " + number(low) + " to " + number(high));
    if (!map.contour.empty() && low < map.level && high > map.level) lines.push_back("a contour where " + map.contour);
  }
  if (missing > 0) lines.push_back(map.missing + ": " + share(missing));
}

void tell_bands(const Panel& panel, std::vector<std::string>& lines) {
  for (const auto kind : {figure::Band::Kind::limit, figure::Band::Kind::unreachable}) {
    std::size_t bands = 0;
    double from = 0, to = 0;
    for (const figure::Band& band : panel.bands) {
      if (band.kind != kind || !std::isfinite(band.from) || !std::isfinite(band.to)) continue;
      from = bands == 0 ? band.from : std::min(from, band.from);
      to = bands == 0 ? band.to : std::max(to, band.to);
      ++bands;
    }
    if (bands == 0) continue;
    lines.push_back(fmt::format("shaded, {}: {} between {} and {}", kind == figure::Band::Kind::limit ? "limit broken" : "out of reach",
                                counted(bands, "stretch", "stretches"), with_unit(from, panel.x), with_unit(to, panel.x)));
  }
}

std::string heading_of(const Panel& panel, std::size_t position, std::size_t panels) {
  std::string out = panels > 1 ? "(" + figure::panel_letter(position) + ") " : "";
  if (!panel.title.empty()) out += panel.title + ": ";
  out += of_axis(panel.y, "values") + " against " + of_axis(panel.x, "position");
  double low = 0, high = 0;
  bool any = false;
  const auto reach = [&](const std::vector<double>& x) {
    for (const double v : x) {
      if (!std::isfinite(v)) continue;
      low = any ? std::min(low, v) : v;
      high = any ? std::max(high, v) : v;
      any = true;
    }
  };
  for (const figure::Series& series : panel.series) reach(series.x);
  if (panel.map) reach(panel.map->x);
  return any ? out + ", from " + number(low) + " to " + number(high) : out;
}

}  // namespace

std::vector<PanelWords> words_of(const figure::Figure& figure) {
  std::vector<PanelWords> all;
  for (std::size_t p = 0; p < figure.panels.size(); ++p) {
    const Panel& panel = figure.panels[p];
    PanelWords words{heading_of(panel, p, figure.panels.size()), {}};
    for (std::size_t s = 0; s < panel.series.size(); ++s) {
      const figure::Series& series = panel.series[s];
      const Extremes e = extremes_of(series.x, series.y);
      const std::string name = curve_name(figure, p, s);
      words.lines.push_back((name.empty() ? "curve " + std::to_string(s + 1) : name) + ": " +
                            (series.points ? counted(e.points, "point", "points") + ", " : "") +
                            (panel.y.names.empty() ? told(e, panel.x, panel.y) : rows_told(series, panel)));
    }
    if (panel.map) tell_map(*panel.map, words.lines);
    tell_bands(panel, words.lines);
    for (const figure::Line& line : panel.lines)
      if (std::isfinite(line.y))
        words.lines.push_back((line.label.empty() ? "level line" : line.label) + ": at " + with_unit(line.y, panel.y));
    for (const figure::NamedLine& line : panel.named)
      if (!line.label.empty()) words.lines.push_back(line.label + ": a line, " + told(extremes_of(line.x, line.y), panel.x, panel.y));
    all.push_back(std::move(words));
  }
  return all;
}

std::string curve_name(const figure::Figure& figure, std::size_t panel, std::size_t series) {
  const figure::Series& curve = figure.panels[panel].series[series];
  if (!curve.label.empty() || curve.style < 0) return curve.label;
  for (const Panel& other : figure.panels) {
    for (const figure::Series& alike : other.series)
      if (alike.style == curve.style && alike.points == curve.points && !alike.label.empty()) return alike.label;
  }
  return "";
}

std::string name_of(const figure::Figure& figure) {
  std::string titles;
  for (const Panel& panel : figure.panels) {
    const std::string& title = panel.title.empty() ? panel.y.label : panel.title;
    if (!title.empty()) titles += (titles.empty() ? "" : ", ") + title;
  }
  return titles.empty() ? "Plot" : "Plot of " + titles;
}

}  // namespace pmreport::document
