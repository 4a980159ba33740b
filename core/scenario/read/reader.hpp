// Typed access to the values of a scenario. What is not as expected becomes a diagnostic and reads as nothing.
#pragma once

#include <Eigen/Core>
#include <core/scenario/expression/expression.hpp>
#include <core/scenario/read/asked.hpp>
#include <core/scenario/read/diagnostics.hpp>
#include <core/scenario/read/document.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::scenario {

// A text as written, for the report, beside what it says.
struct Written {
  std::string text;
  Place place;
  Expression expression;
};

// Reads values without regard to where they stand.
class Reader {
 public:
  // `asked`: where all that is asked for is noted; nullptr: nowhere.
  explicit Reader(Diagnostics& diagnostics, Asked* asked = nullptr) : diagnostics_(diagnostics), asked_(asked) {}

  std::optional<std::string> text(const Value& v) const;
  std::optional<bool> boolean(const Value& v) const;
  std::optional<double> integer(const Value& v, double least, double most) const;
  // One of `words`; `what` names them in the plural: "the kinds of section".
  std::optional<std::size_t> word(const Value& v, const std::vector<std::string>& words, std::string_view what) const;
  // A constant, SI. Plain numbers may stand without quotes.
  std::optional<double> quantity(const Value& v, const Dimension& expected) const;
  std::optional<Written> expression(const Value& v, const Dimension& expected, Time time, std::span<const Variable> variables = {}) const;
  // A list of exactly `count` items; nullptr when it is not.
  const std::vector<Value>* list(const Value& v, std::size_t count, std::string_view what) const;

  Diagnostics& diagnostics() const { return diagnostics_; }
  // Reports what a parser found in the text of `v`.
  void refuse(const Value& v, const ExpressionError& e) const;
  // For code that looks at a value by itself: what it takes it for, and which keys it looks for.
  void takes(const Value& v, const Shape& as) const;
  void looks_for(const Value& table, std::string_view key, bool needed = false) const;

 private:
  Diagnostics& diagnostics_;
  Asked* asked_;
};

// The tables of an array of tables, [[name]], up to a thousand; more, a single table or anything else is reported.
std::vector<const Value*> tables_of(const Entry* entry, const std::string& name, const Reader& reader);

// The value of `entry` when it is a table, else reported and nullptr.
const Value* table_of(const Entry* entry, const std::string& name, const Reader& reader);

// Reports the first time at which something has no finite value, rate or acceleration. True when it is finite.
bool finite(const Jet<double>& x, double t, Place place, const std::string& what, Diagnostics& diagnostics);

// One table. Every key that the reading code asks for is known; `finish` reports the others.
class TableReader {
 public:
  // `name` as the user writes it: "[motion]". `place`: where a missing key is told.
  TableReader(const Value& table, std::string name, Place place, const Reader& reader)
      : table_(table), name_(std::move(name)), place_(place), reader_(reader) {}

  const Entry* find(std::string_view key);
  // Reports a key that is not there, with an example of what to write.
  const Entry* need(std::string_view key, std::string_view example);
  void allow(std::string_view key) { known_.emplace_back(key); }
  // `where`: a better name of the table, when reading has told more about it.
  void finish(const std::string& where = {}) const;

  Place place() const { return place_; }
  const Reader& read() const { return reader_; }

 private:
  const Value& table_;
  std::string name_;
  Place place_;
  const Reader& reader_;
  std::vector<std::string> known_;
};

}  // namespace pmreport::scenario
