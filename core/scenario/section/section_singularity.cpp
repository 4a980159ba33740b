#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/section/section_part.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

constexpr double fewest_points = 5, most_points = 401;  // along each side of a map

std::vector<std::string> names_of(const Topology& topology) {
  std::vector<std::string> out;
  for (const Coordinate& c : topology.coordinates) out.push_back(c.name);
  return out;
}

int index_of(const Topology& topology, const std::string& name) {
  const auto& all = topology.coordinates;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Coordinate& c) { return c.name == name; });
  return found != all.end() ? static_cast<int>(found - all.begin()) : -1;
}

// A pose by its coordinates; those left out stay at home. Nothing, told, when it is none.
std::optional<Eigen::VectorXd> read_pose(const Value& value, const std::string& where, const MechanismPart& mechanism,
                                         const Reader& reader) {
  const Topology& topology = *mechanism.topology;
  if (value.kind != Value::Kind::table) {
    if (value.kind != Value::Kind::refused)
      reader.diagnostics().add(
          value.place, fmt::format("expected a pose, seen {}", name_of(value)),
          fmt::format("write {{ {} = ... }}, with the coordinates that differ from home", topology.coordinates[0].name));
    return std::nullopt;
  }
  Eigen::VectorXd q(static_cast<Eigen::Index>(topology.coordinates.size()));
  for (Eigen::Index i = 0; i < q.size(); ++i) q(i) = topology.coordinates[static_cast<std::size_t>(i)].home;
  bool sound = true;
  for (const Entry& e : value.entries) {
    const int i = index_of(topology, e.key);
    if (i < 0) refuse_coordinate(e.place, e.key, mechanism, names_of(topology), where, reader.diagnostics());
    const auto x =
        i >= 0 ? reader.quantity(e.value, parse_unit(topology.coordinates[static_cast<std::size_t>(i)].unit)->dimension) : std::nullopt;
    sound = sound && x.has_value();
    if (x) q(i) = *x;
  }
  return sound ? std::optional(q) : std::nullopt;
}

std::optional<MapRequest> read_map(const Entry& entry, const MechanismPart& mechanism, const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  const Value* content = table_of(&entry, "section.map", reader);
  if (content == nullptr) return std::nullopt;
  const Topology& topology = *mechanism.topology;
  std::vector<std::string> known{"at", "points"};
  for (const Coordinate& c : topology.coordinates) known.push_back(c.name);
  MapRequest out;
  bool sound = true;
  int found = 0;
  const Entry* at = nullptr;
  for (const Entry& e : content->entries) {
    if (e.key == "at") {
      at = &e;
      continue;
    }
    if (e.key == "points") {
      out.points = static_cast<int>(reader.integer(e.value, fewest_points, most_points).value_or(out.points));
      continue;
    }
    const int i = index_of(topology, e.key);
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
  const Value nothing;
  const auto q = read_pose(at != nullptr ? at->value : nothing, "map.at", mechanism, reader);
  if (at != nullptr)
    for (const Entry& e : at->value.entries)
      for (int i = 0; i < std::min(found, 2); ++i)
        if (index_of(topology, e.key) == out.coordinate[i]) {
          diagnostics.add(e.place, fmt::format("{} spans the map and cannot be held at a value", e.key), "remove it from at");
          sound = false;
        }
  if (!q || !sound) return std::nullopt;
  out.at = *q;
  return out;
}

}  // namespace

void read_singularity(TableReader& table, const MechanismPart& mechanism, SectionRequest& request) {
  const Reader& reader = table.read();
  if (const Entry* e = table.find("length")) {
    request.length = reader.quantity(e->value, {1, 0, 0, 0});
    if (request.length && !(*request.length > 0))
      reader.diagnostics().add(e->value.place,
                               fmt::format("expected a length above 0 mm, seen {} mm", format_number(*request.length * 1e3, 6)));
  }
  const Entry *poses = table.find("poses"), *map = table.find("map");
  if (!mechanism.topology) return;
  if (poses != nullptr)
    for (const Value& item : items_of(*poses, most_poses, reader))
      request.poses.push_back(read_pose(item, "poses", mechanism, reader).value_or(Eigen::VectorXd()));
  if (map != nullptr) request.map = read_map(*map, mechanism, reader);
}

void read_assembly(TableReader& table, const std::optional<TimeSpan>& span, const MechanismPart& mechanism, SectionRequest& request) {
  const Reader& reader = table.read();
  const Entry *time = table.find("time"), *actuators = table.find("actuators"), *modes = table.find("working_modes");
  request.time = span ? span->begin : 0;
  if (time != nullptr) request.time = read_time(time->value, span, reader).value_or(request.time);
  if (modes != nullptr) request.working_modes = reader.boolean(modes->value).value_or(true);
  if (time != nullptr && actuators != nullptr)
    reader.diagnostics().add(actuators->place, "the actuator values are given twice: here and by a time of the motion",
                             "keep one of the two");
  const Value* given = table_of(actuators, "section.actuators", reader);
  if (given == nullptr || !mechanism.topology) return;
  TableReader values(*given, "actuators", actuators->place, reader);
  const Movables movables(mechanism);
  request.actuators.resize(static_cast<Eigen::Index>(movables.actuators.size()));
  for (std::size_t i = 0; i < movables.actuators.size(); ++i) {  // those left out stay at home
    const Moved& m = movables.actuators[i];
    const Entry* e = values.find(m.name);
    request.actuators(static_cast<Eigen::Index>(i)) =
        e != nullptr ? reader.quantity(e->value, parse_unit(m.unit)->dimension).value_or(m.home) : m.home;
  }
  values.finish();
}

}  // namespace pmreport::scenario
