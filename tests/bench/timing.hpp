// How long a call takes on a machine that also does other things.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace pmreport::bench {

inline volatile double sink;  // results go here, so that no work can be left out

struct Timing {
  double fastest, median;  // [s] a call
};

// `repetitions` batches of `calls` calls of f(k), k = 0 ... calls - 1; f returns a number that depends on its work. One batch more, the
// first, only warms up. The median over batches is the figure; the fastest batch tells how far the neighbours disturbed it.
template <class F>
Timing time_calls(int repetitions, int calls, F&& f) {
  std::vector<double> seconds;
  for (int batch = 0; batch <= repetitions; ++batch) {
    const auto start = std::chrono::steady_clock::now();
    double sum = 0;
    for (int k = 0; k < calls; ++k) sum += f(k);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    sink = sum;
    if (batch > 0) seconds.push_back(taken.count() / calls);
  }
  std::sort(seconds.begin(), seconds.end());
  return {seconds.front(), seconds[seconds.size() / 2]};
}

}  // namespace pmreport::bench
