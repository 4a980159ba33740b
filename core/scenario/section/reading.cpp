#include <core/scenario/read/beside.hpp>
#include <core/scenario/section/reading.hpp>
#include <core/text/digits.hpp>

namespace pmreport::scenario {
namespace {

constexpr std::size_t longest_section_name = 40;

std::vector<std::string> names_of(const Topology& topology) {
  std::vector<std::string> out;
  for (const Coordinate& c : topology.coordinates) out.push_back(c.name);
  return out;
}

}  // namespace

std::string read_section_name(const Value& value, const Reader& reader) {
  const auto name = reader.text(value);
  if (!name) return {};
  const bool sound = !name->empty() && name->size() <= longest_section_name && std::ranges::all_of(*name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  if (!sound)
    reader.diagnostics().add(value.place, fmt::format("expected a short name, seen {}", in_quotes(*name)),
                             "lower-case letters, digits, _ and - alone: it becomes part of file names and of quantities");
  return *name;
}

std::optional<double> read_time(const Value& value, const std::optional<TimeSpan>& span, const Reader& reader) {
  const auto t = reader.quantity(value, {0, 0, 1, 0});
  if (t && span && span->empty()) {
    reader.diagnostics().add(value.place, "expected no time, for the scenario has no motion, seen one",
                             "add [motion], duration = \"10 s\" and samples = 501, or leave out the time");
    return std::nullopt;
  }
  if (!t || !span || (*t >= span->begin && *t <= span->end)) return t;
  reader.diagnostics().add(value.place,
                           fmt::format("expected a time within the motion, {} s to {} s, seen {} s", format_number(span->begin, 6),
                                       format_number(span->end, 6), format_outside(*t, span->begin, span->end, 6)));
  return std::nullopt;
}

std::vector<Value> items_of(const Entry& entry, std::size_t most, const Reader& reader) {
  const Value& v = entry.value;
  if (v.kind == Value::Kind::array && !v.items.empty() && v.items.size() <= most) return v.items;
  if (v.kind != Value::Kind::refused)
    reader.diagnostics().add(v.place, fmt::format("expected a list of 1 to {} {}, seen {}", most, entry.key,
                                                  v.kind == Value::Kind::array ? fmt::format("{}", v.items.size()) : name_of(v)));
  return {};
}

int index_of(const Topology& topology, const std::string& name) {
  const auto& all = topology.coordinates;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Coordinate& c) { return c.name == name; });
  return found != all.end() ? static_cast<int>(found - all.begin()) : -1;
}

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

std::vector<Eigen::VectorXd> read_poses(const Entry& entry, std::size_t most, const Reading& reading) {
  std::vector<Eigen::VectorXd> out;
  if (!reading.mechanism.topology) return out;
  for (const Value& item : items_of(entry, most, reading.reader))
    out.push_back(read_pose(item, entry.key, reading.mechanism, reading.reader).value_or(Eigen::VectorXd()));
  return out;
}

std::shared_ptr<const Loaded> read_other_scenario(const Value& value, const Origin& origin, const Reader& reader) {
  if (origin.named) return nullptr;
  const auto given = reader.text(value);
  const auto file = given ? file_beside(*given, value.place, origin.file, reader.diagnostics()) : std::nullopt;
  if (!file) return nullptr;
  std::error_code error;
  if (std::filesystem::equivalent(origin.file, *file, error)) {
    reader.diagnostics().add(value.place, fmt::format("expected another scenario, seen {}, this one", in_quotes(*given)),
                             "leave scenario out where this one is meant");
    return nullptr;
  }
  const std::filesystem::path named = origin.file.has_parent_path() ? origin.file.parent_path() / *given : std::filesystem::path(*given);
  try {
    return std::make_shared<const Loaded>(load({named, origin.source, origin.kinds, true}));
  } catch (const ScenarioError& e) {
    for (const Diagnostic& d : e.diagnostics) reader.diagnostics().add(d);
    return nullptr;
  }
}

}  // namespace pmreport::scenario
