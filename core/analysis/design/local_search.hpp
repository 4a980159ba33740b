// One search that goes from a start wherever its goal gets better, without derivatives.
#pragma once

#include <core/analysis/design/trials.hpp>

#include <string>
#include <vector>

namespace pmreport::analysis {

enum class LocalMethod {
  linear_models,  // COBYLA (Powell 1994): the goal and every constraint as planes through the last trials
  simplex         // Nelder and Mead 1965, within bounds (Box 1965): asks only which of two trials is better
};
const char* name_of(LocalMethod method);  // "COBYLA"

struct LocalSearch {
  LocalMethod method = LocalMethod::linear_models;
  std::size_t most = 0;                     // new trials
  double step = 0.15;                       // the first, of the range of each variable
  double accuracy = 1e-5;                   // and that below which it ends
  std::vector<DesignConstraint> also = {};  // to be kept besides those of the problem
};

// All that it found is among the trials: what the library says of its end, of the point and of the value there, nobody asks.
// `start`: of each variable from 0 to 1.
void search_from(const std::vector<double>& start, const DesignGoal& goal, const LocalSearch& search, Trials& trials,
                 const std::string& by);

}  // namespace pmreport::analysis
