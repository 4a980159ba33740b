// Every variant that a search has tried.
#pragma once

#include <core/analysis/design/problem.hpp>

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::analysis {

struct Trial {
  std::vector<double> values;  // SI
  Judged judged;
  std::string by;  // what asked for it: "scenario", "first search"
};

// What several searches share: no variant is judged twice, and no more of them than are allowed.
class Trials {
 public:
  Trials(const DesignProblem& problem, std::size_t most, const Progress& progress);

  const DesignProblem& problem() const { return problem_; }
  const std::deque<Trial>& all() const { return trials_; }  // in the order in which they were asked for
  std::size_t left() const { return most_ - trials_.size(); }

  // The trial of these values; nullptr: it would be one too many.
  const Trial* at(const std::vector<double>& values, const std::string& by);
  // Several at once, by all threads; those that would be too many are left out.
  void at_all(const std::vector<std::vector<double>>& values, const std::string& by);

  // Of variables between their ends, each from 0 to 1.
  std::vector<double> values_of(const std::vector<double>& unit) const;
  std::vector<double> unit_of(const std::vector<double>& values) const;  // clamped

  // The best feasible of those from `first` on that keep the `also`, as indices; none: there is none.
  std::optional<std::size_t> best(const DesignGoal& goal, std::size_t first = 0, const std::vector<DesignConstraint>& also = {}) const;
  // The usable one that breaks constraints least.
  std::optional<std::size_t> nearest(std::size_t first = 0, const std::vector<DesignConstraint>& also = {}) const;

 private:
  const Trial* known(const std::vector<double>& values) const;
  const Trial& add(std::vector<double> values, Judged judged, const std::string& by);
  void tell() const;

  const DesignProblem& problem_;
  std::size_t most_;
  const Progress& progress_;
  std::deque<Trial> trials_;
  std::map<std::vector<double>, std::size_t> index_;
};

}  // namespace pmreport::analysis
