#include <reports/program/cli/shape_json.hpp>

#include <core/text/units.hpp>

#include <fmt/format.h>

namespace pmreport::program {

using scenario::Key, scenario::Shape;

namespace {

constexpr double largest_count = 1e15;  // more is no bound that anybody set

// A quantity is an expression in a string; a plain number needs no quotes where it has no unit.
Json json_of_quantity(const std::optional<Dimension>& dimension) {
  if (!dimension) return {{"type", {"string", "number"}}, {"description", "a quantity with its unit, in quotes"}};
  if (*dimension == Dimension{}) return {{"type", {"string", "number"}}, {"description", name_of(*dimension)}};
  return {{"type", "string"}, {"description", fmt::format("{}, such as \"{}\"", name_of(*dimension), example_of(*dimension))}};
}

// What the key means, what it takes, and what counts where it is left out.
std::string words_of(const Key& key, const Json& value) {
  std::string out = key.meaning;
  if (value.contains("description")) {
    const std::string takes = value["description"];
    out += out.empty() ? takes : ": " + takes;
  }
  return key.unset.empty() ? out : out + "; " + key.unset + " if left out";
}

}  // namespace

Json json_of_keys(const std::vector<Key>& keys, const NamesByKind& names) {
  Json properties = Json::object(), needed = Json::array();
  for (const Key& key : keys) {
    Json value = json_of(key.shape, names);
    if (const std::string words = words_of(key, value); !words.empty()) value["description"] = words;
    properties[key.name] = std::move(value);
    if (key.required()) needed.push_back(key.name);
  }
  Json out{{"type", "object"}, {"properties", std::move(properties)}};
  if (!needed.empty()) out["required"] = std::move(needed);
  out["additionalProperties"] = false;
  return out;
}

Json json_of(const Shape& shape, const NamesByKind& names) {
  const auto named = names.find(shape.named);
  switch (shape.kind) {
    case Shape::Kind::text:
      return {{"type", "string"}};
    case Shape::Kind::boolean:
      return {{"type", "boolean"}};
    case Shape::Kind::whole:
      return {{"type", "integer"}, {"minimum", static_cast<std::int64_t>(shape.least)}, {"maximum", static_cast<std::int64_t>(shape.most)}};
    case Shape::Kind::quantity:
      return json_of_quantity(shape.dimension);
    case Shape::Kind::word:
      if (shape.named.empty()) return {{"enum", shape.words}};
      return named != names.end() ? Json{{"enum", named->second}} : Json{{"type", "string"}, {"description", "one of the " + shape.named}};
    case Shape::Kind::table:
    case Shape::Kind::tables: {
      Json table = json_of_keys(shape.keys, names);
      if (!shape.named.empty() && named == names.end()) table["additionalProperties"] = true;
      if (named != names.end())
        for (const std::string& name : named->second)
          if (!table["properties"].contains(name)) table["properties"][name] = Json::object();
      return shape.kind == Shape::Kind::table ? table : Json{{"type", "array"}, {"items", std::move(table)}};
    }
    case Shape::Kind::list: {
      Json out{{"type", "array"}, {"items", json_of(shape.of.front(), names)}};
      if (shape.least > 0) out["minItems"] = static_cast<std::int64_t>(shape.least);
      if (shape.most < largest_count) out["maxItems"] = static_cast<std::int64_t>(shape.most);
      return out;
    }
    case Shape::Kind::either: {
      if (shape.of.empty()) return Json::object();
      Json any = Json::array();
      for (const Shape& s : shape.of) any.push_back(json_of(s, names));
      return {{"anyOf", std::move(any)}};
    }
  }
  return Json::object();
}

}  // namespace pmreport::program
