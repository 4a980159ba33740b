#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <core/scenario/read/document.hpp>
#include <core/scenario/read/nesting.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

Place place_of(const toml::source_region& region) { return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)}; }

Value value_of(const toml::node& node, const std::string& path, Diagnostics& diagnostics) {
  Value out;
  out.place = place_of(node.source());
  if (const auto* table = node.as_table()) {
    out.kind = Value::Kind::table;
    for (const auto& [key, value] : *table) {
      const std::string name(key.str());
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
