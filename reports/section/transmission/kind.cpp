#include <reports/section/transmission/transmission.hpp>

#include <core/scenario/measured_part.hpp>
#include <core/scenario/section/keys.hpp>
#include <reports/section/common/scan_ranges.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::section {

using scenario::Entry;
using scenario::Reading;
using scenario::Shape;
namespace keys = scenario::keys;

namespace {

using O = TransmissionOptions;

constexpr std::size_t most_poses = 100;
constexpr std::size_t most_of_grid = 5'000'000;  // poses: half a minute
const std::vector<std::string> groups{"strokes", "joints"};

// Least over the motion, by the columns of a group or a single one.
struct LeastOfMotion {
  const char *name, *group, *title;
};
constexpr LeastOfMotion least_of_motion[] = {
    {"least_cosine", "pressure_angle", "least cosine of a pressure angle along the motion"},
    {"least_output", "output_transmission", "least output transmission index along the motion"},
    {"least_input", "input_transmission", "least input transmission index along the motion"},
    {"least_constraint", "constraint_transmission", "least constraint transmission index along the motion"},
    {"least_local", "local_transmission", "least local transmission index along the motion"},
    {"least_conditioning", "local_conditioning", "least local conditioning index along the motion"}};

std::vector<std::string> names_of_columns(const std::vector<Column>& columns) {
  std::vector<std::string> out;
  for (const Column& c : columns) out.push_back(c.name);
  return out;
}

void read_length(const Entry& e, const Reading& r, O& options) {
  options.length = r.reader.quantity(e.value, {1, 0, 0, 0});
  if (!options.length || *options.length > 0) return;
  r.reader.diagnostics().add(e.value.place,
                             fmt::format("expected a length above 0 mm, seen {} mm", format_number(*options.length * 1e3, 6)));
  options.length.reset();
}

void read_poses(const Entry& e, const Reading& r, O& options) { options.poses = scenario::read_poses(e, most_poses, r); }

// By the mechanism: columns of which it never has a number.
std::map<std::string, std::string> columns_without(const Reading& r) {
  std::map<std::string, std::string> out;
  if (!r.mechanism.machine) return out;
  const std::vector<Column> columns = analysis::transmission_columns(r.mechanism.machine->topology());
  const std::vector<std::string> reasons = analysis::why_without(mechanics::Transmission(*r.mechanism.machine));
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (!reasons[i].empty()) out.emplace(columns[i].name, reasons[i]);
  return out;
}

void read_transmission_map(const Entry& e, const Reading& r, O& options) {
  if (!r.mechanism.topology) return;
  options.map = read_map(e, r.mechanism, r.reader, names_of_columns(analysis::transmission_columns(*r.mechanism.topology)));
  if (!options.map) return;
  const std::map<std::string, std::string> without = columns_without(r);
  for (const std::string& name : options.map->show)
    if (const auto found = without.find(name); found != without.end())
      r.reader.diagnostics().add(e.place, fmt::format("{} cannot be shown on a map: {}", name, found->second), "remove it from show");
  if (!options.map->show.empty()) return;
  for (const char* name : {"local_transmission", "least_cosine", "local_conditioning"})
    if (options.map->show.size() < 2 && !without.contains(name)) options.map->show.emplace_back(name);
}

void read_grid(const Entry& e, const Reading& r, O& options) {
  if (!r.mechanism.topology) return;
  analysis::GridRequest& grid = options.grid ? *options.grid : options.grid.emplace();
  grid.ranges = read_scan_ranges(e, "section.grid", r);
  double poses = 1;
  for (const analysis::ScanRange& range : grid.ranges) {
    poses *= static_cast<double>(range.count);
    if (range.count == 0)
      r.reader.diagnostics().add(e.value.place,
                                 fmt::format("expected how many values {} takes",
                                             r.mechanism.topology->coordinates[static_cast<std::size_t>(range.coordinate)].name),
                                 "write x = [\"-100 mm\", \"100 mm\", 15]");
  }
  if (poses > static_cast<double>(most_of_grid))
    r.reader.diagnostics().add(e.value.place, fmt::format("expected a grid of at most {} poses, seen {:.0f}", most_of_grid, poses),
                               "give fewer values to a coordinate");
}

void read_groups(const Entry& e, const Reading& r, O& options) {
  options.limits_given = true;
  analysis::GridRequest& grid = options.grid ? *options.grid : options.grid.emplace();
  grid.strokes = grid.joints = false;
  if (e.value.kind == scenario::Value::Kind::array && e.value.items.empty()) return;
  std::vector<std::size_t> seen;
  for (const scenario::Value& item : items_of(e, groups.size(), r.reader))
    if (const auto word = r.reader.word(item, groups, "the groups of limits")) {
      add_once(seen, *word, item, r.reader);
      (*word == 0 ? grid.strokes : grid.joints) = true;
    }
}

void complete(scenario::TableReader& table, const Reading& r, scenario::Options& options) {
  auto& own = static_cast<O&>(options);
  if (own.limits_given && own.grid->ranges.empty())
    r.reader.diagnostics().add(table.place(), "limits count for a grid, and there is none",
                               "add grid = { x = [\"-100 mm\", \"100 mm\", 15] }, or remove limits");
  else if (r.span && r.span->empty() && own.poses.empty() && !own.map && !own.grid)
    r.reader.diagnostics().add(table.place(),
                               "a section \"transmission\" has nothing to look at: there is no motion, no pose, no map and no grid",
                               "add poses, map or grid to it, or [motion], duration = \"10 s\" and samples = 501");
  if (r.mechanism.topology && own.empty.empty()) {
    own.empty = columns_without(r);
    const std::vector<Column> columns = analysis::transmission_columns(*r.mechanism.topology);
    for (const LeastOfMotion& least : least_of_motion) {
      std::string why = "the mechanism has none";
      bool any = false;
      for (const Column& c : columns) {
        if (c.group != least.group) continue;
        const auto found = own.empty.find(c.name);
        any = any || found == own.empty.end();
        if (found != own.empty.end()) why = found->second;
      }
      if (!any) own.empty.emplace(std::string("transmission.") + least.name, why);
    }
  }
}

std::vector<scenario::Quantity> quantities(const scenario::Options* given) {
  std::vector<scenario::Quantity> out;
  const auto add = [&](const std::string& name, const std::string& title, const std::string& unit = "", bool count = false,
                       bool of_motion = false) {
    out.push_back({"transmission." + name, unit, title, count, of_motion});
  };
  for (const LeastOfMotion& least : least_of_motion) add(least.name, least.title, "", false, true);
  const auto* options = static_cast<const O*>(given);
  const std::size_t poses = options != nullptr ? options->poses.size() : most_poses;
  for (std::size_t i = 1; i <= poses; ++i)
    for (const auto& [name, title] : {std::pair{"least_cosine", "least cosine of a pressure angle"},
                                      {"local_transmission", "local transmission index"},
                                      {"local_conditioning", "local conditioning index"}})
      add(fmt::format("{}_{}", name, i), fmt::format("{} at pose {}", title, i));
  const std::vector<std::string> singles{"local_transmission", "least_cosine", "local_conditioning", "manipulability"};
  const auto unit_of = [](const std::string& name) { return name.ends_with("_pressure") ? "rad" : ""; };
  if (options == nullptr || options->map)
    for (const std::string& name : options != nullptr ? options->map->show : singles)
      for (const auto& [before, words] : {std::pair{"map_min_", "least "}, {"map_max_", "largest "}, {"map_mean_", "mean "}})
        add(before + name, fmt::format("{}{} over the map", words, name), unit_of(name));
  if (options != nullptr && !options->grid) return out;
  for (const std::string& name : singles)
    for (const auto& [before, words] : {std::pair{"min_", "least "}, {"max_", "largest "}, {"mean_", "mean "}})
      add(before + name, fmt::format("{}{} over the grid", words, name));
  add("good_share", "share of the accepted poses of the grid, where it is known, whose local transmission index is 0.7 or more");
  add("poses", "poses of the grid", "", true);
  add("accepted", "poses of the grid that keep the limits", "", true);
  return out;
}

// What this mechanism never has a number of can be no part of a demand: of a group it would be left out, and what was not looked at would
// have passed.
void narrow(const scenario::Measurable& measurable, std::size_t offset, scenario::Measured& measured) {
  for (const scenario::Section& s : measurable.sections) {
    const auto* options = dynamic_cast<const O*>(s.options.get());
    if (options == nullptr) continue;
    const auto refuse = [&](const std::string& name) {
      const auto found = options->empty.find(name);
      if (found == options->empty.end()) return;
      std::vector<std::string> others;
      for (const std::string& c : measured.columns)
        if (!options->empty.contains(c)) others.push_back(c);
      throw scenario::ExpressionError(offset, fmt::format("{} has no number for this mechanism: {}", name, found->second),
                                      others.empty() ? "" : fmt::format("name those that have: {}", listed(others, "or")));
    };
    for (const std::string& c : measured.columns) refuse(c);
    if (!measured.quantity.empty()) refuse(measured.quantity);
    for (const char* part : {"map_min_", "map_max_", "map_mean_", "min_", "max_", "mean_"})
      if (const std::string before = std::string("transmission.") + part; measured.quantity.starts_with(before))
        refuse(measured.quantity.substr(before.size()));
    if (measured.quantity == "transmission.good_share") refuse("local_transmission");
    for (const char* name : {"least_cosine", "local_transmission"})
      if (measured.quantity.starts_with(fmt::format("transmission.{}_", name))) refuse(name);
  }
}

std::vector<scenario::Key> all_keys() {
  const Shape value = Shape::quantity(std::nullopt);
  const ShownKey show{Shape::text(), "indices as data/transmission.csv names them, `[\"local_transmission\", \"l1_output\"]`",
                      "the local transmission index, or the least cosine, and the local conditioning index"};
  return {
      keys::of<O>("length", Shape::quantity(Dimension{1, 0, 0, 0}), "which makes moments comparable with forces in the conditioning",
                  "the characteristic length", read_length),
      keys::of<O>("poses", Shape::list(1, most_poses, Shape::values_of("coordinates")),
                  "looked at beside those of the motion, `[{x = \"10 mm\"}]`, coordinates left out at home", "none", read_poses),
      keys::of<O>("map", map_shape(show),
                  "of indices over two coordinates, `{x = [\"-100 mm\", \"100 mm\"], y = [\"-110 mm\", \"110 mm\"], show = "
                  "[\"local_transmission\"]}`",
                  "none", read_transmission_map),
      keys::of<O>("grid", Shape::values_of("coordinates"),
                  "of poses over which the indices are averaged, each range with how many values, `{x = [\"-100 mm\", \"100 mm\", 15]}`, "
                  "coordinates left out at home",
                  "none", read_grid),
      keys::of<O>("limits", Shape::list(0, 2, Shape::word(groups)), "groups of the mechanism's limits that a pose of the grid must keep",
                  "all", read_groups)};
}

}  // namespace

const SectionKind& transmission_kind() {
  static const SectionKind kind{{.name = "transmission",
                                 .purpose = "how well the actuators move the platform: pressure angles, transmission indices, conditioning",
                                 .keys = all_keys(),
                                 .needs = {.motion = false, .transmission = true},
                                 .columns = analysis::transmission_columns,
                                 .quantities = quantities,
                                 .make_options = scenario::plain_options<O>,
                                 .complete = complete,
                                 .narrow = narrow},
                                [](const Context& c, const scenario::Section& s) { return transmission_section(c, options_of<O>(s)); }};
  return kind;
}

}  // namespace pmreport::section
