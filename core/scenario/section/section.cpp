#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/section/section_part.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

constexpr double most_random_poses = 10000;

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> all{"mechanism", "snapshots",   "displacement", "velocity",   "acceleration",
                                            "statics",   "dynamics",    "drives",       "reactions",  "speed",
                                            "mobility",  "singularity", "assembly",     "comparison", "classification"};
  return all;
}

// A section that has nothing to show without its table, and a table that no section shows.
void match_tables(const std::vector<SectionRequest>& sections, const std::vector<Place>& kinds_at, const Sizing& sizing,
                  const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  bool shown = false;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const std::string& kind = sections[i].kind;
    shown = shown || kind == "drives" || kind.empty();
    if (kind == "drives" && sizing.drive == nullptr)
      diagnostics.add(kinds_at[i], "a section \"drives\" needs the table [drive], which is not there",
                      "add [drive] and, for instance, efficiency = 0.9");
    if (kind == "speed" && sizing.limits == nullptr)
      diagnostics.add(kinds_at[i], "a section \"speed\" needs at least one limit, and there is none",
                      "add [limits] and at least one of actuator_force, actuator_speed, actuator_power, joint_force and joint_moment");
  }
  if (sizing.drive != nullptr && !shown)
    diagnostics.add(sizing.drive->place, "[drive] is for the section \"drives\", which this scenario does not have",
                    "add [[section]] and kind = \"drives\"; forces of the other sections are those of the actuators themselves");
}

}  // namespace

bool needs_motion(std::string_view kind) {
  constexpr std::string_view all[] = {"displacement", "velocity", "acceleration", "statics", "dynamics", "drives", "reactions", "speed"};
  return std::find(std::begin(all), std::end(all), kind) != std::end(all);
}

bool is_of_motion(std::string_view quantity) {
  constexpr std::string_view all[] = {"singularity.crossings",         "singularity.smallest_singular_value",
                                      "singularity.largest_condition", "singularity.line_rank",
                                      "singularity.wrench_rank",       "assembly.nearest"};
  return std::find(std::begin(all), std::end(all), quantity) != std::end(all);
}

// Only what is no section at all, or one that needs a motion, asks for it: a mistake in a kind is told by itself.
bool need_motion(const Entry* sections) {
  if (sections == nullptr || sections->value.items.empty()) return true;
  const auto needs = [](const Value& section) {
    return std::any_of(section.entries.begin(), section.entries.end(),
                       [](const Entry& e) { return e.key == "kind" && e.value.kind == Value::Kind::text && needs_motion(e.value.text); });
  };
  return std::any_of(sections->value.items.begin(), sections->value.items.end(), needs);
}

std::optional<double> read_time(const Value& value, const std::optional<TimeSpan>& span, const Reader& reader) {
  const auto t = reader.quantity(value, {0, 0, 1, 0});
  if (t && span && span->empty()) {
    reader.diagnostics().add(value.place, "expected no time, for the scenario has no motion, seen one",
                             "add [motion], duration = \"10 s\" and samples = 501, or leave out the time");
    return std::nullopt;
  }
  if (!t || !span || (*t >= span->begin && *t <= span->end)) return t;
  reader.diagnostics().add(value.place, fmt::format("expected a time within the motion, {} s to {} s, seen {} s",
                                                    format_number(span->begin, 6), format_number(span->end, 6), format_number(*t, 6)));
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

std::vector<SectionRequest> read_sections(const Entry* entry, const std::optional<TimeSpan>& span, const MechanismPart& mechanism,
                                          const Sizing& sizing, const Reader& reader) {
  const auto tables = tables_of(entry, "section", reader);
  if (tables.empty() && (entry == nullptr || entry->value.kind == Value::Kind::array))
    reader.diagnostics().add(entry != nullptr ? entry->place : Place{}, "expected at least one section, and there is none",
                             fmt::format("write [[section]] and kind = \"displacement\"; the kinds are {}", listed(kinds(), "and")));
  std::vector<SectionRequest> out;
  std::vector<Place> kinds_at;
  std::vector<std::pair<std::size_t, const Entry*>> rows;  // of the comparisons, read when all sections are known
  for (const Value* content : tables) {
    TableReader table(*content, "[[section]]", content->place, reader);
    SectionRequest request;
    request.line = content->place.line;
    const Entry *kind = table.need("kind", "kind = \"displacement\""), *title = table.find("title");
    if (title != nullptr) request.title = reader.text(title->value).value_or("");
    const auto index = kind != nullptr ? reader.word(kind->value, kinds(), "the kinds of section") : std::nullopt;
    kinds_at.push_back(kind != nullptr ? kind->value.place : content->place);
    if (!index) {  // without a kind nobody knows which keys are right; the request stays, as one of any kind
      out.push_back(std::move(request));
      continue;
    }
    request.kind = kinds()[*index];
    if (request.kind == "snapshots") {
      read_snapshots(table, span, request);
    } else {
      const auto same = std::find_if(out.begin(), out.end(), [&](const SectionRequest& r) { return r.kind == request.kind; });
      if (same != out.end())
        reader.diagnostics().add(kind->value.place,
                                 fmt::format("a report has one section {}; the first is in line {}", in_quotes(request.kind), same->line));
    }
    if (request.kind == "mobility")
      if (const Entry* poses = table.find("poses"))
        request.random_poses = static_cast<int>(reader.integer(poses->value, 1, most_random_poses).value_or(request.random_poses));
    if (request.kind == "singularity") {
      read_singularity(table, mechanism, request);
      if (span && span->empty() && request.poses.empty() && !request.map)
        reader.diagnostics().add(content->place, "a section \"singularity\" has nothing to look at: there is no motion, no pose and no map",
                                 "add poses or map to it, or [motion], duration = \"10 s\" and samples = 501");
    }
    if (request.kind == "dynamics") read_dynamics(table, span, request);
    if (request.kind == "reactions") read_reactions(table, mechanism, request);
    if (request.kind == "assembly") read_assembly(table, span, mechanism, request);
    if (request.kind == "comparison") {
      if (const Entry* e = table.find("source")) request.source = reader.text(e->value).value_or("");
      if (const Entry* e = table.need("row", "[[section.row]] with what, here, paper and tolerance")) rows.emplace_back(out.size(), e);
    }
    table.finish(fmt::format("a section of kind {}", in_quotes(request.kind)));
    out.push_back(std::move(request));
  }
  match_tables(out, kinds_at, sizing, reader);
  for (const auto& [index, entry_of_rows] : rows)
    out[index].rows = read_comparison_rows(*entry_of_rows, {out, mechanism.topology, span, sizing.drives}, reader);
  return out;
}

}  // namespace pmreport::scenario
