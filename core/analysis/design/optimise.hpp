// The best variant within bounds and constraints.
#pragma once

#include <core/analysis/design/local_search.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::analysis {

// What one of the searches came to.
struct SearchEnd {
  std::string how;                   // "COBYLA from the scenario's own values"
  std::size_t first = 0, count = 0;  // its trials
  std::optional<std::size_t> best;   // of them; none: no trial of it is feasible
};

// How the two searches compare, which start elsewhere.
enum class Agreement {
  agree,      // value and variables
  flat,       // the value, at other variables: the goal is flat, or has two optima that are equally good
  different,  // two optima that differ
  one_alone,  // one of the two found nothing that keeps the constraints
  neither
};

struct Optimum {
  std::vector<Trial> trials;        // all, in the order in which they were asked for
  Judged own;                       // the scenario's own values, which may lie outside the bounds
  bool own_inside = true;           // they do not
  SearchEnd first, second, polish;  // polish: from the better of the two, by the other's method
  Agreement agreement = Agreement::neither;
  double apart = 0;                    // values of the two, relative
  double away = 0;                     // variables: largest difference, of its range
  std::optional<std::size_t> best;     // of all trials; none: none is feasible
  std::optional<std::size_t> nearest;  // then: the one that breaks constraints least; none: none could be judged
  Judged confirmed;                    // the best one once more, more finely
};

// Two numbers nearer than this are told to agree, relative; variables, of their ranges.
inline constexpr double same_value = 0.01, same_place = 0.05;

// `most`: variants to judge, confirmations aside; 10 or more. The problem has one goal.
Optimum optimise(const DesignProblem& problem, std::size_t most, const Progress& progress);

// Which variables of a point lie at an end of their range, to a thousandth of it: -1 the lower, 1 the upper, 0 none.
std::vector<int> at_bounds(const DesignProblem& problem, const std::vector<double>& values);
// A constraint that holds and would not by a thousandth of its bound.
bool active(const DesignConstraint& c, const Judged& j);

}  // namespace pmreport::analysis
