// Two other programs for intervals, asked the same questions: MPFI for the range of an operation over an interval, FLINT/Arb for its value
// at a point. Both compute with as many digits as they are told to, so that what they say is true to far beyond a double.
#pragma once

#include <core/program/intervals/bounds.hpp>

#include <arb.h>
#include <mpfi.h>

#include <optional>
#include <random>
#include <string>
#include <vector>

namespace pmreport::judges {

using program::Bounds;

// From where operands are taken. All have points, neighbours and wide intervals among them, and ends that are zero.
enum class Operands {
  any,       // of every size from below 2^-1022 to the greatest
  angle,     // to beyond the largest that is looked at; around multiples of pi/2; whole circles
  unit,      // from -1 to 1, the ends among them; a few beyond
  moderate,  // whose exponential is mostly a number; around zero
  positive,  // of every size; a few around zero
};

struct JudgedOperation {
  const char* name;
  int operands;
  Operands from;
  double ulps;  // how far our ends may be outside MPFI's best with 53 digits: units in the last place of that end, or of `least`
  void (*range)(mpfi_t r, const mpfi_t a, const mpfi_t b);
  void (*value)(arb_t r, const arb_t a, const arb_t b, slong digits);
  double least = 0x1p-960;  // our bounds of errors have something in them that is no share of the result: 2^-1022, of most
};
const std::vector<JudgedOperation>& judged_operations();
const JudgedOperation& judged_operation(const std::string& name);

Bounds operand(Operands from, std::mt19937_64& random);

class Judges {
 public:
  Judges();
  ~Judges();
  Judges(const Judges&) = delete;
  Judges& operator=(const Judges&) = delete;

  // What is wrong with our bounds on an operation over operands with finite ends; nothing: they hold the range, and points of it. Where
  // the operation has no value at a point of the operands ours must not be bounded.
  std::optional<std::string> wrong(const JudgedOperation& o, const Bounds& a, const Bounds& b, const Bounds& ours, std::mt19937_64& random);
  // How much they are wider than they need be, in units in the last place of an end; infinite: not bounded, where MPFI is.
  double excess(const JudgedOperation& o, const Bounds& a, const Bounds& b, const Bounds& ours);
  // How far a value of an operation of one operand is off, in units in the last place of the true value, or as a share of `allowed`.
  double error_of_point(const JudgedOperation& o, double at, double value, double allowed = 0);
  // What is wrong with bounds on the first or the second derivative of an operation of one operand over it, at a point of it.
  std::optional<std::string> wrong_derivative(const JudgedOperation& o, int order, double at, const Bounds& ours);

 private:
  mpfi_t a_, b_, r_, a53_, b53_, r53_;
  arb_t x_, y_, z_, u_, v_;
  arf_t end_;
};

}  // namespace pmreport::judges
