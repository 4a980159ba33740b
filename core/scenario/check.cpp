#include <core/scenario/measured_part.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {

std::vector<Check> read_checks(const Entry* entry, const Measurable& measurable, const Reader& reader) {
  std::vector<Check> out;
  for (const Value* content : tables_of(entry, "check", reader)) {
    TableReader table(*content, "[[check]]", content->place, reader);
    const Entry *that = table.need("that", "that = \"max(abs(actuator_force))\""), *below = table.find("below"),
                *above = table.find("above");
    table.finish();
    if (below == nullptr && above == nullptr)
      reader.diagnostics().add(content->place, "expected a bound, below or above, and there is none", "add a line: below = \"400 N\"");
    auto measured = that != nullptr ? read_measured(that->value, measurable, reader) : std::nullopt;
    if (!measured || !judged(*measured)) continue;
    Check check{std::move(*measured), {}, {}, content->place.line};
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
