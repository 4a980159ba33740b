#include <reports/section/workspace/grid_view.hpp>

#include <core/text/units.hpp>
#include <reports/section/common/words/words.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pmreport::section {

namespace {

double place(const std::vector<double>& ticks, double at) {
  const double share = (at - ticks.front()) / (ticks.back() - ticks.front());
  return std::clamp(share, 0.0, 1.0) * static_cast<double>(ticks.size() - 1);
}

std::vector<double> between_ticks(const std::vector<double>& ticks, std::size_t parts) {
  std::vector<double> out;
  for (std::size_t k = 0; k + 1 < ticks.size(); ++k)
    for (std::size_t part = 0; part < parts; ++part)
      out.push_back(ticks[k] + (ticks[k + 1] - ticks[k]) * static_cast<double>(part) / static_cast<double>(parts));
  out.push_back(ticks.back());
  return out;
}

}  // namespace

GridView::GridView(const std::vector<scan::Axis>& axes, const std::array<Coordinate, 2>& coordinates) {
  if (axes.size() != 2) throw std::invalid_argument("expected a grid of two axes for a panel, saw " + std::to_string(axes.size()));
  std::array<double, 2> largest{};
  for (std::size_t k = 0; k < 2; ++k) {
    if (axes[k].count < 2) throw std::invalid_argument("expected two values or more on each axis of a panel, saw one");
    largest[k] = std::max(std::abs(axes[k].from), std::abs(axes[k].to));
  }
  // One unit for both where they are of one kind: a drawing has one scale.
  if (coordinates[0].unit == coordinates[1].unit) largest[0] = largest[1] = std::max(largest[0], largest[1]);
  for (std::size_t k = 0; k < 2; ++k) {
    const DisplayUnit unit = display_unit(coordinates[k].unit, largest[k]);
    names_[k] = {symbol(coordinates[k].name), unit.label};
    downward_[k] = axes[k].step() < 0;
    std::vector<double>& ticks = k == 0 ? x : y;
    for (std::size_t i = 0; i < axes[k].count; ++i) ticks.push_back(axes[k].value(i) * unit.per_si);
    if (downward_[k]) std::reverse(ticks.begin(), ticks.end());
  }
}

figure::Panel GridView::panel() const {
  figure::Panel panel;
  panel.x = names_[0], panel.y = names_[1];
  panel.equal = names_[0].unit == names_[1].unit;
  return panel;
}

GridView GridView::refined(std::size_t points) const {
  GridView out = *this;
  out.x = between_ticks(x, std::max<std::size_t>(1, points / (x.size() - 1)));
  out.y = between_ticks(y, std::max<std::size_t>(1, points / (y.size() - 1)));
  return out;
}

std::vector<double> GridView::rows(const std::vector<double>& values) const {
  std::vector<double> out;
  for (std::size_t j = 0; j < y.size(); ++j)
    for (std::size_t i = 0; i < x.size(); ++i) out.push_back(at(values, i, j));
  return out;
}

double GridView::column(double value) const { return place(x, value); }
double GridView::row(double value) const { return place(y, value); }

double GridView::at(const std::vector<double>& values, std::size_t column, std::size_t row) const {
  const std::size_t i = downward_[0] ? x.size() - 1 - column : column, j = downward_[1] ? y.size() - 1 - row : row;
  return values[i * y.size() + j];
}

double GridView::between(const std::vector<double>& values, double column, double row) const {
  const std::size_t i = std::min(static_cast<std::size_t>(column), x.size() - 2), j = std::min(static_cast<std::size_t>(row), y.size() - 2);
  const double a = column - static_cast<double>(i), b = row - static_cast<double>(j);
  double sum = 0, weight = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double value = at(values, i + (k & 1), j + (k >> 1)), share = ((k & 1) != 0 ? a : 1 - a) * ((k >> 1) != 0 ? b : 1 - b);
    if (share > 0 && !std::isnan(value)) sum += share * value, weight += share;
  }
  return weight > 0 ? sum / weight : std::nan("");
}

}  // namespace pmreport::section
