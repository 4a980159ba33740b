#include <core/scenario/section/key.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace pmreport::scenario {

Shape Shape::of_kind(Kind kind) {
  Shape out;
  out.kind = kind;
  return out;
}

Shape Shape::text() { return of_kind(Kind::text); }

Shape Shape::boolean() { return of_kind(Kind::boolean); }

Shape Shape::whole(double least, double most) {
  Shape out = of_kind(Kind::whole);
  out.least = least, out.most = most;
  return out;
}

Shape Shape::quantity(std::optional<Dimension> dimension) {
  Shape out = of_kind(Kind::quantity);
  out.dimension = dimension;
  return out;
}

Shape Shape::word(std::vector<std::string> words) {
  Shape out = of_kind(Kind::word);
  out.words = std::move(words);
  return out;
}

Shape Shape::name_of(std::string named) {
  Shape out = of_kind(Kind::word);
  out.named = std::move(named);
  return out;
}

Shape Shape::table(std::vector<Key> keys) {
  Shape out = of_kind(Kind::table);
  out.keys = std::move(keys);
  return out;
}

Shape Shape::values_of(std::string named) { return values_of(std::move(named), {}); }

Shape Shape::values_of(std::string named, std::vector<Key> more) {
  Shape out = table(std::move(more));
  out.named = std::move(named);
  return out;
}

Shape Shape::tables(std::vector<Key> keys) {
  Shape out = of_kind(Kind::tables);
  out.keys = std::move(keys);
  return out;
}

Shape Shape::list(std::size_t least, std::size_t most, Shape item) {
  Shape out = of_kind(Kind::list);
  out.least = static_cast<double>(least), out.most = static_cast<double>(most);
  out.of.push_back(std::move(item));
  return out;
}

Shape Shape::either(std::vector<Shape> shapes) {
  Shape out = of_kind(Kind::either);
  out.of = std::move(shapes);
  return out;
}

namespace {

// "`x`", a list of them with the last after `last`.
std::string in_code(const std::vector<std::string>& words, const char* last, const char* quote) {
  std::vector<std::string> out;
  for (const std::string& w : words) out.push_back(fmt::format("`{0}{1}{0}`", quote, w));
  return listed(out, last);
}

std::string table_words(const Shape& shape) {
  std::vector<std::string> parts;
  if (!shape.named.empty()) parts.push_back(shape.named);
  for (const Key& k : shape.keys)
    parts.push_back(fmt::format("`{}` ({}{}{})", k.name, words_of(k.shape), k.meaning.empty() ? "" : ": " + k.meaning,
                                k.unset.empty() ? "" : "; " + k.unset + " if left out"));
  return listed(parts, "and");
}

}  // namespace

std::string words_of(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::text:
      return "text";
    case Shape::Kind::boolean:
      return "`true` or `false`";
    case Shape::Kind::whole:
      return fmt::format("whole number from {:.0f} to {:.0f}", shape.least, shape.most);
    case Shape::Kind::quantity:
      return shape.dimension ? name_of(*shape.dimension).substr(name_of(*shape.dimension).find(' ') + 1) : "quantity";
    case Shape::Kind::word:
      return shape.named.empty() ? in_code(shape.words, "or", "\"") : "name of one of the " + shape.named;
    case Shape::Kind::table:
      return "table of " + table_words(shape);
    case Shape::Kind::tables:
      return "tables of " + table_words(shape);
    case Shape::Kind::list: {
      const bool fixed = shape.least == shape.most;
      const bool open = shape.most >= static_cast<double>(std::numeric_limits<std::size_t>::max());
      return fmt::format("list of {}, each: {}",
                         fixed  ? fmt::format("{:.0f}", shape.least)
                         : open ? fmt::format("{:.0f} or more", shape.least)
                                : fmt::format("{:.0f} to {:.0f}", shape.least, shape.most),
                         words_of(shape.of.front()));
    }
    case Shape::Kind::either: {
      std::vector<std::string> parts;
      for (const Shape& s : shape.of) parts.push_back(words_of(s));
      return listed(parts, "or");
    }
  }
  return {};
}

}  // namespace pmreport::scenario
