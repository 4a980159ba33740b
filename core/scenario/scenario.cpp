#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/elasticity_part.hpp>
#include <core/scenario/load_part.hpp>
#include <core/scenario/loaded.hpp>
#include <core/scenario/motion/motion_part.hpp>
#include <core/scenario/read/csv.hpp>
#include <core/scenario/section/section_part.hpp>
#include <core/scenario/sizing_part.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

constexpr std::size_t largest_file = 4u << 20;  // [bytes]

constexpr const char* smallest_scenario =
    "a scenario has title = \"...\", [mechanism] with use, [motion] with duration and samples, and at least one [[section]] with kind";

[[noreturn]] void refuse_file(const std::string& file, std::string message, std::string hint = {}) {
  throw ScenarioError({{file, 0, 0, std::move(message), {}, std::move(hint)}});
}

// [drive], or one of its tables, has the key, whatever stands there.
bool says_stiffness(const Value& table) {
  return std::ranges::any_of(table.entries, [](const Entry& e) { return e.key == "stiffness" || says_stiffness(e.value); });
}

// What a page can be broken into lines for within a moment.
constexpr std::size_t longest_name = 300, longest_text = 10'000, most_lines = 200;

std::string text_or_nothing(const Entry* entry, const Reader& reader, std::size_t longest) {
  if (entry == nullptr) return {};
  std::string text = reader.text(entry->value).value_or("");
  const auto refuse = [&](std::size_t seen, std::size_t most, const char* what) {
    reader.diagnostics().add(entry->value.place, fmt::format("expected at most {} {} for {}, seen {}", most, what, entry->key, seen));
    text.clear();
  };
  if (const std::size_t seen = characters(text); seen > longest)
    refuse(seen, longest, "characters");
  else if (const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1; lines > most_lines)
    refuse(lines, most_lines, "lines");
  return text;
}

}  // namespace

bool Scenario::asks_for(const SectionKind& kind) const {
  return std::any_of(sections.begin(), sections.end(), [&](const Section& s) { return s.kind == &kind; });
}

Needs Scenario::needs() const {
  Needs out;
  out.motion = false;
  for (const Section& s : sections) out |= s.kind->needs;
  return out;
}

Loaded load_text(const std::string& text, const std::filesystem::path& file, const MechanismSource& source, Kinds kinds) {
  return load_text(text, {file, source, kinds});
}

Loaded load_text(const std::string& text, const Origin& origin) {
  const std::filesystem::path& file = origin.file;
  const Kinds kinds = origin.kinds;
  const std::string shown = printable(file.string());
  if (text.size() > largest_file)
    refuse_file(shown, fmt::format("expected at most {} MiB, seen {} bytes", largest_file >> 20, text.size()));
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    refuse_file(shown, "expected a scenario, seen an empty file", smallest_scenario);

  Diagnostics diagnostics(shown, text);
  const Reader reader(diagnostics, origin.asked);
  const auto parsed = std::make_shared<const Value>(parse_document(text, shown, diagnostics));
  const Value& document = *parsed;
  if (origin.asked != nullptr) origin.asked->document = parsed;
  TableReader table(document, "the scenario", {}, reader);

  Loaded out;
  Scenario& s = out.scenario;
  s.file = file;
  s.text = text;
  const Entry* title = table.need("title", "title = \"...\"");
  s.title = text_or_nothing(title, reader, longest_name);
  if (title != nullptr && title->value.kind == Value::Kind::text && trim(title->value.text).empty())
    diagnostics.add(title->value.place, "expected a title, seen an empty text");
  s.author = text_or_nothing(table.find("author"), reader, longest_name);
  s.description = text_or_nothing(table.find("description"), reader, longest_text);
  if (const Entry* detail = table.find("detail"))
    if (const auto which = reader.word(detail->value, {"brief", "engineering", "full"}, "the levels of detail"))
      s.detail = static_cast<Detail>(*which);

  MechanismPart mechanism = read_mechanism(table.find("mechanism"), origin.source, reader);
  const Entry *motion_at = table.find("motion"), *load_at = table.find("load"), *drive = table.find("drive"),
              *limits = table.find("limits"), *elasticity = table.find("elasticity"), *elements = table.find("element"),
              *sections = table.find("section");
  LoadPart load = read_load(load_at, reader);
  const bool motion_needed = need_motion(sections, kinds);
  MotionPart motion = read_motion(motion_at, motion_needed, mechanism, load.load, file, reader);
  s.load = sampled(std::move(load), motion.trajectory.time, diagnostics);
  if (motion_at == nullptr && !motion_needed)
    for (const Entry* e : {load_at, limits})
      if (e != nullptr)
        diagnostics.add(e->place, fmt::format("[{}] is for a motion, and this scenario has none", e->key),
                        fmt::format("remove it, or add [motion], duration = \"10 s\" and samples = 501"));
  s.drives = read_drives(drive, mechanism, reader);
  s.limits = read_limits(limits, mechanism, reader);
  read_elasticity(elasticity, elements, s.drives, mechanism, reader);
  const bool elastic_drives = drive != nullptr && says_stiffness(drive->value);
  const GivenTable tables[] = {
      {"drive", drive, elastic_drives}, {"limits", limits}, {"elasticity", elasticity, true}, {"element", elements, true}};
  s.sections = read_sections(sections, kinds, motion.span, mechanism, tables, s.drives, origin, reader);
  s.checks = read_checks(table.find("check"), {s.sections, mechanism.topology, motion.span, s.drives, kinds}, reader);
  table.finish();
  diagnostics.throw_if_any();

  s.mechanism = std::move(mechanism.name);
  s.parameters = std::move(mechanism.values);
  s.parameters_set = std::move(mechanism.set);
  s.motion = std::move(motion.request);
  out.trajectory = std::move(motion.trajectory);
  out.machine = std::move(mechanism.machine);
  return out;
}

Loaded load(const std::filesystem::path& file, const MechanismSource& source, Kinds kinds) { return load({file, source, kinds}); }

Loaded load(const Origin& origin) {
  const std::filesystem::path& file = origin.file;
  const std::string shown = printable(file.string());
  std::error_code error;
  if (!std::filesystem::exists(file, error)) refuse_file(shown, "there is no such file");
  if (std::filesystem::is_directory(file, error)) refuse_file(shown, "expected a scenario file, seen a folder");
  if (!std::filesystem::is_regular_file(file, error))
    refuse_file(shown, "expected a scenario file, seen a pipe or a device", "write the scenario to a file first");
  if (const auto size = std::filesystem::file_size(file, error); !error && size > largest_file)
    refuse_file(shown, fmt::format("expected at most {} MiB, seen {} bytes", largest_file >> 20, size));
  const auto text = read_file(file, largest_file);
  if (!text) refuse_file(shown, "the file cannot be read", "look at its permissions");
  return load_text(*text, origin);
}

}  // namespace pmreport::scenario
