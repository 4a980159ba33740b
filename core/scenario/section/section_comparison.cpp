#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/section/section_part.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {

std::vector<ComparisonRow> read_comparison_rows(const Entry& rows, const Measurable& measurable, const Reader& reader) {
  using Expected = ComparisonRow::Expected;
  std::vector<ComparisonRow> out;
  for (const Value* content : tables_of(&rows, "section.row", reader)) {
    TableReader table(*content, "[[section.row]]", content->place, reader);
    ComparisonRow row;
    row.line = content->place.line;
    const Entry *what = table.need("what", "what = \"largest force, limb 3\""), *here = table.need("here", "here = \"max(abs(l3_force))\""),
                *paper = table.need("paper", "paper = \"312 N\""), *tolerance = table.find("tolerance"), *verdict = table.find("verdict");
    if (what != nullptr) row.what = reader.text(what->value).value_or("");
    if (const Entry* e = table.find("source")) row.source = reader.text(e->value).value_or("");
    if (const Entry* e = table.find("note")) row.note = reader.text(e->value).value_or("");
    if (verdict != nullptr)
      if (const auto word = reader.word(verdict->value, {"reproduces", "differs"}, "the verdicts"))
        row.expected = *word == 0 ? Expected::reproduces : Expected::differs;
    table.finish();
    auto measured = here != nullptr ? read_measured(here->value, measurable, reader) : std::nullopt;
    if (!measured || !judged(*measured)) continue;
    row.here = std::move(*measured);
    const Dimension dimension = parse_unit(row.here.unit).value_or(Unit{}).dimension;
    if (paper != nullptr) row.published = reader.quantity(paper->value, dimension).value_or(0);
    if (tolerance != nullptr) {
      row.tolerance = reader.quantity(tolerance->value, dimension).value_or(0);
      if (row.tolerance < 0) reader.diagnostics().add(tolerance->value.place, "expected a tolerance of 0 or above");
    } else if (!row.here.count) {  // a count agrees or does not
      const std::string example = example_of(dimension), unit = example.substr(std::min(example.find(' '), example.size()));
      table.need("tolerance", fmt::format("tolerance = \"0.05{}\", half a unit of the last digit that is printed", unit));
    }
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace pmreport::scenario
