#include <reports/section/common/pose_map.hpp>

#include <core/scenario/section/keys.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::section {

using scenario::Shape;
namespace keys = scenario::keys;

namespace {

constexpr double fewest_points = 5, most_points = 401;  // along each side
constexpr std::size_t most_shown = 12;

// [from, to] of a coordinate, which must rise.
bool read_range(const scenario::Entry& e, int axis, const Coordinate& c, const scenario::Reader& reader, MapRequest& out) {
  const auto* range = reader.list(e.value, 2, "two ends of a range");
  const Dimension dimension = parse_unit(c.unit)->dimension;
  const auto from = range != nullptr ? reader.quantity((*range)[0], dimension) : std::nullopt;
  const auto to = range != nullptr ? reader.quantity((*range)[1], dimension) : std::nullopt;
  if (!from || !to) return false;
  out.from[axis] = *from, out.to[axis] = *to;
  if (*from < *to) return true;
  reader.diagnostics().add(e.value.place, fmt::format("expected a range of {} that rises", e.key), "give the smaller end first");
  return false;
}

}  // namespace

Shape map_shape(const std::optional<ShownKey>& show) {
  std::vector<scenario::Key> more{
      keys::within("at", Shape::values_of("coordinates"), "the other coordinates", "home"),
      keys::within("points", Shape::whole(fewest_points, most_points), "along each side", std::to_string(MapRequest().points))};
  if (show) more.push_back(keys::within("show", Shape::list(1, most_shown, show->item), show->meaning, show->unset));
  return Shape::values_of("coordinates", std::move(more));
}

std::optional<MapRequest> read_map(const scenario::Entry& entry, const scenario::MechanismPart& mechanism, const scenario::Reader& reader,
                                   const std::vector<std::string>& shown) {
  scenario::Diagnostics& diagnostics = reader.diagnostics();
  const scenario::Value* content = table_of(&entry, "section.map", reader);
  if (content == nullptr) return std::nullopt;
  const Topology& topology = *mechanism.topology;
  std::vector<std::string> known{"at", "points"};
  if (!shown.empty()) known.emplace_back("show");
  for (const Coordinate& c : topology.coordinates) known.push_back(c.name);
  MapRequest out;
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
    if (e.key == "show" && !shown.empty()) {
      for (const scenario::Value& item : items_of(e, most_shown, reader))
        if (const auto word = reader.word(item, shown, "the indices")) add_once(out.show, shown[*word], item, reader);
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
      sound = read_range(e, found, topology.coordinates[static_cast<std::size_t>(i)], reader, out) && sound;
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

}  // namespace pmreport::section
