// An index, counts and outlines over two coordinates.
#include <core/numbers.hpp>
#include <reports/figure/contour.hpp>
#include <reports/section/workspace/grid_view.hpp>
#include <reports/section/workspace/slice.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

figure::Panel map_panel(const GridView& grid, const std::vector<double>& values, const figure::Axis& bar, const std::string& missing) {
  figure::Panel panel = grid.panel();
  figure::ColourMap map{grid.x, grid.y, grid.rows(values), bar};
  map.scale = figure::ColourMap::Scale::sequential;
  map.missing = missing;
  panel.map = std::move(map);
  return panel;
}

}  // namespace

figure::Panel index_panel(const std::vector<scan::Axis>& axes, const std::vector<double>& values,
                          const std::array<Coordinate, 2>& coordinates, const figure::Axis& bar) {
  figure::Panel panel = map_panel(GridView(axes, coordinates), values, bar, "refused");
  const bool below = std::ranges::any_of(values, [](double v) { return v < 0; });
  const bool above = std::ranges::any_of(values, [](double v) { return v > 0; });
  if (below && above) {
    panel.map->scale = figure::ColourMap::Scale::diverging;
    panel.map->contour = bar.label + " = 0";
  }
  return panel;
}

figure::Panel counts_panel(const std::vector<scan::Axis>& axes, const std::vector<std::uint32_t>& accepted_at,
                           const std::array<Coordinate, 2>& coordinates, std::size_t all) {
  std::vector<double> values;
  for (const std::uint32_t n : accepted_at) values.push_back(n == 0 ? nan : n);
  return map_panel(GridView(axes, coordinates), values, {"accepted of " + std::to_string(all), ""}, "none accepted");
}

std::vector<double> largest_along_others(const std::vector<scan::Axis>& axes, const std::vector<double>& value, std::size_t first,
                                         std::size_t second) {
  const std::size_t columns = axes[second].count;
  std::vector<double> out(axes[first].count * columns, nan);
  std::vector<std::size_t> at(axes.size(), 0);
  for (const double x : value) {
    double& best = out[at[first] * columns + at[second]];
    if (!(best >= x)) best = std::isnan(x) ? best : x;
    for (std::size_t k = axes.size(); k-- > 0;) {
      if (++at[k] < axes[k].count) break;
      at[k] = 0;
    }
  }
  return out;
}

// A frame of points outside, at the places of the grid's own rim, closes an outline along it.
figure::Panel outline_panel(const std::vector<scan::Axis>& axes, const std::vector<double>& value,
                            const std::array<Coordinate, 2>& coordinates, const std::string& label) {
  const GridView grid(axes, coordinates);
  double least = -1;
  for (const double v : value)
    if (std::isfinite(v)) least = std::min(least, -std::abs(v));
  const auto framed = [](std::vector<double> ticks) {
    ticks.insert(ticks.begin(), ticks.front());
    ticks.push_back(ticks.back());
    return ticks;
  };
  const std::vector<double> x = framed(grid.x), y = framed(grid.y), rows = grid.rows(value);
  std::vector<double> values(x.size() * y.size(), least);
  for (std::size_t j = 0; j < grid.y.size(); ++j)
    for (std::size_t i = 0; i < grid.x.size(); ++i)
      if (const double v = rows[j * grid.x.size() + i]; std::isfinite(v)) values[(j + 1) * x.size() + i + 1] = v;
  figure::Panel panel = grid.panel();
  figure::NamedLine line{label, {}, {}};
  for (const figure::Stroke& stroke : figure::zero_lines(x, y, values)) {
    if (!line.x.empty()) line.x.push_back(nan), line.y.push_back(nan);
    for (const figure::Point p : stroke) line.x.push_back(p.x), line.y.push_back(p.y);
  }
  panel.named.push_back(std::move(line));
  return panel;
}

}  // namespace pmreport::section
