// The variants between two goals: those of which none is better in one without being worse in the other.
#pragma once

#include <core/analysis/design/local_search.hpp>

#include <optional>
#include <vector>

namespace pmreport::analysis {

struct FrontPoint {
  std::size_t trial = 0;
  Judged confirmed;  // once more, more finely
};

struct Front {
  std::vector<Trial> trials;  // all, in the order in which they were asked for
  Judged own;                 // the scenario's own values
  bool own_inside = true;
  std::vector<FrontPoint> points;      // from the best of the first goal to that of the second
  std::size_t dominated = 0;           // trials that keep all constraints and are worse than another in both goals, or in one
  std::size_t dropped = 0;             // points that another dominates once both are confirmed, or that break a constraint then
  std::size_t thinned = 0;             // of the front as it was found, left out for there were more than asked for
  std::optional<std::size_t> nearest;  // without points: the trial that breaks constraints least
};

// One variant is as good as another in both goals and better in one, by the values.
bool dominates(const DesignProblem& problem, const Judged& better, const Judged& worse);

// At most `points`, 3 or more, by at most `most` variants, 10 a point or more, confirmations aside. The problem has two goals.
Front front(const DesignProblem& problem, std::size_t points, std::size_t most, const Progress& progress);

}  // namespace pmreport::analysis
