// A quantity as a user writes it: "35 deg", "20 mm * sin(2*pi*t/10 s)". Parsed and dimension-checked once, evaluated many times with exact
// time derivatives.
//
//   sum      = product {("+" | "-") product}
//   product  = signed {("*" | "/") signed}
//   signed   = {"+" | "-"} power
//   power    = measured ["^" signed]                   the exponent: a constant plain number
//   measured = atom [units]                            atom: a number or something in parentheses
//   units    = unit ["^" integer] {("*" | "/") unit ["^" integer]}
//   atom     = number | "t" | "pi" | variable | unit | function "(" sum {"," sum} ")" | "(" sum ")"
//
// Units bind tighter than any operator, and all of them at once: t/10 s is t/(10 s), and 1 m / 5 mm/s is 200 s.
#pragma once

#include <core/text/units.hpp>
#include <pmreport/jet.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::scenario {

struct ExpressionError : std::runtime_error {
  ExpressionError(std::size_t offset, const std::string& message, std::string hint = {})
      : std::runtime_error(message), offset(offset), hint(std::move(hint)) {}
  std::size_t offset;  // of the offending part, in bytes
  std::string hint;
};

enum class Time { forbidden, allowed };  // where it is forbidden, t is the tonne

// A quantity that an expression may name beside the time. A name that is taken, by a unit say, is not offered: it keeps its meaning.
struct Variable {
  std::string name;
  Dimension dimension;
};

enum class Operation : unsigned char {
  constant,
  time,
  variable,
  negate,
  add,
  subtract,
  multiply,
  divide,
  power,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  atan2,
  sinh,
  cosh,
  tanh,
  sqrt,
  exp,
  log,
  abs,
  min,
  max,
  step5
};

struct Term {  // of an expression: an operation on earlier terms
  Operation operation;
  int a = -1, b = -1, c = -1;  // operands, indices of terms; a variable's index
  double constant = 0;         // of a constant its value (SI), of a power its exponent
};

class Expression {
 public:
  // Throws ExpressionError.
  static Expression parse(std::string_view text, Time time, std::span<const Variable> variables = {});

  const Dimension& dimension() const { return dimension_; }
  // SI; not finite where the expression has no value, or no derivative. `variables`: one for each that it was parsed with, SI.
  Jet<double> at(double t, std::span<const Jet<double>> variables = {}) const;

  // What it is made of, operands first; the last term is the whole. And all of them at a time.
  std::span<const Term> terms() const { return terms_; }
  void evaluate(double t, std::span<const Jet<double>> variables, std::vector<Jet<double>>& terms) const;

 private:
  friend class ExpressionParser;
  std::vector<Term> terms_;
  Dimension dimension_;
};

std::vector<std::string> expression_functions();

}  // namespace pmreport::scenario
