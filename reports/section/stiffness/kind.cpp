#include <reports/section/stiffness/stiffness.hpp>

#include <core/analysis/columns.hpp>
#include <core/scenario/section/keys.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::section {

using scenario::Shape;
namespace keys = scenario::keys;

namespace {

constexpr std::size_t most_poses = 20;

void read_tool(const scenario::Entry& e, const scenario::Reading& r, StiffnessRequest& options) {
  const auto* point = r.reader.list(e.value, 3, "lengths, x y z in the platform's axes");
  for (std::size_t k = 0; point != nullptr && k < 3; ++k)
    options.tool(static_cast<Eigen::Index>(k)) = r.reader.quantity((*point)[k], {1, 0, 0, 0}).value_or(0);
}

void read_times(const scenario::Entry& e, const scenario::Reading& r, StiffnessRequest& options) {
  for (const scenario::Value& item : items_of(e, most_poses, r.reader))
    if (const auto t = read_time(item, r.span, r.reader)) options.times.push_back(*t);
}

void read_poses(const scenario::Entry& e, const scenario::Reading& r, StiffnessRequest& options) {
  options.poses = scenario::read_poses(e, most_poses, r);
}

// What can be shown over a map: all columns, of a load only where there is one.
std::vector<Column> mapped_columns(const Topology& t, bool loaded) {
  std::vector<Column> out = analysis::stiffness_columns(t);
  std::erase_if(out, [&](const Column& c) { return !loaded && !analysis::of_compliance(c); });
  return out;
}

void read_stiffness_map(const scenario::Entry& e, const scenario::Reading& r, StiffnessRequest& o) {
  if (!r.mechanism.topology) return;
  const std::vector<Column> columns = mapped_columns(*r.mechanism.topology, r.span && !r.span->empty());
  std::vector<std::string> words;
  for (const Column& c : columns) words.push_back(c.name);
  auto map = read_map(e, r.mechanism, r.reader, words);
  if (!map) return;
  o.map = *map;
  if (map->show.empty()) map->show = {"pF_max", "PhiT_max", "frequency1"};
  for (const std::string& name : map->show) o.shown.push_back(*std::ranges::find(columns, name, &Column::name));
}

std::vector<scenario::Quantity> quantities(const scenario::Options* options) {
  std::vector<scenario::Quantity> out{
      {"stiffness.largest_deflection", "m", "largest deflection of the tool along the motion", false, true},
      {"stiffness.lowest_frequency", "Hz", "lowest natural frequency along the motion", false, true},
      {"stiffness.least_buckling", "", "least buckling load over compression along the motion", false, true},
      {"stiffness.rank", "", "directions in which the platform gives way at home"},
      {"stiffness.open_self_stresses", "", "self-stresses at home that no element settles"},
      {"stiffness.bending_factor", "", "pF_max at home by that of beams which no force bends", false}};
  for (const char* name : {"pF_max", "pF_min", "pT_max", "pT_min", "PhiT_max", "PhiT_min"}) {
    const std::string n = name, unit = n.starts_with("pF") ? "m/N" : n.starts_with("pT") ? "1/N" : "rad/N/m";
    out.push_back({"stiffness.home_" + n, unit, n + " at home", false});
  }
  out.push_back({"stiffness.home_frequency", "Hz", "lowest natural frequency at home", false});
  if (options == nullptr) return out;
  const auto& own = static_cast<const StiffnessRequest&>(*options);
  if (!own.map) return out;
  for (const Column& c : own.shown)
    for (const auto& [word, title] : {std::pair{"min", "least"}, {"max", "largest"}})
      out.push_back({fmt::format("stiffness.map_{}_{}", word, c.name), c.unit, fmt::format("{} {} over the map", title, c.name), false});
  return out;
}

std::vector<scenario::Key> all_keys() {
  using O = StiffnessRequest;
  const Shape pose = Shape::values_of("coordinates"), time = Shape::quantity(Dimension{0, 0, 1, 0});
  return {
      keys::of<O>("tool", Shape::list(3, 3, Shape::quantity(Dimension{1, 0, 0, 0})),
                  "the point whose stiffness and deflection are told, in the platform's axes", "the platform's reference point", read_tool),
      keys::of<O>("axes", Shape::word({"base", "platform"}), "of matrices and displacements", "`\"base\"`",
                  [](const scenario::Entry& e, const scenario::Reading& r, O& o) {
                    if (const auto w = r.reader.word(e.value, {"base", "platform"}, "the axes")) o.platform_axes = *w == 1;
                  }),
      keys::boolean<O>("limb_inertia", &O::limb_inertia, "whether the limbs' masses take part in natural frequencies"),
      keys::of<O>("times", Shape::list(1, most_poses, time), "when matrices, screws, modes and budgets are shown",
                  "where the deflection is largest", read_times),
      keys::of<O>("poses", Shape::list(1, most_poses, pose), "that are shown besides, `[{x = \"10 mm\"}]`, coordinates left out at home",
                  "home", read_poses),
      keys::of<O>("map", map_shape(ShownKey{Shape::text(), "columns of this section that are drawn", "`pF_max`, `PhiT_max`, `frequency1`"}),
                  "over two coordinates, `{x = [\"-100 mm\", \"100 mm\"], y = [\"-110 mm\", \"110 mm\"], show = [\"pF_max\"]}`", "none",
                  read_stiffness_map)};
}

}  // namespace

const SectionKind& stiffness_kind() {
  static const SectionKind kind{{.name = "stiffness",
                                 .purpose = "how far the platform gives way, which part makes it so, how it vibrates, what beams carry",
                                 .keys = all_keys(),
                                 .needs = {.motion = false, .stiffness = true, .pictures = true},
                                 .columns = analysis::stiffness_columns,
                                 .quantities = quantities,
                                 .make_options = scenario::plain_options<StiffnessRequest>},
                                [](const Context& c, const scenario::Section& s) {
                                  return stiffness_section(c.analysis, options_of<StiffnessRequest>(s), c.stage, c.progress);
                                }};
  return kind;
}

}  // namespace pmreport::section
