// A TOML file as a tree of values that know where they stand.
#pragma once

#include <core/scenario/read/diagnostics.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::scenario {

struct Entry;

struct Value {
  enum class Kind {
    text,
    integer,
    number,
    boolean,
    date,
    array,
    table,
    refused
  };  // refused: told already, as nan, inf and texts with control characters are
  Kind kind = Kind::table;
  Place place;
  std::string text;   // of a text
  double number = 0;  // of an integer or a number
  bool boolean = false;
  std::vector<Value> items;    // of an array
  std::vector<Entry> entries;  // of a table, in the order of the file
};

struct Entry {
  std::string key;
  Place place;  // of the key
  Value value;
};

// Throws ScenarioError at the first syntax error, or where tables and lists are nested beyond all sense; nan, inf and
// control characters in texts and keys are added to `diagnostics`.
Value parse_document(std::string_view text, const std::string& file, Diagnostics& diagnostics);

std::string name_of(const Value& value);  // "a text", "the number 400", "a table"

}  // namespace pmreport::scenario
