#include <core/program/rounding.hpp>
#include <core/scenario/expression/range.hpp>
#include <core/scenario/expression/series.hpp>
#include <core/scenario/expression/terms.hpp>

namespace pmreport::scenario {

void ranges_of(std::span<const Term> terms, double begin, double end, std::vector<Range>& out) {
  out.resize(terms.size());
  program::round_upward([&] {
    thread_local std::vector<Series<1>> ranges;
    evaluate_terms(terms, Series<1>::time(Interval(begin, end)), {}, ranges);
    for (std::size_t i = 0; i < terms.size(); ++i) out[i] = {ranges[i][0].bounds(), ranges[i][1].bounds()};
  });
}

}  // namespace pmreport::scenario
