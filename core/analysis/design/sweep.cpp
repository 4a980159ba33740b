#include <core/analysis/design/sweep.hpp>

#include <core/analysis/design/judge_all.hpp>

namespace pmreport::analysis {

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
  chunks::Meaning meaning;
  for (const std::vector<double>& values : out.values)
    for (const double x : values) meaning << x;
  out.judged = judge_all(
      {progress.part + " variants", meaning.value()}, count, [&](std::size_t k) { return judge(out.values[k]); }, progress);
  return out;
}

}  // namespace pmreport::analysis
