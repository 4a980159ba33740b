// Indices at given poses, over a map and over a grid.
#include <core/numbers.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/transmission/transmission.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmreport::section {

namespace {

std::string where(const Topology& t, const Eigen::VectorXd& home, const Eigen::VectorXd& q) {
  std::vector<std::string> parts;
  for (int i = 0; i < q.size(); ++i) {
    const Coordinate& c = t.coordinates[static_cast<std::size_t>(i)];
    if (std::abs(q(i) - home(i)) > 1e-12) parts.push_back(fmt::format("{} = {}", symbol(c.name), show(q(i), c.unit, 6)));
  }
  return parts.empty() ? "home" : listed(parts);
}

// What is left of an index on a singular surface by rounding.
double without_rounding(double x) { return std::abs(x) < 1e-12 ? 0 : x; }

std::string number(double x, int digits = 4) {
  return std::isfinite(x) ? typeset(format_number(without_rounding(x), digits)) : std::string("–");
}

// The least of a group of columns, or the largest, with the name of what it belongs to: "0.344 (ρ₁)".
std::string worst_of(const std::vector<Column>& columns, const std::vector<double>& numbers, const std::string& group, bool largest,
                     double scale) {
  std::size_t best = columns.size();
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].group == group && std::isfinite(numbers[i]) &&
        (best == columns.size() || (largest ? numbers[i] > numbers[best] : numbers[i] < numbers[best])))
      best = i;
  if (best == columns.size()) return "–";
  return fmt::format("{} ({})", number(numbers[best] * scale), symbol(analysis::owner_of(columns[best])));
}

std::size_t index_of(const std::vector<Column>& columns, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(columns, name, &Column::name) - columns.begin());
}

bool is_index(const Column& c) { return c.name != "manipulability" && c.name != "local_conditioning" && c.group != "pressure_angle"; }

}  // namespace

PosesOfTransmission transmission_poses(const Analysis& a, const std::vector<Eigen::VectorXd>& poses) {
  const mechanics::Transmission& t = *a.transmission();
  const Topology& topology = a.machine().topology();
  const std::vector<Column> columns = analysis::transmission_columns(topology);
  PosesOfTransmission out{
      {"Poses looked at.",
       {"pose", "where", "largest pressure angle [°]", "least output", "least input", "local", "conditioning", "manipulability"},
       {false, false, true, true, true, true, true, true},
       {}},
      {"transmission-poses", {"pose"}, {{}}},
      {},
      {}};
  const std::vector<std::string> reasons = analysis::why_without(t);
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (reasons[i].empty())
      out.data.headings.push_back(columns[i].unit.empty() ? columns[i].name : fmt::format("{} [{}]", columns[i].name, columns[i].unit)),
          out.data.columns.emplace_back();
  mechanics::Transmission::Work work;
  std::vector<double> numbers(columns.size());
  const auto at = [&](const char* name) { return numbers[index_of(columns, name)]; };
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Eigen::VectorXd& q = poses[k];
    analysis::transmission_numbers(t, {q.data(), static_cast<std::size_t>(q.size())}, work, numbers);
    const std::string place = where(topology, a.machine().home(), q);
    for (const char* name : {"least_cosine", "local_transmission", "local_conditioning"})
      out.values.push_back({"transmission", fmt::format("{}_{}", name, k + 1), "", at(name)});
    if (std::ranges::none_of(numbers, [](double x) { return std::isfinite(x); })) {
      out.refused.push_back(fmt::format("Pose {}, {}, cannot be assembled, or has no G.", k + 1, place));
      continue;
    }
    out.table.rows.push_back({fmt::format("pose {}", k + 1), place,
                              worst_of(columns, numbers, "pressure_angle", true, 180 / std::numbers::pi),
                              worst_of(columns, numbers, "output_transmission", false, 1),
                              worst_of(columns, numbers, "input_transmission", false, 1), number(at("local_transmission")),
                              number(at("local_conditioning")), std::isinf(at("manipulability")) ? "∞" : number(at("manipulability"))});
    out.data.columns[0].push_back(static_cast<double>(k + 1));
    for (std::size_t i = 0, c = 1; i < columns.size(); ++i)
      if (reasons[i].empty()) out.data.columns[c++].push_back(numbers[i]);
  }
  return out;
}

MapOfTransmission transmission_map(const Analysis& a, const MapRequest& request) {
  const mechanics::Transmission& t = *a.transmission();
  const std::vector<Column> columns = analysis::transmission_columns(a.machine().topology());
  MapRequest map = request;
  if (map.at.size() == 0) map.at = a.machine().home();
  std::vector<std::size_t> shown;
  for (const std::string& name : map.show) shown.push_back(index_of(columns, name));
  const std::vector<std::vector<double>> values = analysis::over_map(map, shown.size(), [&] {
    return [&t, &shown, work = mechanics::Transmission::Work(), numbers = std::vector<double>(columns.size())](
               std::span<const double> q, std::span<double> out) mutable {
      analysis::transmission_numbers(t, q, work, numbers);
      for (std::size_t i = 0; i < shown.size(); ++i) out[i] = numbers[shown[i]];
    };
  });

  MapOfTransmission out;
  std::vector<MapIndex> indices;
  std::vector<std::string> panels, sentences;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Column& c = columns[shown[i]];
    MapIndex index{c.name, c.unit, c.title, c.unit.empty() ? "index" : "angle", values[i]};
    if (c.group == "pressure_angle") index.contour = {std::acos(analysis::good_transmission), "cos = 0.7"};
    if (is_index(c)) index.contour = {analysis::good_transmission, "0.7"};
    indices.push_back(std::move(index));
    panels.push_back(shown.size() > 1 ? fmt::format("({}) {}", static_cast<char>('a' + i), c.title) : c.title);

    double sum = 0, least = nan, most = nan;
    std::size_t count = 0, good = 0;
    for (const double x : values[i]) {
      if (std::isnan(x)) continue;
      sum += x, ++count, good += x >= analysis::good_transmission ? 1 : 0;
      least = std::isnan(least) ? x : std::min(least, x), most = std::isnan(most) ? x : std::max(most, x);
    }
    const double mean = count > 0 ? sum / static_cast<double>(count) : nan;
    for (const auto& [name, value] : {std::pair{"map_min_", least}, {"map_max_", most}, {"map_mean_", mean}})
      out.values.push_back({"transmission", name + c.name, c.unit, value});
    if (count > 0)
      sentences.push_back(fmt::format("{} is {} to {}, {} in the mean{}", c.name, show(without_rounding(least), c.unit), show(most, c.unit),
                                      show(mean, c.unit),
                                      is_index(c) ? fmt::format(", and 0.7 or more at {} of {} poses", good, count) : ""));
  }
  const bool line = std::ranges::any_of(indices, [](const MapIndex& index) {
    const double level = index.contour ? index.contour->level : nan;
    return std::ranges::any_of(index.values, [&](double x) { return x < level; }) &&
           std::ranges::any_of(index.values, [&](double x) { return x > level; });
  });
  out.drawn = draw_map(a, map, "transmission-map",
                       listed(panels) + (line ? ". The strong line is where a transmission of 0.7 begins." : "."), indices);
  out.told = sentences.empty() ? "No pose of the map can be assembled." : fmt::format("Over the map {}.", fmt::join(sentences, "; "));
  return out;
}

GridOfTransmission transmission_over_grid(const Analysis& a, const analysis::GridRequest& request) {
  const Topology& topology = a.machine().topology();
  const std::vector<Column> columns = analysis::transmission_columns(topology);
  GridOfTransmission out;
  std::string why;
  const auto grid = analysis::transmission_grid(*a.transmission(), request, &why);
  const auto value = [&](const std::string& name, const std::string& unit, double x) {
    out.values.push_back({"transmission", name, unit, x});
  };
  if (!grid) {
    out.told = "The grid is not looked at: " + why + ".";
    return out;
  }
  std::vector<std::string> ranges;
  for (const analysis::ScanRange& r : request.ranges) {
    const Coordinate& c = topology.coordinates[static_cast<std::size_t>(r.coordinate)];
    ranges.push_back(fmt::format("{}{} of {} from {} to {}", r.count, ranges.empty() ? " values" : "", symbol(c.name),
                                 show(r.from, c.unit, 6), show(r.to, c.unit, 6)));
  }
  std::vector<std::string> kept;
  if (request.strokes) kept.emplace_back("strokes");
  if (request.joints) kept.emplace_back("limits of joints");
  out.table = document::Table{fmt::format("Over a grid of {}: {} poses, of which {} can be assembled{}. Each of these weighs alike.",
                                          listed(ranges), grid->poses, grid->accepted, kept.empty() ? "" : " and keep " + listed(kept)),
                              {"index", "worst", "where", "mean", "best", "0.7 or more"},
                              {false, true, false, true, true, true},
                              {}};
  const auto degrees = [](const Column& c) { return c.unit == "rad" ? 180 / std::numbers::pi : 1.0; };
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const analysis::IndexOverGrid& index = grid->indices[i];
    const Column& c = columns[i];
    if (index.counted > 0) {
      const bool angle = c.group == "pressure_angle";  // the larger the worse
      const double worst = angle ? index.most : index.least, best = angle ? index.least : index.most;
      const double share = 100.0 * static_cast<double>(index.good) / static_cast<double>(index.counted);
      out.table->rows.push_back({angle ? c.name + " [°]" : c.name, number(worst * degrees(c)),
                                 where(topology, a.machine().home(), angle ? index.most_at : index.least_at),
                                 number(index.mean * degrees(c)), std::isinf(best) ? "∞" : number(best * degrees(c)),
                                 is_index(c) ? fmt::format("{:.1f} %", share) : ""});
    }
    if (c.group != c.name) continue;  // of the machine as a whole
    value("min_" + c.name, "", index.least), value("max_" + c.name, "", index.most), value("mean_" + c.name, "", index.mean);
    if (c.name == "local_transmission")
      value("good_share", "", index.counted > 0 ? static_cast<double>(index.good) / static_cast<double>(index.counted) : nan);
  }
  value("poses", "", static_cast<double>(grid->poses)), value("accepted", "", static_cast<double>(grid->accepted));
  if (!grid->left_out.empty())
    out.told = fmt::format("The geometry leaves the motion of {} open: their limits are not judged on the grid.", listed(grid->left_out));
  return out;
}

}  // namespace pmreport::section
