#include <reports/section/workspace/keys.hpp>

#include <core/mechanics/workspace/tool_point.hpp>
#include <core/scenario/section/keys.hpp>
#include <reports/section/common/scan_ranges.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace pmreport::section {

using analysis::ScanMethod;
using analysis::ScanRange;
using scenario::Entry;
using scenario::Reading;
using scenario::Shape;
using scenario::Value;
namespace keys = scenario::keys;
using O = WorkspaceOptions;

namespace {

const std::vector<std::string> methods{"proof", "grid", "monte-carlo"};
const std::vector<std::string> groups{"strokes", "joints"};
const std::vector<std::string> maps{"condition", "determinant"};
constexpr std::size_t most_orientations = 1'000'000, most_slices = 12;

void read_methods(const Entry& e, const Reading& r, O& options) {
  options.request.methods.clear();
  const std::vector<Value> items = e.value.kind == Value::Kind::array ? items_of(e, methods.size(), r.reader) : std::vector<Value>{e.value};
  for (const Value& item : items)
    if (const auto word = r.reader.word(item, methods, "the methods"))
      add_once(options.request.methods, static_cast<ScanMethod>(*word), item, r.reader);
}

void read_groups(const Entry& e, const Reading& r, O& options) {
  options.request.limits.strokes = options.request.limits.joints = false;
  if (e.value.kind == Value::Kind::array && e.value.items.empty()) return;
  std::vector<std::size_t> seen;
  for (const Value& item : items_of(e, groups.size(), r.reader))
    if (const auto word = r.reader.word(item, groups, "the groups of limits")) {
      add_once(seen, *word, item, r.reader);
      (*word == 0 ? options.request.limits.strokes : options.request.limits.joints) = true;
    }
}

// Ranges that are tried in every combination, or a list of poses.
void read_orientations(const Entry& e, const Reading& r, O& options) {
  if (!r.mechanism.topology) return;
  if (e.value.kind == Value::Kind::table) {
    options.request.orientations = read_scan_ranges(e, "section.orientations", r);
    for (const ScanRange& range : options.request.orientations)
      if (range.count == 0)
        r.reader.diagnostics().add(e.value.place, "expected how many values each orientation takes",
                                   "write alpha = [\"-60 deg\", \"60 deg\", 13]");
    for (const ScanRange& range : options.request.orientations) options.request.turned.push_back(range.coordinate);
    return;
  }
  std::set<std::vector<double>> seen;
  for (const Value& item : items_of(e, most_orientations, r.reader)) {
    const auto q = read_pose(item, "orientations", r.mechanism, r.reader);
    if (!q) continue;
    for (const Entry& given : item.entries) {
      const int i = scenario::index_of(*r.mechanism.topology, given.key);
      if (i >= 0 && std::ranges::find(options.request.turned, i) == options.request.turned.end()) options.request.turned.push_back(i);
    }
    if (!seen.insert({q->data(), q->data() + q->size()}).second) {
      r.reader.diagnostics().add(item.place, "this orientation is given twice, and would count twice", "remove one of the two");
      continue;
    }
    options.request.orientation_list.push_back(*q);
  }
}

void read_at_least(const Entry& e, const Reading& r, O& options) {
  const std::vector<Value> items = e.value.kind == Value::Kind::array ? items_of(e, 100, r.reader) : std::vector<Value>{e.value};
  for (const Value& item : items)
    if (const auto n = r.reader.integer(item, 1, static_cast<double>(most_orientations)))
      add_once(options.request.at_least, static_cast<std::uint64_t>(*n), item, r.reader);
}

// What coordinates are held at; NaN of those that are not named.
Eigen::VectorXd read_held(const Value& value, const char* where, const Reading& r) {
  const auto pose = read_pose(value, where, r.mechanism, r.reader);
  if (!pose) return {};
  Eigen::VectorXd out = Eigen::VectorXd::Constant(pose->size(), std::nan(""));
  for (const Entry& e : value.entries)
    if (const int i = scenario::index_of(*r.mechanism.topology, e.key); i >= 0) out(i) = (*pose)(i);
  return out;
}

void read_slices(const Entry& e, const Reading& r, O& options) {
  if (!r.mechanism.topology) return;
  for (const Value& item : items_of(e, most_slices, r.reader)) options.slices.push_back(read_held(item, "slices", r));
}

void read_tool(const Entry& e, const Reading& r, O& options) {
  if (e.value.kind == Value::Kind::refused) return;
  if (e.value.kind != Value::Kind::array || e.value.items.size() != 3) {
    r.reader.diagnostics().add(e.value.place, fmt::format("expected the tool point in the platform's axes, seen {}", name_of(e.value)),
                               "write tool = [\"0 mm\", \"0 mm\", \"-120 mm\"]");
    return;
  }
  Eigen::Vector3d at;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto x = r.reader.quantity(e.value.items[k], Dimension{1, 0, 0, 0});
    if (!x) return;
    at(static_cast<Eigen::Index>(k)) = *x;
  }
  std::string why;
  if (r.mechanism.machine && !mechanics::ToolPoint::of(*r.mechanism.machine, at, &why))
    r.reader.diagnostics().add(e.place, "no tool point can be scanned: " + why,
                               "remove tool; the platform's reference point is scanned then");
  options.request.tool = at;
}

void read_number_above_zero(const Entry& e, const Reading& r, const Dimension& dimension, double& to) {
  const auto x = r.reader.quantity(e.value, dimension);
  if (x && !(*x > 0)) r.reader.diagnostics().add(e.value.place, fmt::format("expected {} above 0, seen {}", e.key, *x));
  if (x) to = *x;
}

void read_name(const Entry& e, const Reading& r, O& options) { options.name = read_section_name(e.value, r.reader); }

void read_proportions(const Entry& e, const Reading& r, O& options) {
  if (!r.mechanism.topology) return;
  const Value* table = table_of(&e, "section.proportions", r.reader);
  if (table == nullptr) return;
  options.request.proportions.assign(r.mechanism.topology->coordinates.size(), std::nan(""));
  for (const Entry& given : table->entries) {
    const int i = scenario::index_of(*r.mechanism.topology, given.key);
    if (i < 0) {
      refuse_coordinate(given.place, given.key, r.mechanism, {}, "proportions", r.reader.diagnostics());
      continue;
    }
    read_number_above_zero(given, r, parse_unit(r.mechanism.topology->coordinates[static_cast<std::size_t>(i)].unit)->dimension,
                           options.request.proportions[static_cast<std::size_t>(i)]);
  }
}

}  // namespace

std::string quantity_name(const O& options, const std::string& own) {
  return "workspace." + (options.name.empty() ? "" : options.name + ".") + own;
}

std::vector<scenario::Key> workspace_keys() {
  const Shape value = Shape::quantity(std::nullopt);
  const Shape range = Shape::list(2, 3, value);
  const auto whole = [](std::string name, std::uint64_t analysis::WorkspaceRequest::*to, double most, std::string meaning) {
    return keys::of<O>(std::move(name), Shape::whole(1, most), std::move(meaning), std::to_string(analysis::WorkspaceRequest().*to),
                       [=](const Entry& e, const Reading& r, O& options) {
                         if (const auto n = r.reader.integer(e.value, 1, most)) options.request.*to = static_cast<std::uint64_t>(*n);
                       });
  };
  const auto flag = [](std::string name, bool analysis::WorkspaceRequest::*to, std::string meaning) {
    return keys::of<O>(std::move(name), Shape::boolean(), std::move(meaning), analysis::WorkspaceRequest().*to ? "`true`" : "`false`",
                       [=](const Entry& e, const Reading& r, O& options) {
                         options.request.*to = r.reader.boolean(e.value).value_or(options.request.*to);
                       });
  };
  return {
      keys::of<O>("name", Shape::text(), "of this section among several: checks then write `workspace.NAME.volume`", "none", read_name),
      keys::of<O>("method", Shape::either({Shape::word(methods), Shape::list(1, 3, Shape::word(methods))}),
                  "a proved bracket, counts of a grid, or random poses; of several each is evidence for the others", "`\"proof\"`",
                  read_methods),
      keys::required(
          keys::of<O>("scan", Shape::values_of("coordinates"),
                      "ranges of the coordinates that are scanned, of a grid with how many values, `{x = [\"-300 mm\", \"300 "
                      "mm\", 61]}`",
                      "",
                      [](const Entry& e, const Reading& r, O& options) { options.request.scan = read_scan_ranges(e, "section.scan", r); }),
          "scan = { x = [\"-300 mm\", \"300 mm\", 61], y = [\"-300 mm\", \"300 mm\", 61] }"),
      keys::of<O>("at", Shape::values_of("coordinates"), "what the other coordinates are held at", "home",
                  [](const Entry& e, const Reading& r, O& options) {
                    if (r.mechanism.topology) options.request.at = read_held(e.value, "at", r);
                  }),
      keys::of<O>("tool", Shape::list(3, 3, Shape::quantity(Dimension{1, 0, 0, 0})),
                  "a point of the platform, in its axes, that is scanned in place of its reference point: coordinates of the "
                  "place are this point's",
                  "the reference point", read_tool),
      keys::of<O>("limits", Shape::list(0, 2, Shape::word(groups)), "groups of the mechanism's limits that count", "all", read_groups),
      keys::of<O>("limit", limit_shape(), "what a pose must keep besides", "none",
                  [](const Entry& e, const Reading& r, O& options) { options.request.limits.asked = read_asked_limits(e, r); }),
      keys::of<O>("orientations",
                  Shape::either({Shape::values_of("coordinates"), Shape::list(1, most_orientations, Shape::values_of("coordinates"))}),
                  "tried at every point: ranges with how many values, in every combination, or a list of poses", "the one of `at`",
                  read_orientations),
      keys::of<O>("at_least", Shape::either({Shape::whole(1, most_orientations), Shape::list(1, 100, Shape::whole(1, most_orientations))}),
                  "how many of them must be within at a point, one answer each", "1, and all", read_at_least),
      flag("one_sheet", &analysis::WorkspaceRequest::one_sheet,
           "whether a grid tells what is connected with home without a change of sign of det G"),
      flag("reasons", &analysis::WorkspaceRequest::reasons, "whether it is counted which limits refuse a pose"),
      keys::of<O>("gap", Shape::quantity(Dimension{}), "of a proof: relative width of the bracket at which it is enough", "`0.001`",
                  [](const Entry& e, const Reading& r, O& options) { read_number_above_zero(e, r, {}, options.request.gap); }),
      keys::of<O>("time_limit", Shape::quantity(Dimension{0, 0, 1, 0}), "of a proof: when it gives up", "never",
                  [](const Entry& e, const Reading& r, O& options) {
                    read_number_above_zero(e, r, {0, 0, 1, 0}, options.request.seconds);
                  }),
      whole("poses", &analysis::WorkspaceRequest::poses, 1e12, "how many random poses"),
      whole("seed", &analysis::WorkspaceRequest::seed, 1e15, "of the random poses"),
      flag("safe", &analysis::WorkspaceRequest::safe,
           "whether the largest box and ball around home are proved, as limits for a controller"),
      keys::of<O>("proportions", Shape::values_of("coordinates"), "of the safe box, as half widths", "those of the scanned ranges",
                  read_proportions),
      keys::of<O>("slices", Shape::list(1, most_slices, Shape::values_of("coordinates")), "values at which slices are drawn",
                  "through home", read_slices),
      keys::of<O>("map", Shape::word(maps), "an index that is drawn over the slices", "none",
                  [](const Entry& e, const Reading& r, O& options) {
                    if (const auto word = r.reader.word(e.value, maps, "the maps")) options.map = maps[*word];
                  }),
      keys::boolean<O>("pictures", &O::pictures, "whether the boundary is drawn in space"),
      keys::boolean<O>("exports", &O::exports, "whether its surface and counts are written as STL, PLY and NPY")};
}

void complete_workspace(scenario::TableReader& table, const Reading& r, scenario::Options& plain) {
  auto& options = static_cast<O&>(plain);
  analysis::WorkspaceRequest& request = options.request;
  scenario::Diagnostics& diagnostics = r.reader.diagnostics();
  if (!r.mechanism.topology) return;
  const auto& coordinates = r.mechanism.topology->coordinates;
  const auto name = [&](int i) { return coordinates[static_cast<std::size_t>(i)].name; };
  const Entry *scan = table.find("scan"), *at = table.find("at"), *orientations = table.find("orientations"),
              *at_least = table.find("at_least"), *proportions = table.find("proportions");

  // A range of one value holds a coordinate.
  for (const ScanRange& range : request.scan)
    if (range.from == range.to) {
      if (request.at.size() == 0) {
        request.at = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(coordinates.size()), std::nan(""));
      }
      request.at(range.coordinate) = range.from;
    }
  std::erase_if(request.scan, [](const ScanRange& range) { return range.from == range.to; });
  // In the order of the coordinates, whatever that of the keys: pictures, files and other scenarios take the axes as they come.
  std::ranges::sort(request.scan, {}, &ScanRange::coordinate);
  if (request.scan.empty() && scan != nullptr && scan->value.kind == Value::Kind::table && !scan->value.entries.empty() &&
      diagnostics.empty())
    diagnostics.add(scan->value.place, "expected a range of at least one coordinate, and all are held at one value");

  const auto scanned = [&](int i) {
    return std::ranges::any_of(request.scan, [&](const ScanRange& range) { return range.coordinate == i; });
  };
  const auto turned = [&](int i) { return std::ranges::find(request.turned, i) != request.turned.end(); };
  if (at != nullptr)
    for (const Entry& e : at->value.entries)
      if (const int i = scenario::index_of(*r.mechanism.topology, e.key); i >= 0 && (scanned(i) || turned(i)))
        diagnostics.add(e.place,
                        fmt::format("{} is {} and cannot be held at a value", e.key, scanned(i) ? "scanned" : "set by the orientations"),
                        "remove it from at");
  for (const int i : request.turned)
    if (scanned(i))
      diagnostics.add(orientations->place, fmt::format("{} is scanned, and cannot be set by the orientations too", name(i)),
                      "keep one of the two");
  const bool grid = std::ranges::find(request.methods, ScanMethod::grid) != request.methods.end();
  for (const ScanRange& range : request.scan)
    if (grid && range.count == 0)
      diagnostics.add(scan->value.place, fmt::format("a grid needs to know how many values {} takes", name(range.coordinate)),
                      fmt::format("write {} = [\"...\", \"...\", 61]", name(range.coordinate)));
  double count = static_cast<double>(request.orientation_list.size());
  if (!request.orientations.empty()) {
    count = 1;
    for (const ScanRange& range : request.orientations) count *= static_cast<double>(range.count);
    if (count > static_cast<double>(most_orientations))
      diagnostics.add(orientations->value.place, fmt::format("expected at most {} orientations, seen {:.0f}", most_orientations, count));
  }
  for (const std::uint64_t n : request.at_least)
    if (count > 0 && static_cast<double>(n) > count)
      diagnostics.add(at_least->value.place, fmt::format("expected at most the {:.0f} orientations that there are, seen {}", count, n));
  const bool proof_alone = request.methods == std::vector{ScanMethod::proof};
  const auto pose_by_pose = [](const mechanics::AskedLimit& a) {
    return std::holds_alternative<mechanics::AskedCondition>(a.what) || std::holds_alternative<mechanics::AskedCompliance>(a.what) ||
           a.every;
  };
  if (const Entry* limit = table.find("limit"); limit != nullptr && proof_alone && std::ranges::any_of(request.limits.asked, pose_by_pose))
    diagnostics.add(limit->place,
                    "no proof looks at condition numbers, at compliances, or at what every orientation must keep, and the section has no "
                    "other method",
                    "write method = \"grid\" or \"monte-carlo\", alone or besides");
  if (count > 0 && request.at_least.empty()) {
    request.at_least = {1};
    if (count > 1) request.at_least.push_back(static_cast<std::uint64_t>(count));
  }
  if (request.one_sheet && !grid)
    diagnostics.add(table.find("one_sheet")->place, "one_sheet is told of a grid, and the section counts none",
                    "write method = \"grid\", or remove it");
  if (at_least != nullptr && orientations == nullptr)
    diagnostics.add(at_least->place, "at_least counts orientations, and the section has none", "add orientations, or remove it");
  if (request.one_sheet && !request.orientation_list.empty())
    diagnostics.add(orientations->place, "one_sheet needs neighbours, and a list of orientations has none",
                    "give ranges with how many values");
  if (!request.proportions.empty()) {
    std::vector<double> own;
    for (const ScanRange& range : request.scan) own.push_back(request.proportions[static_cast<std::size_t>(range.coordinate)]);
    for (const ScanRange& range : request.orientations)
      if (range.from != range.to) own.push_back(request.proportions[static_cast<std::size_t>(range.coordinate)]);
    if (std::ranges::any_of(own, [](double x) { return std::isnan(x); }))
      diagnostics.add(proportions->place, "expected a half width of every coordinate that is scanned", "add those that are left out");
    request.proportions = own;
  }
  int metres = 0, radians = 0;
  for (const ScanRange& range : request.scan) {
    options.scanned.push_back(name(range.coordinate));
    options.units.push_back(coordinates[static_cast<std::size_t>(range.coordinate)].unit);
    (coordinates[static_cast<std::size_t>(range.coordinate)].sense() == Sense::linear ? metres : radians) += 1;
  }
  options.unit = analysis::unit_of_volume(metres, radians);
  options.safe_scanned = options.scanned, options.safe_units = options.units;
  for (const ScanRange& range : request.orientations)
    if (range.from != range.to) {
      options.safe_scanned.push_back(name(range.coordinate));
      options.safe_units.push_back(coordinates[static_cast<std::size_t>(range.coordinate)].unit);
    }
}

}  // namespace pmreport::section
