#include <fmt/format.h>

#include <algorithm>
#include <core/mechanics/columns.hpp>
#include <core/scenario/parts.hpp>
#include <core/scenario/text.hpp>

namespace pmreport::scenario {
namespace {

const std::vector<std::string> reductions{"min", "max", "rms", "at"};
constexpr const char* forms = "write max(abs(actuator_force)), min(l1), rms(x_rate) or at(l1, 2.5 s)";

struct Piece {  // of the text of a check
  std::string_view text;
  std::size_t offset = 0;
};

Piece piece(const std::string& whole, std::size_t begin, std::size_t end) {
  const std::string_view raw = std::string_view(whole).substr(begin, end - begin), text = trim(raw);
  return {text, text.empty() ? begin : static_cast<std::size_t>(text.data() - whole.data())};
}

// What stands in "name( ... )", parts without blanks around them.
struct Call {
  Piece name, inside;
};
Call call(const std::string& whole, const Piece& p) {
  const std::size_t open = p.text.find('(');
  if (open == std::string_view::npos || p.text.back() != ')')
    throw ExpressionError(p.offset, fmt::format("expected a reduction of a column, seen {}", in_quotes(p.text)), forms);
  return {piece(whole, p.offset, p.offset + open), piece(whole, p.offset + open + 1, p.offset + p.text.size() - 1)};
}

// "max(abs(actuator_force))" or "at(l1, 2.5 s)": the reduction goes to `check`; where its parts stand is returned.
struct Parts {
  Piece column, time;  // column: or a group of columns
};
Parts parse_that(const std::string& that, Check& check) {
  const Call outer = call(that, piece(that, 0, that.size()));
  check.reduction = outer.name.text;
  if (std::find(reductions.begin(), reductions.end(), check.reduction) == reductions.end())
    throw ExpressionError(
        outer.name.offset,
        fmt::format("expected {}, seen {}{}", listed(reductions), in_quotes(check.reduction), did_you_mean(check.reduction, reductions)),
        forms);
  Piece inside = outer.inside, time{};
  if (check.reduction == "at") {
    const std::size_t comma = inside.text.rfind(',');
    if (comma == std::string_view::npos)
      throw ExpressionError(inside.offset + inside.text.size(), "expected a comma and a time (e.g. \"at(l1, 2.5 s)\")");
    time = piece(that, inside.offset + comma + 1, inside.offset + inside.text.size());
    inside = piece(that, inside.offset, inside.offset + comma);
    try {
      const Expression t = Expression::parse(time.text, Time::forbidden);
      if (t.dimension() != Dimension{0, 0, 1, 0})
        throw ExpressionError(0, fmt::format("expected a time (e.g. \"2.5 s\"), seen {}", name_of(t.dimension())));
      check.time = t.at(0).value;
    } catch (const ExpressionError& e) {
      throw ExpressionError(time.offset + e.offset, e.what(), e.hint);
    }
  }
  if (inside.text.find('(') == std::string_view::npos) return {inside, time};
  const Call absolute = call(that, inside);
  if (absolute.name.text != "abs")
    throw ExpressionError(absolute.name.offset, fmt::format("expected abs or a column, seen {}", in_quotes(absolute.name.text)), forms);
  check.absolute = true;
  return {absolute.inside, time};
}

// Finds the columns of a name: a column or a group of a section that the report has.
void resolve(const Piece& name, const std::vector<SectionRequest>& sections, const Topology& topology, Check& check) {
  std::vector<std::string> known, groups;
  bool mixed = false;
  for (const std::string& section : mechanics::sections_with_columns()) {
    const bool requested =
        std::any_of(sections.begin(), sections.end(), [&](const SectionRequest& s) { return s.kind == section || s.kind.empty(); });
    for (const mechanics::Column& column : mechanics::columns_of(section, topology)) {
      const bool meant = column.name == name.text || column.group == name.text;
      if (meant && !requested) {
        throw ExpressionError(
            name.offset,
            fmt::format("{} belongs to the section {}, which this scenario does not have", in_quotes(name.text), in_quotes(section)),
            fmt::format("add [[section]] and kind = \"{}\"", section));
      }
      known.push_back(column.name);
      if (std::find(groups.begin(), groups.end(), column.group) == groups.end()) groups.push_back(column.group);
      if (!meant) continue;
      mixed = mixed || (!check.columns.empty() && column.unit != check.unit);
      check.columns.push_back(column.name);
      check.unit = column.unit;
    }
  }
  known.insert(known.end(), groups.begin(), groups.end());
  if (check.columns.empty())
    throw ExpressionError(
        name.offset, fmt::format("no column or group is called {}{}", in_quotes(name.text), did_you_mean(name.text, known)),
        fmt::format("the groups of columns are {}; a single column is called as in the data files", listed(groups, "and")));
  if (mixed)
    throw ExpressionError(name.offset, fmt::format("the columns of {} have different units", in_quotes(name.text)),
                          fmt::format("name one of them: {}", listed(check.columns)));
}

}  // namespace

std::vector<Check> read_checks(const Entry* entry, const std::vector<SectionRequest>& sections, const std::optional<Topology>& topology,
                               const std::optional<Interval>& interval, const Reader& reader) {
  std::vector<Check> out;
  for (const Value* content : tables_of(entry, "check", reader)) {
    TableReader table(*content, "[[check]]", content->place, reader);
    Check check;
    check.line = content->place.line;
    const Entry *that = table.need("that", "that = \"max(abs(actuator_force))\""), *below = table.find("below"),
                *above = table.find("above");
    table.finish();
    if (below == nullptr && above == nullptr)
      reader.diagnostics().add(content->place, "expected a bound, below or above, and there is none", "add a line: below = \"400 N\"");
    const auto text = that != nullptr ? reader.text(that->value) : std::nullopt;
    if (!text) continue;
    check.that = *text;
    try {
      const auto [name, time] = parse_that(*text, check);
      if (check.reduction == "at" && interval && !(check.time >= interval->begin && check.time <= interval->end))
        throw ExpressionError(time.offset,
                              fmt::format("expected a time within the motion, {} s to {} s, seen {} s", format_number(interval->begin, 6),
                                          format_number(interval->end, 6), format_number(check.time, 6)));
      if (!topology) continue;
      resolve(name, sections, *topology, check);
    } catch (const ExpressionError& e) {
      reader.refuse(that->value, e);
      continue;
    }
    const Dimension dimension = parse_unit(check.unit).value_or(Unit{}).dimension;
    if (below != nullptr) check.below = reader.quantity(below->value, dimension);
    if (above != nullptr) check.above = reader.quantity(above->value, dimension);
    if (check.below && check.above && *check.above >= *check.below)
      reader.diagnostics().add(above->place, "nothing can be above this and below that: above must be less than below");
    out.push_back(std::move(check));
  }
  return out;
}

}  // namespace pmreport::scenario
