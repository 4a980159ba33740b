// The series of an expression of t over a span of time, as sharp as a second evaluation, in the middle of the span, makes it.
// To be included where rounding goes upward alone (program/interval.hpp).
#pragma once

#include <core/scenario/expression/series.hpp>
#include <core/scenario/expression/terms.hpp>

namespace pmreport::scenario {

// About the middle m of the span T, f(t) lies in f(m) + f'(T) (t - m) where f has no jump (Moore 1966): what an operation makes of two
// operands that move together is then wrong by the second order alone. f' likewise, where it has none.
inline void sharpen(Series<2>& x, const Series<2>& middle, const Interval& away) {
  if (x.smooth >= 1 && x[1].bounded()) x[1] = common(x[1], middle[1] + 2.0 * x[2] * away);
  if (x.smooth >= 0 && x[0].bounded()) x[0] = common(x[0], middle[0] + x[1] * away);
}

inline Series<2> sharp_series(std::span<const Term> terms, const Interval& span) {
  thread_local std::vector<Series<2>> middle, out;
  const Interval point(span.middle()), away = span - point;
  const bool wide = span.width() > 0;
  if (wide) evaluate_terms(terms, Series<2>::time(point), {}, middle);
  evaluate_terms(terms, Series<2>::time(span), {}, out, [&](std::size_t i, Series<2>& x) {
    if (wide) sharpen(x, middle[i], away);
  });
  return out.back();
}

}  // namespace pmreport::scenario
