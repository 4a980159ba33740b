#include <core/analysis/design/sweep.hpp>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace pmreport::analysis {

namespace {

// Few enough that a run can be stopped between them, and enough for every thread.
constexpr std::size_t at_a_time = 16;

}  // namespace

Sweep sweep(const std::vector<SweptVariable>& variables, const Judge& judge, const Progress& progress) {
  Sweep out;
  std::size_t count = 1;
  for (const SweptVariable& v : variables) count *= v.count;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> values(variables.size());
    std::size_t rest = k;
    for (std::size_t i = variables.size(); i-- > 0; rest /= variables[i].count) values[i] = variables[i].value(rest % variables[i].count);
    out.values.push_back(std::move(values));
  }
  out.judged.resize(count);
  for (std::size_t first = 0; first < count; first += at_a_time) {
    progress.stop_if_asked();
    progress.say(fmt::format("{} of {} variants", first, count));
    const std::size_t here = std::min(at_a_time, count - first);
    tbb::parallel_for(std::size_t{0}, here, [&](std::size_t k) { out.judged[first + k] = judge(out.values[first + k]); });
  }
  return out;
}

}  // namespace pmreport::analysis
