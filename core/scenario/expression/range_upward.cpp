#include <core/program/intervals/rounding.hpp>
#include <core/scenario/expression/range.hpp>
#include <core/scenario/expression/series.hpp>
#include <core/scenario/expression/terms.hpp>

namespace pmreport::scenario {

namespace {

template <int K>
void evaluate(std::span<const Term> terms, double begin, double end, std::vector<Range>& out) {
  out.resize(terms.size());
  program::round_upward([&] {
    thread_local std::vector<Series<K>> ranges;
    evaluate_terms(terms, Series<K>::time(Interval(begin, end)), {}, ranges);
    for (std::size_t i = 0; i < terms.size(); ++i) {
      out[i].value = ranges[i][0].bounds();
      if constexpr (K > 0) out[i].rate = ranges[i][1].bounds();
    }
  });
}

}  // namespace

void values_of(std::span<const Term> terms, double begin, double end, std::vector<Range>& out) { evaluate<0>(terms, begin, end, out); }
void ranges_of(std::span<const Term> terms, double begin, double end, std::vector<Range>& out) { evaluate<1>(terms, begin, end, out); }

}  // namespace pmreport::scenario
