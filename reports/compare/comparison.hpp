// Reports held against each other: what agrees, what differs, and what only some of them have.
//
// Only equals are compared: values of one section, name and unit, curves of one data file and column heading, verdicts of one section and
// claim. Where a section has a name several times the first is held against the first, the second against the second. The reports are told
// as A, B, C in the order given; each is held against the first that has the value.
#pragma once

#include <reports/compare/results.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::compare {

// Two numbers a and b agree when |a - b| <= max(absolute, relative * s). Of values s = max(|a|, |b|); of curves it is the largest value of
// the two, because what passes through zero has no relative error there. Two numbers that are not there agree when their reasons do, and a
// number never agrees with one that is not there.
struct Tolerance {
  double relative = 1e-6;
  double absolute = 1e-12;  // SI: rounding about zero is no difference
};

struct ValueRow {
  std::string section, name, unit;
  std::vector<std::optional<Value>> cells;  // one a report
  bool everywhere = true;                   // every report has it
  bool differs = false;                     // of those that have it
  double difference = 0;                    // the largest in size against the first that has it, with its sign; NaN: against none there
  double relative = 0;                      // of the larger of the two; NaN likewise
};

struct JudgementRow {
  std::string section, name;
  std::vector<std::optional<std::string>> states;
  bool everywhere = true, differs = false;
};

struct CurveRow {
  struct Source {  // where the curve is, in its report
    std::size_t curves, column;
  };
  std::string section, heading;
  std::vector<std::optional<Source>> sources;
  bool everywhere = true, differs = false;
  bool other_instants = false;  // not all are sampled at the same times; B is then read between its samples
  bool gap = false;             // somewhere one has a value and the other has none
  double difference = 0;        // the largest in size over the times that both have, with its sign
  double at = 0;                // [s]
  double relative = 0;          // of the largest value
};

struct Comparison {
  std::vector<const Results*> reports;
  Tolerance tolerance;
  // Sections in the order in which they first occur, names in a section likewise.
  std::vector<ValueRow> values;
  std::vector<JudgementRow> judgements;
  std::vector<CurveRow> curves;
  bool agree = true;  // whatever the reports have, all have it, and within the tolerance
};

// `reports` must live as long as what is returned.
Comparison compare(const std::vector<Results>& reports, const Tolerance& tolerance);

// `y` at one instant, along the straight line between two samples. NaN outside of its times, and beside gaps.
double read_between(const std::vector<double>& time, const std::vector<double>& y, double at, std::size_t nth = 0);
// How many samples before sample i are of its instant: where a curve jumps there are two.
std::size_t nth_of_instant(const std::vector<double>& time, std::size_t i);

}  // namespace pmreport::compare
