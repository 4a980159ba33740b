#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/section/reading.hpp>

namespace pmreport::scenario {
namespace {

std::vector<std::string> names_of(Kinds kinds) {
  std::vector<std::string> out;
  for (const SectionKind* kind : kinds) out.push_back(kind->name);
  return out;
}

const Entry* entry_of(const std::string& table, std::span<const GivenTable> tables) {
  const auto found = std::find_if(tables.begin(), tables.end(), [&](const GivenTable& t) { return t.name == table; });
  return found != tables.end() ? found->entry : nullptr;
}

// A section that has nothing to show without its table, and a table that no section shows.
void match_tables(const std::vector<Section>& sections, const std::vector<Place>& kinds_at, Kinds kinds, std::span<const GivenTable> tables,
                  const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  const bool elastic_shown = std::any_of(sections.begin(), sections.end(), [](const Section& s) {
    return s.kind == nullptr || s.kind->needs.stiffness || s.kind->needs.reactions;
  });
  const auto elastic = [&](const std::string& name) {
    return std::any_of(tables.begin(), tables.end(), [&](const GivenTable& t) { return t.name == name && t.elastic; });
  };
  for (const GivenTable& table : tables)
    if (table.entry != nullptr && table.elastic && !elastic_shown && (table.name == "elasticity" || table.name == "element"))
      diagnostics.add(
          table.entry->place,
          fmt::format("[{}] is for the sections \"stiffness\" and \"reactions\", which this scenario does not have", table.name),
          "add [[section]] and kind = \"stiffness\", or remove it");
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (sections[i].kind == nullptr) continue;
    for (const NeededTable& table : sections[i].kind->tables)
      if (entry_of(table.name, tables) == nullptr)
        diagnostics.add(kinds_at[i], fmt::format("a section {} needs {}", in_quotes(sections[i].kind->name), table.lacking), table.hint);
  }
  for (const SectionKind* kind : kinds)
    for (const NeededTable& table : kind->tables) {
      const Entry* given = entry_of(table.name, tables);
      const bool shown =
          std::any_of(sections.begin(), sections.end(), [&](const Section& s) { return s.kind == kind || s.kind == nullptr; });
      if (given != nullptr && !shown && !table.idle.empty() && !(elastic_shown && elastic(table.name)))
        diagnostics.add(given->place,
                        fmt::format("[{}] is for the section {}, which this scenario does not have", table.name, in_quotes(kind->name)),
                        fmt::format("add [[section]] and kind = {}; {}", in_quotes(kind->name), table.idle));
    }
}

// What is read when all sections are known.
struct Late {
  const Key* key;
  const Entry* entry;
  std::shared_ptr<Options> options;
  bool of_others;  // its section is made of numbers of the others
};

void read_keys(const SectionKind& kind, TableReader& table, const Reading& reading, Section& section, std::vector<Late>& late) {
  if (kind.make_options == nullptr) return;
  const std::shared_ptr<Options> options = kind.make_options();
  section.options = options;
  for (const Key& key : kind.keys) {
    const Entry* entry = key.required() ? table.need(key.name, key.example) : table.find(key.name);
    if (entry == nullptr) continue;
    if (key.late)
      late.push_back({&key, entry, options, kind.needs.values_of_others});
    else
      key.read(*entry, reading, *options);
  }
  if (kind.complete != nullptr) kind.complete(table, reading, *options);
}

}  // namespace

// Only what is no section at all, or one that needs a motion, asks for it: a mistake in a kind is told by itself.
bool need_motion(const Entry* sections, Kinds kinds) {
  if (sections == nullptr || sections->value.items.empty()) return true;
  const auto moves = [&](const Entry& e) {
    return e.key == "kind" && e.value.kind == Value::Kind::text &&
           std::any_of(kinds.begin(), kinds.end(), [&](const SectionKind* k) { return k->name == e.value.text && k->needs.motion; });
  };
  return std::any_of(sections->value.items.begin(), sections->value.items.end(),
                     [&](const Value& section) { return std::any_of(section.entries.begin(), section.entries.end(), moves); });
}

Needs& Needs::operator|=(const Needs& more) {
  motion |= more.motion;
  statics |= more.statics;
  dynamics |= more.dynamics;
  drives |= more.drives;
  reactions |= more.reactions;
  transmission |= more.transmission;
  stiffness |= more.stiffness;
  pictures |= more.pictures;
  values_of_others |= more.values_of_others;
  displacement_evidence |= more.displacement_evidence;
  velocity_evidence |= more.velocity_evidence;
  acceleration_evidence |= more.acceleration_evidence;
  force_evidence |= more.force_evidence;
  power_evidence |= more.power_evidence;
  return *this;
}

std::vector<Section> read_sections(const Entry* entry, Kinds kinds, const std::optional<TimeSpan>& span, const MechanismPart& mechanism,
                                   std::span<const GivenTable> tables, const std::vector<mechanics::DriveTrain>& drives,
                                   const Origin& origin, const Reader& reader) {
  const auto contents = tables_of(entry, "section", reader);
  const std::vector<std::string> names = names_of(kinds);
  if (contents.empty() && (entry == nullptr || entry->value.kind == Value::Kind::array))
    reader.diagnostics().add(entry != nullptr ? entry->place : Place{}, "expected at least one section, and there is none",
                             fmt::format("write [[section]] and kind = \"displacement\"; the kinds are {}", listed(names, "and")));
  const Reading reading{reader, span, mechanism, nullptr, &origin};
  std::vector<Section> out;
  std::vector<Place> kinds_at;
  std::vector<Late> late;
  for (const Value* content : contents) {
    TableReader table(*content, "[[section]]", content->place, reader);
    Section section;
    section.line = content->place.line;
    const Entry *kind = table.need("kind", "kind = \"displacement\""), *title = table.find("title");
    if (title != nullptr) section.title = reader.text(title->value).value_or("");
    const auto index = kind != nullptr ? reader.word(kind->value, names, "the kinds of section") : std::nullopt;
    kinds_at.push_back(kind != nullptr ? kind->value.place : content->place);
    if (!index) {  // without a kind nobody knows which keys are right; the section stays, as one of any kind
      out.push_back(std::move(section));
      continue;
    }
    section.kind = kinds[*index];
    const auto same = std::find_if(out.begin(), out.end(), [&](const Section& s) { return s.kind == section.kind; });
    if (!section.kind->several && same != out.end())
      reader.diagnostics().add(kind->value.place, fmt::format("a report has one section {}; the first is in line {}",
                                                              in_quotes(section.kind->name), same->line));
    read_keys(*section.kind, table, reading, section, late);
    table.finish(fmt::format("a section of kind {}", in_quotes(section.kind->name)));
    out.push_back(std::move(section));
  }
  match_tables(out, kinds_at, kinds, tables, reader);
  const Measurable measurable{out, mechanism.topology, span, drives, kinds};
  // What names numbers of sections comes after what decides which numbers they have.
  std::stable_partition(late.begin(), late.end(), [](const Late& l) { return !l.of_others; });
  for (const Late& l : late) l.key->read(*l.entry, {reader, span, mechanism, &measurable, &origin}, *l.options);
  return out;
}

}  // namespace pmreport::scenario
