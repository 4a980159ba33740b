#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <core/scenario/read/reader.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

std::string with_example(const Dimension& d) {
  return d == Dimension{} ? name_of(d) : fmt::format("{} (e.g. \"{}\")", name_of(d), example_of(d));
}

// The unit of the example: what a number without one was probably meant to have.
std::string likely_unit(const Dimension& d) {
  const std::string example = example_of(d);
  return example.substr(std::min(example.find(' '), example.size()));
}

constexpr std::size_t most_tables = 1000;  // of one name: a report of more sections, checks or waypoints has no reader

bool is_number(const Value& v) { return v.kind == Value::Kind::integer || v.kind == Value::Kind::number; }

}  // namespace

std::vector<const Value*> tables_of(const Entry* entry, const std::string& name, const Reader& reader) {
  std::vector<const Value*> out;
  if (entry == nullptr || entry->value.kind == Value::Kind::refused) return out;
  if (entry->value.kind != Value::Kind::array) {
    reader.diagnostics().add(entry->place, fmt::format("expected a list of tables, seen {}", name_of(entry->value)),
                             fmt::format("write [[{}]] with two brackets, once for each", name));
    return out;
  }
  for (const Value& item : entry->value.items) {
    if (out.size() == most_tables) {
      reader.diagnostics().add(item.place,
                               fmt::format("expected at most {} tables [[{}]], seen {}", most_tables, name, entry->value.items.size()));
      return out;
    }
    if (item.kind == Value::Kind::table)
      out.push_back(&item);
    else if (item.kind != Value::Kind::refused)
      reader.diagnostics().add(item.place, fmt::format("expected a table [[{}]], seen {}", name, name_of(item)));
  }
  return out;
}

const Value* table_of(const Entry* entry, const std::string& name, const Reader& reader) {
  if (entry == nullptr) return nullptr;
  if (entry->value.kind == Value::Kind::table) return &entry->value;
  if (entry->value.kind != Value::Kind::refused)
    reader.diagnostics().add(entry->place, fmt::format("expected a table [{}], seen {}", name, name_of(entry->value)));
  return nullptr;
}

bool finite(const Jet<double>& x, double t, Place place, const std::string& what, Diagnostics& diagnostics) {
  const char* missing = !std::isfinite(x.value)          ? "value"
                        : !std::isfinite(x.rate)         ? "rate"
                        : !std::isfinite(x.acceleration) ? "acceleration"
                                                         : nullptr;
  if (missing == nullptr) return true;
  diagnostics.add(place, fmt::format("{} has no finite {} at t = {} s", what, missing, format_number(t, 6)));
  return false;
}

void Reader::takes(const Value& v, const Shape& as) const {
  if (asked_ != nullptr) asked_->taken[&v] = as;
}

void Reader::looks_for(const Value& table, std::string_view key, bool needed) const {
  if (asked_ != nullptr) asked_->note_key(table, key, needed);
}

std::optional<std::string> Reader::text(const Value& v) const {
  takes(v, Shape::text());
  if (v.kind == Value::Kind::text) return v.text;
  if (v.kind != Value::Kind::refused) diagnostics_.add(v.place, "expected a text in quotes, seen " + name_of(v));
  return std::nullopt;
}

std::optional<bool> Reader::boolean(const Value& v) const {
  takes(v, Shape::boolean());
  if (v.kind == Value::Kind::boolean) return v.boolean;
  if (v.kind != Value::Kind::refused) diagnostics_.add(v.place, "expected true or false, seen " + name_of(v));
  return std::nullopt;
}

std::optional<double> Reader::integer(const Value& v, double least, double most) const {
  takes(v, Shape::whole(least, most));
  if (v.kind == Value::Kind::integer && v.number >= least && v.number <= most) return v.number;
  if (v.kind != Value::Kind::refused)
    diagnostics_.add(v.place, fmt::format("expected a whole number from {} to {}, seen {}", least, most, name_of(v)));
  return std::nullopt;
}

std::optional<std::size_t> Reader::word(const Value& v, const std::vector<std::string>& words, std::string_view what) const {
  const auto given = text(v);
  takes(v, Shape::word(words));
  if (!given) return std::nullopt;
  const auto found = std::find(words.begin(), words.end(), *given);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  const bool few = words.size() <= 4;
  diagnostics_.add(v.place,
                   fmt::format("expected {}, seen {}{}", few ? listed(words, "or", true) : fmt::format("one of {}", what),
                               in_quotes(*given), did_you_mean(*given, words)),
                   few ? std::string() : fmt::format("{} are {}", what, listed(words, "and", true)));
  return std::nullopt;
}

void Reader::refuse(const Value& v, const ExpressionError& e) const {
  diagnostics_.add(diagnostics_.inside(v.place, v.text, e.offset), e.what(), e.hint);
}

std::optional<Written> Reader::expression(const Value& v, const Dimension& expected, Time time, std::span<const Variable> variables) const {
  takes(v, Shape::quantity(expected));
  if (is_number(v) && expected != Dimension{}) {
    diagnostics_.add(v.place, fmt::format("expected {}, seen {} without a unit", with_example(expected), name_of(v)),
                     fmt::format("write \"{}{}\", with the unit that you mean", v.number, likely_unit(expected)));
    return std::nullopt;
  }
  if (v.kind != Value::Kind::text && !is_number(v)) {
    if (v.kind != Value::Kind::refused) diagnostics_.add(v.place, fmt::format("expected {}, seen {}", with_example(expected), name_of(v)));
    return std::nullopt;
  }
  const std::string written = is_number(v) ? fmt::format("{}", v.number) : v.text;
  try {
    Written out{written, v.place, Expression::parse(written, time, variables)};
    if (out.expression.dimension() == expected) return out;
    const bool no_unit = out.expression.dimension() == Dimension{};
    diagnostics_.add(v.place, fmt::format("expected {}, seen {}", with_example(expected), name_of(out.expression.dimension())),
                     no_unit ? fmt::format("give it a unit, such as{}", likely_unit(expected)) : std::string());
  } catch (const ExpressionError& e) {
    refuse(v, e);
  }
  return std::nullopt;
}

std::optional<double> Reader::quantity(const Value& v, const Dimension& expected) const {
  const auto written = expression(v, expected, Time::forbidden);
  if (!written) return std::nullopt;
  const double value = written->expression.at(0).value;
  if (std::isfinite(value)) return value;
  diagnostics_.add(v.place, fmt::format("expected a finite number, but {} has no such value", in_quotes(written->text)));
  return std::nullopt;
}

const std::vector<Value>* Reader::list(const Value& v, std::size_t count, std::string_view what) const {
  takes(v, Shape::list(count, count, Shape::text()));
  if (v.kind == Value::Kind::array && v.items.size() == count) return &v.items;
  if (v.kind != Value::Kind::refused)
    diagnostics_.add(v.place, fmt::format("expected a list of {}, seen {}", what,
                                          v.kind == Value::Kind::array ? fmt::format("{} items", v.items.size()) : name_of(v)));
  return nullptr;
}

const Entry* TableReader::find(std::string_view key) {
  reader_.looks_for(table_, key);
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
  const auto found = std::find_if(table_.entries.begin(), table_.entries.end(), [&](const Entry& e) { return e.key == key; });
  return found != table_.entries.end() ? &*found : nullptr;
}

const Entry* TableReader::need(std::string_view key, std::string_view example) {
  const Entry* entry = find(key);
  reader_.looks_for(table_, key, true);
  if (entry == nullptr)
    reader_.diagnostics().add(place_, fmt::format("expected the key {} in {}, which is not there", in_quotes(key), name_),
                              fmt::format("add a line: {}", example));
  return entry;
}

void TableReader::finish(const std::string& where) const {
  for (const Entry& e : table_.entries)
    if (std::find(known_.begin(), known_.end(), e.key) == known_.end())
      reader_.diagnostics().add(
          e.place, fmt::format("unknown key {} in {}{}", in_quotes(e.key), where.empty() ? name_ : where, did_you_mean(e.key, known_)),
          fmt::format("the keys are {}", listed(known_, "and")));
}

}  // namespace pmreport::scenario
