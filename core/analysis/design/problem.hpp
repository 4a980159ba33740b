// What a study varies, what it wants, and how one variant is judged.
#pragma once

#include <core/analysis/bracketed.hpp>
#include <core/analysis/progress.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pmreport::analysis {

// The numbers of one variant. One that could not be made, or judged, has none, and the sentence that says why.
struct Judged {
  std::vector<Bracketed> numbers = {};  // one a measure; NaN: it has no value there
  std::string why = {};                 // a sentence without its full stop; empty: the variant was made and judged
  std::vector<std::string> notes = {};  // what a reader must know of the numbers
  bool cut_off = false;                 // a set was looked at only up to the end of a range, and may go on

  bool made() const { return why.empty(); }
};
// Of values, one a variable, SI. Called by several threads at once; the same values give the same numbers.
using Judge = std::function<Judged(const std::vector<double>& values)>;

struct DesignVariable {
  std::string name;
  double from = 0, to = 0;  // SI; from < to
  double own = 0;           // of the scenario as it stands; may lie outside
};

struct DesignGoal {
  std::size_t measure = 0;
  bool maximise = true;
};

// A number that must not exceed its bound, or not fall below it: with all of its bracket.
struct DesignConstraint {
  std::size_t measure = 0;
  bool below = true;
  double bound = 0;  // SI

  double slack(const Judged& j) const {  // negative: broken; NaN: there is no number
    const Bracketed& x = j.numbers[measure];
    return below ? bound - x.high : x.low - bound;
  }
  double scale() const { return bound != 0 ? std::abs(bound) : 1.0; }  // that slacks are told against
};

// Sum of the broken ones, each over its scale; 0: all are kept.
double violation(const std::vector<DesignConstraint>& constraints, const Judged& j);

struct DesignProblem {
  std::vector<DesignVariable> variables;
  std::vector<DesignGoal> goals;  // one to search for, two for a front
  std::vector<DesignConstraint> constraints;
  Judge judge;
  Judge confirm;  // the same numbers, more finely, for what a search found

  // Made, with all numbers that goals and constraints need.
  bool usable(const Judged& j) const;
  // And every constraint is kept.
  bool feasible(const Judged& j) const;
  // The number of a goal, turned so that less is better. Of a usable one.
  double cost(const DesignGoal& goal, const Judged& j) const;
  std::vector<double> own() const;
  bool inside(const std::vector<double>& values) const;  // every range, ends included
};

}  // namespace pmreport::analysis
