#include <reports/section/singularity/singularity.hpp>

#include <core/scenario/section/keys.hpp>

#include <algorithm>

namespace pmreport::section {

using scenario::Shape;
namespace keys = scenario::keys;

namespace {

constexpr std::size_t most_poses = 100;
constexpr double fewest_points = 5, most_points = 401;  // along each side of a map

std::optional<MapOptions> read_map(const scenario::Entry& entry, const scenario::MechanismPart& mechanism, const scenario::Reader& reader) {
  scenario::Diagnostics& diagnostics = reader.diagnostics();
  const scenario::Value* content = table_of(&entry, "section.map", reader);
  if (content == nullptr) return std::nullopt;
  const Topology& topology = *mechanism.topology;
  std::vector<std::string> known{"at", "points"};
  for (const Coordinate& c : topology.coordinates) known.push_back(c.name);
  MapOptions out;
  bool sound = true;
  int found = 0;
  const scenario::Entry* at = nullptr;
  for (const scenario::Entry& e : content->entries) {
    if (e.key == "at") {
      at = &e;
      continue;
    }
    if (e.key == "points") {
      out.points = static_cast<int>(reader.integer(e.value, fewest_points, most_points).value_or(out.points));
      continue;
    }
    const int i = scenario::index_of(topology, e.key);
    if (i < 0) {
      refuse_coordinate(e.place, e.key, mechanism, known, "map", diagnostics);
      sound = false;
      continue;
    }
    if (found < 2) {
      out.coordinate[found] = i;
      const auto* range = reader.list(e.value, 2, "two ends of a range");
      const Dimension dimension = parse_unit(topology.coordinates[static_cast<std::size_t>(i)].unit)->dimension;
      const auto from = range != nullptr ? reader.quantity((*range)[0], dimension) : std::nullopt;
      const auto to = range != nullptr ? reader.quantity((*range)[1], dimension) : std::nullopt;
      sound = sound && from && to;
      if (from && to) {
        if (!(*from < *to)) {
          diagnostics.add(e.value.place, fmt::format("expected a range of {} that rises", e.key), "give the smaller end first");
          sound = false;
        }
        out.from[found] = *from;
        out.to[found] = *to;
      }
    }
    ++found;
  }
  if (found != 2 && sound) {
    diagnostics.add(entry.place, fmt::format("expected a map over two coordinates, seen {}", found),
                    fmt::format("write map = {{ {} = [from, to], {} = [from, to] }}; the others go to at = {{ ... }}",
                                topology.coordinates.front().name, topology.coordinates.back().name));
    sound = false;
  }
  const scenario::Value nothing;
  const auto q = read_pose(at != nullptr ? at->value : nothing, "map.at", mechanism, reader);
  if (at != nullptr)
    for (const scenario::Entry& e : at->value.entries)
      for (int i = 0; i < std::min(found, 2); ++i)
        if (scenario::index_of(topology, e.key) == out.coordinate[i]) {
          diagnostics.add(e.place, fmt::format("{} spans the map and cannot be held at a value", e.key), "remove it from at");
          sound = false;
        }
  if (!q || !sound) return std::nullopt;
  out.at = *q;
  return out;
}

void read_length(const scenario::Entry& e, const scenario::Reading& r, SingularityOptions& options) {
  options.length = r.reader.quantity(e.value, {1, 0, 0, 0});
  if (options.length && !(*options.length > 0))
    r.reader.diagnostics().add(e.value.place,
                               fmt::format("expected a length above 0 mm, seen {} mm", format_number(*options.length * 1e3, 6)));
}

void read_poses(const scenario::Entry& e, const scenario::Reading& r, SingularityOptions& options) {
  if (!r.mechanism.topology) return;
  for (const scenario::Value& item : items_of(e, most_poses, r.reader))
    options.poses.push_back(read_pose(item, "poses", r.mechanism, r.reader).value_or(Eigen::VectorXd()));
}

void complete(scenario::TableReader& table, const scenario::Reading& r, scenario::Options& options) {
  const auto& own = static_cast<const SingularityOptions&>(options);
  if (r.span && r.span->empty() && own.poses.empty() && !own.map)
    r.reader.diagnostics().add(table.place(), "a section \"singularity\" has nothing to look at: there is no motion, no pose and no map",
                               "add poses or map to it, or [motion], duration = \"10 s\" and samples = 501");
}

std::vector<scenario::Quantity> quantities(const scenario::Options* options) {
  std::vector<scenario::Quantity> out{
      {"singularity.crossings", "", "singular surfaces crossed by the motion", true, true},
      {"singularity.smallest_singular_value", "", "smallest singular value of G along the motion", false, true},
      {"singularity.largest_condition", "", "largest condition number along the motion", false, true},
      {"singularity.line_rank", "", "rank of the actuation lines at the worst pose of the motion", true, true},
      {"singularity.wrench_rank", "", "rank of the whole wrench system at the worst pose of the motion", true, true}};
  const std::size_t poses = options != nullptr ? static_cast<const SingularityOptions*>(options)->poses.size() : most_poses;
  for (std::size_t i = 1; i <= poses; ++i) {
    const std::string n = std::to_string(i);
    out.push_back({"singularity.line_rank_" + n, "", "rank of the actuation lines at pose " + n});
    out.push_back({"singularity.wrench_rank_" + n, "", "rank of the whole wrench system at pose " + n});
  }
  return out;
}

std::vector<scenario::Key> all_keys() {
  using O = SingularityOptions;
  const Shape pose = Shape::values_of("coordinates");
  const Shape map = Shape::values_of("coordinates", {keys::within("at", pose, "the other coordinates", "home"),
                                                     keys::within("points", Shape::whole(fewest_points, most_points), "along each side",
                                                                  std::to_string(MapOptions().points))});
  return {keys::of<O>("length", Shape::quantity(Dimension{1, 0, 0, 0}), "which makes moments comparable with forces",
                      "the characteristic length", read_length),
          keys::of<O>("poses", Shape::list(1, most_poses, pose),
                      "looked at beside those of the motion, `[{x = \"10 mm\"}]`, coordinates left out at home", "none", read_poses),
          keys::of<O>("map", map,
                      "of det G over two coordinates, `{x = [\"-100 mm\", \"100 mm\"], y = [\"-110 mm\", \"110 mm\"], at = {alpha = \"5 "
                      "deg\"}, points = 61}`",
                      "none", [](const scenario::Entry& e, const scenario::Reading& r, O& options) {
                        if (r.mechanism.topology) options.map = read_map(e, r.mechanism, r.reader);
                      })};
}

}  // namespace

const SectionKind& singularity_kind() {
  static const SectionKind kind{
      {.name = "singularity",
       .purpose = "how far the motion stays from a loss of control, where control is lost, and how the platform escapes",
       .keys = all_keys(),
       .needs = {.motion = false, .pictures = true},
       .quantities = quantities,
       .make_options = scenario::plain_options<SingularityOptions>,
       .complete = complete},
      [](const Context& c, const scenario::Section& s) {
        return singularity_section(c.analysis, options_of<SingularityOptions>(s), c.stage, c.progress);
      }};
  return kind;
}

}  // namespace pmreport::section
