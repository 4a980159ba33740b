#include <reports/section/common/words.hpp>
#include <reports/section/singularity/singularity.hpp>

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

namespace pmreport::section {

namespace {

// The motion over the map; dashed where it is only projected, for its other coordinates are not those of the map.
std::optional<figure::Series> trace(const Analysis& a, const MapOptions& r, const double per_si[2]) {
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

}  // namespace

SingularityMap singularity_map(const Analysis& a, const MapOptions& request, double length) {
  const mechanics::Machine& m = a.machine();
  MapOptions r = request;
  if (r.at.size() == 0) r.at = m.home();
  const analysis::SingularityGrid grid = analysis::singularity_grid(m, r, length);
  const auto n = static_cast<std::size_t>(r.points);

  SingularityMap out;
  out.all = static_cast<int>(n * n);
  out.reachable = grid.reachable, out.negative = grid.negative, out.singular = grid.singular;

  figure::Axis axes[2];
  double per_si[2];
  std::vector<double> ticks[2];
  for (int k = 0; k < 2; ++k) {
    const Coordinate& c = m.topology().coordinates[static_cast<std::size_t>(r.coordinate[k])];
    const DisplayUnit d = display_unit(c.unit, std::max(std::abs(r.from[k]), std::abs(r.to[k])));
    axes[k] = {symbol(c.name), d.label};
    per_si[k] = d.per_si;
    for (std::size_t i = 0; i < n; ++i)
      ticks[k].push_back((r.from[k] + (r.to[k] - r.from[k]) * static_cast<double>(i) / static_cast<double>(n - 1)) * d.per_si);
  }
  std::string others;
  for (int i = 0; i < m.dof(); ++i)
    if (i != r.coordinate[0] && i != r.coordinate[1]) {
      const Coordinate& c = m.topology().coordinates[static_cast<std::size_t>(i)];
      others += fmt::format("{}{} = {}", others.empty() ? " at " : ", ", symbol(c.name), show(r.at(i), c.unit));
    }
  out.figure = {
      "singularity-map",
      fmt::format("Over {} and {}{}: (a) the determinant of Ĝ; (b) its smallest singular value with the sign of the determinant, the "
                  "distance from the singular surface. The strong line is that surface.",
                  axes[0].label, axes[1].label, others),
      "data/singularity-map.csv",
      figure::Width::full,
      2,
      {}};
  const std::optional<figure::Series> path = trace(a, r, per_si);
  for (const auto& [title, values] : {std::pair<std::string, const std::vector<double>*>{"determinant", &grid.determinant},
                                      {"smallest singular value, signed", &grid.smallest}}) {
    figure::Panel p;
    p.title = title;
    p.x = axes[0], p.y = axes[1];
    p.map = figure::ColourMap{ticks[0], ticks[1], *values, {values == &grid.determinant ? "det Ĝ" : "± σ₆", ""}, "det Ĝ = 0"};
    if (path) p.series.push_back(*path);
    out.figure.panels.push_back(std::move(p));
  }

  out.data.name = "singularity-map";
  out.data.columns.resize(4);
  for (int k = 0; k < 2; ++k) {
    const Coordinate& c = m.topology().coordinates[static_cast<std::size_t>(r.coordinate[k])];
    out.data.headings.push_back(fmt::format("{} [{}]", c.name, c.unit));
  }
  out.data.headings.insert(out.data.headings.end(), {"determinant", "smallest_singular_value"});
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t k = 0; k < n; ++k) {
      out.data.columns[0].push_back(ticks[0][k] / per_si[0]);
      out.data.columns[1].push_back(ticks[1][row] / per_si[1]);
      out.data.columns[2].push_back(grid.determinant[row * n + k]);
      out.data.columns[3].push_back(std::abs(grid.smallest[row * n + k]));
    }
  return out;
}

}  // namespace pmreport::section
