#include <reports/section/common/pose_map.hpp>

#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

// The motion over the map; dashed where it is only projected, for its other coordinates are not those of the map.
std::optional<figure::Series> trace(const Analysis& a, const analysis::PoseMap& r, const double per_si[2]) {
  const Eigen::MatrixXd& q = a.trajectory().value;
  figure::Series s{"motion", {}, {}, 0};
  bool moves = false;
  for (Eigen::Index k = 0; k < q.rows(); ++k) {
    s.x.push_back(q(k, r.coordinate[0]) * per_si[0]);
    s.y.push_back(q(k, r.coordinate[1]) * per_si[1]);
    moves = moves || s.x.back() != s.x.front() || s.y.back() != s.y.front();
    for (int i = 0; i < q.cols(); ++i)
      if (i != r.coordinate[0] && i != r.coordinate[1] && std::abs(q(k, i) - r.at(i)) > 1e-9) s.style = 1;
  }
  if (!moves) return std::nullopt;
  if (s.style == 1) s.label = "motion, projected";
  return s;
}

figure::ColourMap colours(const MapIndex& index, const std::vector<double>& x, const std::vector<double>& y) {
  double largest = 0;
  for (const double v : index.values)
    if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
  const DisplayUnit unit = index.unit.empty() ? DisplayUnit{"", 1} : display_unit(index.unit, largest);
  figure::ColourMap out{x, y, index.values, {index.symbol, unit.label}};
  for (double& v : out.values) v *= unit.per_si;
  out.scale = index.scale, out.missing = index.missing;
  if (index.contour) out.contour = index.contour->label, out.level = index.contour->level * unit.per_si;
  return out;
}

}  // namespace

DrawnMap draw_map(const Analysis& a, const analysis::PoseMap& map, const std::string& id, const std::string& what,
                  const std::vector<MapIndex>& indices) {
  const Topology& t = a.machine().topology();
  const auto n = static_cast<std::size_t>(map.points);
  const auto coordinate = [&](int i) -> const Coordinate& { return t.coordinates[static_cast<std::size_t>(i)]; };

  figure::Axis axes[2];
  double per_si[2];
  std::vector<double> ticks[2];
  for (int k = 0; k < 2; ++k) {
    const Coordinate& c = coordinate(map.coordinate[k]);
    const DisplayUnit d = display_unit(c.unit, std::max(std::abs(map.from[k]), std::abs(map.to[k])));
    axes[k] = {symbol(c.name), d.label};
    per_si[k] = d.per_si;
    for (std::size_t i = 0; i < n; ++i) ticks[k].push_back(map.value(k, i) * d.per_si);
  }
  std::string others;
  for (int i = 0; i < static_cast<int>(t.coordinates.size()); ++i)
    if (i != map.coordinate[0] && i != map.coordinate[1])
      others += fmt::format("{}{} = {}", others.empty() ? " at " : ", ", symbol(coordinate(i).name), show(map.at(i), coordinate(i).unit));

  DrawnMap out;
  out.figure = {id,
                fmt::format("Over {} and {}{}: {}", axes[0].label, axes[1].label, others, what),
                fmt::format("data/{}.csv", id),
                figure::Width::full,
                2,
                {}};
  const std::optional<figure::Series> path = trace(a, map, per_si);
  for (const MapIndex& index : indices) {
    figure::Panel p;
    p.title = index.title;
    p.x = axes[0], p.y = axes[1];
    p.map = colours(index, ticks[0], ticks[1]);
    if (path) p.series.push_back(*path);
    out.figure.panels.push_back(std::move(p));
  }

  out.data.name = id;
  for (int k = 0; k < 2; ++k) {
    const Coordinate& c = coordinate(map.coordinate[k]);
    out.data.headings.push_back(fmt::format("{} [{}]", c.name, c.unit));
    std::vector<double>& column = out.data.columns.emplace_back();
    for (std::size_t pose = 0; pose < n * n; ++pose) column.push_back(ticks[k][k == 0 ? pose % n : pose / n] / per_si[k]);
  }
  for (const MapIndex& index : indices) {
    out.data.headings.push_back(index.unit.empty() ? index.name : fmt::format("{} [{}]", index.name, index.unit));
    out.data.columns.push_back(index.values);
  }
  return out;
}

}  // namespace pmreport::section
