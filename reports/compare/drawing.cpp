#include <reports/compare/drawing.hpp>
#include <reports/compare/words.hpp>

#include <core/text/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::compare {

namespace {

// Name and SI unit of a heading: "x [m]", "condition".
std::pair<std::string, std::string> parts_of(const std::string& heading) {
  const std::size_t open = heading.rfind(" [");
  if (open == std::string::npos || !heading.ends_with(']')) return {heading, ""};
  return {heading.substr(0, open), heading.substr(open + 2, heading.size() - open - 3)};
}

struct DrawnCurve {
  std::size_t report;
  const std::vector<double>&time, &y;
};

std::vector<DrawnCurve> curves_of(const Comparison& c, const CurveRow& row) {
  std::vector<DrawnCurve> out;
  for (std::size_t r = 0; r < row.sources.size(); ++r) {
    if (!row.sources[r]) continue;
    const Curves& curves = c.reports[r]->curves[row.sources[r]->curves];
    out.push_back({r, curves.time, curves.columns[row.sources[r]->column]});
  }
  return out;
}

double largest_drawn(const std::vector<double>& y) {
  double out = 0;
  for (const double v : y)
    if (std::isfinite(v)) out = std::max(out, std::abs(v));
  return out;
}

std::vector<double> scaled(std::vector<double> y, double factor) {
  for (double& v : y) v *= factor;
  return y;
}

figure::Panel panel_of(const std::string& title, const std::string& label, const std::string& unit) {
  figure::Panel out;
  out.title = title;
  out.x = {"time", "s"};
  out.y = {label, unit};
  return out;
}

figure::Figure figure_of(const Comparison& c, const CurveRow& row, std::size_t number) {
  const auto [name, si] = parts_of(row.heading);
  const std::vector<DrawnCurve> curves = curves_of(c, row);
  double largest = 0, largest_difference = 0;
  std::vector<std::vector<double>> differences;
  const DrawnCurve& first = curves.front();
  for (const DrawnCurve& curve : curves) {
    largest = std::max(largest, largest_drawn(curve.y));
    std::vector<double> difference(first.time.size());
    for (std::size_t i = 0; i < first.time.size(); ++i) {
      const double seen =
          curve.time == first.time ? curve.y[i] : read_between(curve.time, curve.y, first.time[i], nth_of_instant(first.time, i));
      difference[i] = seen - first.y[i];
    }
    largest_difference = std::max(largest_difference, largest_drawn(difference));
    differences.push_back(std::move(difference));
  }
  const DisplayUnit unit = display_unit(si, largest), fine = display_unit(si, largest_difference);
  figure::Panel over = panel_of(name, name, unit.label), apart = panel_of("difference", "difference", fine.label);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string who = letter(curves[i].report);
    const int style = static_cast<int>(curves[i].report);
    over.series.push_back({who, curves[i].time, scaled(curves[i].y, unit.per_si), style});
    if (i > 0) apart.series.push_back({who + " − " + letter(first.report), first.time, scaled(differences[i], fine.per_si), style});
  }
  figure::Figure out;
  out.id = fmt::format("compare-{}", number);
  std::string found = row.difference == 0
                          ? "no difference where both have values"
                          : fmt::format("largest difference {} at t = {} s",
                                        format_number(row.difference * fine.per_si, 3) + (fine.label.empty() ? "" : " " + fine.label),
                                        format_number(row.at, 6));
  if (row.gap) found += "; somewhere one has a value and another has none";
  out.caption = fmt::format("{} of {}: {}.", name, row.section, found);
  out.width = figure::Width::column;
  out.columns = 1;
  out.panels = {std::move(over), std::move(apart)};
  return out;
}

bool to_be_drawn(const CurveRow& row) {
  return (row.differs || row.other_instants) &&
         std::ranges::count_if(row.sources, [](const auto& source) { return source.has_value(); }) > 1;
}

}  // namespace

std::size_t curves_to_draw(const Comparison& c) { return static_cast<std::size_t>(std::ranges::count_if(c.curves, to_be_drawn)); }

std::vector<figure::Figure> figures_of(const Comparison& c) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < c.curves.size(); ++i)
    if (to_be_drawn(c.curves[i])) chosen.push_back(i);
  std::ranges::stable_sort(chosen, std::greater<>(), [&](std::size_t i) { return std::pair(c.curves[i].gap, c.curves[i].relative); });
  chosen.resize(std::min(chosen.size(), most_drawn));
  std::ranges::sort(chosen);
  std::vector<figure::Figure> out;
  for (const std::size_t i : chosen) out.push_back(figure_of(c, c.curves[i], out.size() + 1));
  return out;
}

}  // namespace pmreport::compare
