// A key of a section, as data: what may stand there, what it means, and how it gets into the options of its kind. Reading, the table in
// README.md and every other description of the keys come from here.
#pragma once

#include <core/text/units.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

struct Entry;
struct Reading;  // reading.hpp
struct Key;

// What a section was asked besides its kind; each kind with keys derives its own.
struct Options {
  virtual ~Options() = default;
};

// What may stand as a value.
struct Shape {
  enum class Kind { text, boolean, whole, quantity, word, table, tables, list, either } kind = Kind::text;
  double least = 0, most = 0;          // whole: its range; list: that of the number of items
  std::optional<Dimension> dimension;  // quantity; nothing: that of what it is held against
  std::vector<std::string> words;      // word: the choices
  std::string named;                   // word, table: of the mechanism's "coordinates", "actuators" or "joints"
  std::vector<Shape> of;               // list: the one shape of its items; either: each shape that may stand
  std::vector<Key> keys;               // table, and tables [[section.KEY]]; those that `named` tells are not among them

  static Shape text();
  static Shape boolean();
  static Shape whole(double least, double most);
  static Shape quantity(std::optional<Dimension> dimension);
  static Shape word(std::vector<std::string> words);
  static Shape name_of(std::string named);  // a word
  static Shape table(std::vector<Key> keys);
  static Shape values_of(std::string named);  // a table
  static Shape values_of(std::string named, std::vector<Key> more);
  static Shape tables(std::vector<Key> keys);
  static Shape list(std::size_t least, std::size_t most, Shape item);
  static Shape either(std::vector<Shape> shapes);

 private:
  static Shape of_kind(Kind kind);
};

struct Key {
  std::string name;
  Shape shape;
  std::string meaning;       // one phrase, Markdown
  std::string unset;         // what counts where the key is left out, Markdown; empty: nothing
  std::string example = {};  // of a line; the key must stand, and this is told where it does not. Empty: it may be left out
  bool late = false;         // read when all sections are known: it names numbers of other sections
  // Of the entry into the kind's own options; tells what is wrong. Keys within a table have none: the table's reads them.
  std::function<void(const Entry&, const Reading&, Options&)> read = {};

  bool required() const { return !example.empty(); }
};

// "whole number from 1 to 10000", "list of 1 to 100 times": for people, Markdown.
std::string words_of(const Shape& shape);

}  // namespace pmreport::scenario
