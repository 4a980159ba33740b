#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <core/scenario/read/document.hpp>
#include <core/scenario/read/nesting.hpp>
#include <core/text/text.hpp>
#include <optional>
#include <string_view>

namespace pmreport::scenario {
namespace {

Place place_of(const toml::source_region& region) { return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)}; }

// Where a character stands that no reader sees and no file of a report can bear: XML and terminals have none of them. TOML lets them in by
// an escape, "\u0000".
struct Control {
  unsigned code;
  std::size_t before;  // characters
};
std::optional<Control> first_control(std::string_view text) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool line = byte == '\t' || byte == '\n' || byte == '\r';
    if ((byte < 0x20 && !line) || byte == 0x7f) return Control{byte, characters};
    // U+0080 to U+009F are two bytes in UTF-8.
    if (byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0)
      return Control{static_cast<unsigned char>(text[i + 1]), characters};
    if ((byte & 0xc0) != 0x80) ++characters;
  }
  return std::nullopt;
}

// Reported, where there is one; true then. `what`: "a text for \"title\"".
bool refused(std::string_view text, Place place, const std::string& what, Diagnostics& diagnostics) {
  const std::optional<Control> control = first_control(text);
  if (control)
    diagnostics.add(place, fmt::format("expected {} without control characters but tabs and line breaks, seen U+{:04X} as its character {}",
                                       what, control->code, control->before + 1));
  return control.has_value();
}

Value value_of(const toml::node& node, const std::string& path, Diagnostics& diagnostics) {
  Value out;
  out.place = place_of(node.source());
  if (const auto* table = node.as_table()) {
    out.kind = Value::Kind::table;
    for (const auto& [key, value] : *table) {
      const std::string name(key.str());
      if (refused(name, place_of(key.source()), "a key", diagnostics)) continue;
      out.entries.push_back({name, place_of(key.source()), value_of(value, path.empty() ? name : path + "." + name, diagnostics)});
    }
    // toml++ sorts keys by name
    const auto earlier = [](const Entry& a, const Entry& b) {
      return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    };
    std::stable_sort(out.entries.begin(), out.entries.end(), earlier);
  } else if (const auto* array = node.as_array()) {
    out.kind = Value::Kind::array;
    for (const auto& item : *array) out.items.push_back(value_of(item, path, diagnostics));
  } else if (const auto* text = node.as_string()) {
    out.kind = Value::Kind::text;
    out.text = text->get();
    if (refused(out.text, out.place, "a text for " + in_quotes(path), diagnostics)) out.kind = Value::Kind::refused;
  } else if (const auto* integer = node.as_integer()) {
    out.kind = Value::Kind::integer;
    out.number = static_cast<double>(integer->get());
  } else if (const auto* number = node.as_floating_point()) {
    out.kind = Value::Kind::number;
    out.number = number->get();
    if (!std::isfinite(out.number)) {
      out.kind = Value::Kind::refused;
      diagnostics.add(out.place,
                      fmt::format("expected a finite number for {}, seen {}", in_quotes(path), std::isnan(out.number) ? "nan" : "inf"));
    }
  } else if (const auto* boolean = node.as_boolean()) {
    out.kind = Value::Kind::boolean;
    out.boolean = boolean->get();
  } else {
    out.kind = Value::Kind::date;
  }
  return out;
}

// A quantity without quotes, `x = 35 deg`: the commonest slip, which TOML can only call trailing text.
std::string hint_for(std::string_view line) {
  const auto equals = line.find('=');
  if (equals == std::string_view::npos) return {};
  std::string_view value = trim(line.substr(equals + 1));
  value = trim(value.substr(0, value.find('#')));
  const bool starts_number = !value.empty() && (std::string_view("+-.0123456789").find(value.front()) != std::string_view::npos);
  const bool more = value.find_first_not_of("+-.0123456789eE_") != std::string_view::npos;
  const bool marked = value.find_first_of("\"'[]{},:") != std::string_view::npos;
  return starts_number && more && !marked ? fmt::format("quote it: \"{}\"", value) : std::string();
}

}  // namespace

Value parse_document(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
  if (const auto place = too_deep(text))
    throw ScenarioError({{file, place->line, place->column,
                          fmt::format("expected at most {} levels of tables and lists in each other, seen more", deepest_nesting),
                          line_of(text, place->line), "a scenario has its keys in a table or two: [mechanism.parameters]"}});
  try {
    return value_of(toml::parse(text), "", diagnostics);
  } catch (const toml::parse_error& e) {
    const Place place = place_of(e.source());
    const std::string line = line_of(text, place.line);
    throw ScenarioError({{file, place.line, place.column, printable(e.description()), line, hint_for(line)}});
  }
}

std::string name_of(const Value& value) {
  switch (value.kind) {
    case Value::Kind::text:
      return "the text " + in_quotes(value.text);
    case Value::Kind::integer:
      return fmt::format("the number {}", value.number);
    case Value::Kind::number:
      return fmt::format("the number {}", value.number);
    case Value::Kind::boolean:
      return value.boolean ? "true" : "false";
    case Value::Kind::date:
      return "a date or time";
    case Value::Kind::array:
      return "a list";
    case Value::Kind::table:
      return "a table";
    case Value::Kind::refused:
      break;
  }
  return "a number that is not finite";
}

}  // namespace pmreport::scenario
