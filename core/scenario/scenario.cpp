#include <core/scenario/scenario.hpp>

#include <fmt/format.h>

#include <algorithm>

#include <core/scenario/parts.hpp>
#include <core/scenario/read/csv.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

constexpr std::size_t largest_file = 4u << 20;  // [bytes]

constexpr const char* smallest_scenario =
    "a scenario has title = \"...\", [mechanism] with use, [motion] with duration and samples, and at least one [[section]] with kind";

[[noreturn]] void refuse_file(const std::string& file, std::string message, std::string hint = {}) {
  throw ScenarioError({{file, 0, 0, std::move(message), {}, std::move(hint)}});
}

std::string text_or_nothing(const Entry* entry, const Reader& reader) {
  return entry != nullptr ? reader.text(entry->value).value_or("") : std::string();
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

std::vector<const Value*> tables_of(const Entry* entry, const std::string& name, const Reader& reader) {
  std::vector<const Value*> out;
  if (entry == nullptr || entry->value.kind == Value::Kind::refused) return out;
  if (entry->value.kind != Value::Kind::array) {
    reader.diagnostics().add(entry->place, fmt::format("expected a list of tables, seen {}", name_of(entry->value)),
                             fmt::format("write [[{}]] with two brackets, once for each", name));
    return out;
  }
  for (const Value& item : entry->value.items) {
    if (item.kind == Value::Kind::table)
      out.push_back(&item);
    else if (item.kind != Value::Kind::refused)
      reader.diagnostics().add(item.place, fmt::format("expected a table [[{}]], seen {}", name, name_of(item)));
  }
  return out;
}

const Value* table_of(const Entry* entry, const std::string& name, const Reader& reader) {
  if (entry == nullptr) return nullptr;
  if (entry->value.kind == Value::Kind::table) return &entry->value;
  if (entry->value.kind != Value::Kind::refused)
    reader.diagnostics().add(entry->place, fmt::format("expected a table [{}], seen {}", name, name_of(entry->value)));
  return nullptr;
}

Loaded load_text(const std::string& text, const std::filesystem::path& file, const MechanismSource& source, Kinds kinds) {
  const std::string shown = printable(file.string());
  if (text.size() > largest_file)
    refuse_file(shown, fmt::format("expected at most {} MiB, seen {} bytes", largest_file >> 20, text.size()));
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    refuse_file(shown, "expected a scenario, seen an empty file", smallest_scenario);

  Diagnostics diagnostics(shown, text);
  const Reader reader(diagnostics);
  const Value document = parse_document(text, shown, diagnostics);
  TableReader table(document, "the scenario", {}, reader);

  Loaded out;
  Scenario& s = out.scenario;
  s.file = file;
  s.text = text;
  const Entry* title = table.need("title", "title = \"...\"");
  s.title = text_or_nothing(title, reader);
  if (title != nullptr && title->value.kind == Value::Kind::text && trim(s.title).empty())
    diagnostics.add(title->value.place, "expected a title, seen an empty text");
  s.author = text_or_nothing(table.find("author"), reader);
  s.description = text_or_nothing(table.find("description"), reader);

  MechanismPart mechanism = read_mechanism(table.find("mechanism"), source, reader);
  const Entry* motion_at = table.find("motion");
  LoadPart load = read_load(table.find("load"), reader);
  MotionPart motion = read_motion(motion_at, mechanism, load.load, file, reader);
  s.load = sampled(std::move(load), motion.motion.time, diagnostics);
  const Entry *drive = table.find("drive"), *limits = table.find("limits");
  s.drives = read_drives(drive, mechanism, reader);
  s.limits = read_limits(limits, mechanism, reader);
  const GivenTable tables[] = {{"drive", drive}, {"limits", limits}};
  s.sections = read_sections(table.find("section"), kinds, motion.interval, mechanism, tables, s.drives, reader);
  s.checks = read_checks(table.find("check"), {s.sections, mechanism.topology, motion.interval, s.drives, kinds}, reader);
  table.finish();
  diagnostics.throw_if_any();

  s.mechanism = std::move(mechanism.name);
  s.parameters = std::move(mechanism.values);
  s.parameters_set = std::move(mechanism.set);
  s.motion = std::move(motion.motion);
  out.machine = std::move(mechanism.machine);
  return out;
}

Loaded load(const std::filesystem::path& file, const MechanismSource& source, Kinds kinds) {
  const std::string shown = printable(file.string());
  std::error_code error;
  if (!std::filesystem::exists(file, error)) refuse_file(shown, "there is no such file");
  if (std::filesystem::is_directory(file, error)) refuse_file(shown, "expected a scenario file, seen a folder");
  if (const auto size = std::filesystem::file_size(file, error); !error && size > largest_file)
    refuse_file(shown, fmt::format("expected at most {} MiB, seen {} bytes", largest_file >> 20, size));
  const auto text = read_file(file, largest_file);
  if (!text) refuse_file(shown, "the file cannot be read", "look at its permissions");
  return load_text(*text, file, source, kinds);
}

}  // namespace pmreport::scenario
