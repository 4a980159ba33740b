#include <core/numbers.hpp>
#include <core/text/units.hpp>
#include <reports/figure/colour_scale.hpp>
#include <reports/figure/contour.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/workspace/grid_view.hpp>
#include <reports/section/workspace/slice.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pmreport::section {

namespace {

constexpr std::size_t fine_points = 361;                // about, along an axis: steps of half a point on the page
constexpr std::size_t most_told = figure::classes - 2;  // besides what is accepted and the others

// The margins, as their rounding lets them be read: not negative where the pose is accepted.
std::vector<std::vector<double>> readable(const scan::Field& field, const std::vector<mechanics::PoseMargin>& margins) {
  std::vector<std::vector<double>> out = field.margins;
  for (std::size_t m = 0; m < out.size(); ++m)
    for (double& x : out[m]) x += margins[m].rounding;
  return out;
}

// The first margin that refuses at a place; their number where none does. What is no number refuses.
std::size_t refused_by(const GridView& grid, const std::vector<std::vector<double>>& margins, double u, double v) {
  std::size_t m = 0;
  while (m < margins.size() && grid.between(margins[m], u, v) >= 0) ++m;
  return m;
}

// "ρ₁ min", "A₁ deflection max", "base cone 3 max".
std::string label_of(const mechanics::PoseMargin& margin) {
  if (!margin.name.ends_with('<') && !margin.name.ends_with('>')) return margin.name;
  std::string name = margin.name.substr(0, margin.name.size() - 1);
  if (name.find(' ') == std::string::npos) {
    const std::size_t end = std::min(name.find('_'), name.size());
    name = symbol(name.substr(0, end)) + name.substr(end);
    std::ranges::replace(name, '_', ' ');
  }
  return name + (margin.upper ? " max" : " min");
}

// Where a limit is reached and no other is broken, beside a point of the grid that is accepted: between points some of which cannot be
// assembled the margins tell too little.
figure::NamedLine line_of(std::size_t margin, const GridView& coarse, const GridView& fine, const std::vector<std::vector<double>>& margins,
                          const std::vector<double>& values, const std::string& label) {
  const auto bounds_what_is_accepted = [&](figure::Point p) {
    const double u = coarse.column(p.x), v = coarse.row(p.y);
    for (std::size_t m = 0; m < margins.size(); ++m)
      if (m != margin && !(coarse.between(margins[m], u, v) >= 0)) return false;
    const auto near = [](double at, double step, std::size_t count) {
      return std::clamp(std::floor(at) + step, 0.0, static_cast<double>(count - 1));
    };
    for (int i = -1; i <= 2; ++i)
      for (int j = -1; j <= 2; ++j)
        if (refused_by(coarse, margins, near(u, i, coarse.x.size()), near(v, j, coarse.y.size())) == margins.size()) return true;
    return false;
  };
  figure::NamedLine line{label, {}, {}};
  for (const figure::Stroke& stroke : figure::zero_lines(fine.x, fine.y, values, figure::largest, bounds_what_is_accepted)) {
    if (!line.x.empty()) line.x.push_back(nan), line.y.push_back(nan);
    for (const figure::Point p : stroke) line.x.push_back(p.x), line.y.push_back(p.y);
  }
  return line;
}

}  // namespace

std::vector<std::size_t> margins_to_tell(const std::vector<const scan::Field*>& fields, const std::vector<mechanics::PoseMargin>& margins) {
  std::vector<std::size_t> refused(margins.size());
  for (const scan::Field* field : fields) {
    const auto values = readable(*field, margins);
    for (std::size_t k = 0; k < values.front().size(); ++k) {
      std::size_t m = 0;
      while (m < values.size() && values[m][k] >= 0) ++m;
      if (m < values.size()) ++refused[m];
    }
  }
  std::vector<std::size_t> told(margins.size());
  std::iota(told.begin(), told.end(), std::size_t{0});
  std::erase_if(told, [&](std::size_t m) { return m == 0 || refused[m] == 0; });
  std::ranges::stable_sort(told, std::greater{}, [&](std::size_t m) { return refused[m]; });
  if (told.size() > most_told) told.resize(most_told);
  std::ranges::sort(told);
  return told;
}

figure::Panel slice_panel(const scan::Field& field, const std::array<Coordinate, 2>& coordinates,
                          const std::vector<mechanics::PoseMargin>& margins, const std::vector<std::size_t>& told) {
  const GridView grid(field.axes, coordinates);
  const std::vector<std::vector<double>> values = readable(field, margins);
  const GridView fine = grid.refined(fine_points);
  figure::Panel panel = fine.panel();
  figure::ColourMap map{fine.x, fine.y, {}, {}};
  map.scale = figure::ColourMap::Scale::classes;
  map.classes = {"accepted"};
  for (const std::size_t m : told) map.classes.push_back(label_of(margins[m]));
  map.classes.push_back("other limits");
  std::vector<double> columns, rows;
  for (const double x : fine.x) columns.push_back(grid.column(x));
  for (const double y : fine.y) rows.push_back(grid.row(y));
  for (const double v : rows)
    for (const double u : columns) {
      const std::size_t m = refused_by(grid, values, u, v);
      const auto at = std::ranges::find(told, m);
      const auto number = at != told.end() ? at - told.begin() + 1 : static_cast<std::ptrdiff_t>(told.size()) + 1;
      map.values.push_back(m == 0 ? nan : m == margins.size() ? 0 : static_cast<double>(number));
    }
  panel.map = std::move(map);
  for (std::size_t m = 0; m < margins.size(); ++m) {
    // What lies between numbers of one sign has that sign too.
    if (std::ranges::none_of(values[m], [](double x) { return x <= 0; }) ||
        std::ranges::none_of(values[m], [](double x) { return x >= 0; }))
      continue;
    std::vector<double> finely;
    finely.reserve(columns.size() * rows.size());
    for (const double v : rows)
      for (const double u : columns) finely.push_back(grid.between(values[m], u, v));
    figure::NamedLine line = line_of(m, grid, fine, values, finely, label_of(margins[m]));
    if (!line.x.empty()) panel.named.push_back(std::move(line));
  }
  return panel;
}

figure::Panel slice_panel(const scan::Field& field, const std::array<Coordinate, 2>& coordinates,
                          const std::vector<mechanics::PoseMargin>& margins) {
  return slice_panel(field, coordinates, margins, margins_to_tell({&field}, margins));
}

document::Data slice_data(const std::string& name, const scan::Field& field, const std::array<Coordinate, 2>& coordinates,
                          const std::vector<mechanics::PoseMargin>& margins) {
  const GridView grid(field.axes, coordinates);
  const auto values = readable(field, margins);
  document::Data data{name, {"refused_by"}, {{}, {}}, {{}}};
  for (const Coordinate& c : coordinates) data.headings.push_back(c.name + " [" + c.unit + "]");
  const std::size_t across = field.axes[0].count, up = field.axes[1].count;
  for (std::size_t i = 0; i < across; ++i)
    for (std::size_t j = 0; j < up; ++j) {
      std::size_t m = 0;
      while (m < values.size() && values[m][i * up + j] >= 0) ++m;
      data.words[0].push_back(m < margins.size() ? margins[m].name : "");
      data.columns[0].push_back(field.axes[0].value(i)), data.columns[1].push_back(field.axes[1].value(j));
    }
  return data;
}

}  // namespace pmreport::section
