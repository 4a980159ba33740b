#include <fmt/format.h>

#include <core/scenario/measured_part.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

struct Bounds {  // as they stand in the table
  const Entry *below, *above, *equals, *within;
};

// Which of them may stand together, whatever their values are.
void judge_together(const Bounds& b, Place place, Diagnostics& diagnostics) {
  if (b.below == nullptr && b.above == nullptr && b.equals == nullptr)
    diagnostics.add(place, "expected a bound, below, above or equals, and there is none", "add a line: below = \"400 N\"");
  if (b.equals != nullptr && (b.below != nullptr || b.above != nullptr))
    diagnostics.add(b.equals->place, fmt::format("equals says all: {} says nothing beside it", b.below != nullptr ? "below" : "above"),
                    "keep one of the two, or write two checks");
  if (b.equals == nullptr && b.within != nullptr)
    diagnostics.add(b.within->place, "within is of equals, which is not there", "add a line: equals = \"400 N\"");
}

// A real number is never met exactly; whole numbers are.
void read_equality(const Bounds& b, const Dimension& dimension, Check& check, const Reader& reader) {
  check.equals = reader.quantity(b.equals->value, dimension);
  if (b.within == nullptr) {
    if (!check.count)
      reader.diagnostics().add(b.equals->place,
                               fmt::format("expected within beside equals, for {} is no whole number", in_quotes(check.that)),
                               fmt::format("add a line that tells how near is near enough: within = \"{}\"", example_of(dimension)));
    return;
  }
  const auto within = reader.quantity(b.within->value, dimension);
  check.within = within.value_or(0);
  if (within && (*within < 0 || (*within == 0 && !check.count)))
    reader.diagnostics().add(b.within->value.place, fmt::format("expected a distance above 0, seen {}", in_quotes(b.within->value.text)));
}

}  // namespace

std::vector<Check> read_checks(const Entry* entry, const Measurable& measurable, const Reader& reader) {
  std::vector<Check> out;
  for (const Value* content : tables_of(entry, "check", reader)) {
    TableReader table(*content, "[[check]]", content->place, reader);
    const Entry* that = table.need("that", "that = \"max(abs(actuator_force))\"");
    const Bounds b{table.find("below"), table.find("above"), table.find("equals"), table.find("within")};
    table.finish();
    judge_together(b, content->place, reader.diagnostics());
    auto measured = that != nullptr ? read_measured(that->value, measurable, reader) : std::nullopt;
    if (!measured || !judged(*measured)) continue;
    Check check{std::move(*measured), {}, {}, {}, 0, {}, content->place.line};
    const Dimension dimension = parse_unit(check.unit).value_or(Unit{}).dimension;
    if (b.below != nullptr) check.below = reader.quantity(b.below->value, dimension);
    if (b.above != nullptr) check.above = reader.quantity(b.above->value, dimension);
    if (b.equals != nullptr) read_equality(b, dimension, check, reader);
    for (const Entry* bound : {b.below, b.above, b.equals})
      if (bound != nullptr && check.written_in.empty() && bound->value.kind == Value::Kind::text)
        check.written_in = unit_at_end(bound->value.text, dimension);
    if (check.below && check.above && *check.above >= *check.below)
      reader.diagnostics().add(b.above->place, "nothing can be above this and below that: above must be less than below");
    out.push_back(std::move(check));
  }
  return out;
}

}  // namespace pmreport::scenario
