#include <reports/section/comparison/comparison.hpp>

#include <core/scenario/section/keys.hpp>

#include <algorithm>

namespace pmreport::section {

using scenario::Shape;
namespace keys = scenario::keys;

namespace {

const std::vector<std::string> verdicts{"reproduces", "differs"};

std::vector<ComparisonRow> read_rows(const scenario::Entry& rows, const scenario::Measurable& measurable, const scenario::Reader& reader) {
  using Expected = ComparisonRow::Expected;
  std::vector<ComparisonRow> out;
  for (const scenario::Value* content : tables_of(&rows, "section.row", reader)) {
    scenario::TableReader table(*content, "[[section.row]]", content->place, reader);
    ComparisonRow row;
    row.line = content->place.line;
    const scenario::Entry *what = table.need("what", "what = \"largest force, limb 3\""),
                          *here = table.need("here", "here = \"max(abs(l3_force))\""), *paper = table.need("paper", "paper = \"312 N\""),
                          *tolerance = table.find("tolerance"), *verdict = table.find("verdict");
    if (what != nullptr) row.what = reader.text(what->value).value_or("");
    if (const scenario::Entry* e = table.find("source")) row.source = reader.text(e->value).value_or("");
    if (const scenario::Entry* e = table.find("note")) row.note = reader.text(e->value).value_or("");
    if (verdict != nullptr)
      if (const auto word = reader.word(verdict->value, verdicts, "the verdicts"))
        row.expected = *word == 0 ? Expected::reproduces : Expected::differs;
    table.finish();
    auto measured = here != nullptr ? read_measured(here->value, measurable, reader) : std::nullopt;
    if (!measured || !judged(*measured)) continue;
    row.here = std::move(*measured);
    const Dimension dimension = parse_unit(row.here.unit).value_or(Unit{}).dimension;
    if (paper != nullptr) {
      row.published = reader.quantity(paper->value, dimension).value_or(0);
      if (paper->value.kind == scenario::Value::Kind::text) row.written_in = unit_at_end(paper->value.text, dimension);
    }
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

std::vector<scenario::Key> all_keys() {
  const Shape value = Shape::quantity(std::nullopt);
  const Shape row = Shape::tables({keys::required(keys::within("what", Shape::text(), "the quantity, in words"), "what"),
                                   keys::required(keys::within("here", Shape::text(), "as in a check"), "here"),
                                   keys::required(keys::within("paper", value, "the published value"), "paper"),
                                   keys::within("tolerance", value, "counts need none"),
                                   keys::within("verdict", Shape::word(verdicts), "makes the row a gate"),
                                   keys::within("source", Shape::text(), ""), keys::within("note", Shape::text(), "")});
  return {keys::text<ComparisonOptions>("source", &ComparisonOptions::source, "of all rows"),
          keys::late(keys::required(
              keys::of<ComparisonOptions>("row", row, "the published values", "",
                                          [](const scenario::Entry& e, const scenario::Reading& r, ComparisonOptions& options) {
                                            options.rows = read_rows(e, *r.measurable, r.reader);
                                          }),
              "[[section.row]] with what, here, paper and tolerance"))};
}

}  // namespace

const SectionKind& comparison_kind() {
  static const SectionKind kind{{.name = "comparison",
                                 .purpose = "numbers of this report against published ones",
                                 .keys = all_keys(),
                                 .needs = {.motion = false, .values_of_others = true},
                                 .make_options = scenario::plain_options<ComparisonOptions>},
                                [](const Context& c, const scenario::Section& s) {
                                  return comparison_section(c.analysis, options_of<ComparisonOptions>(s), c.values);
                                }};
  return kind;
}

}  // namespace pmreport::section
