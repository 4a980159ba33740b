#include <core/program/intervals/rounding.hpp>
#include <core/scenario/expression/enclosure.hpp>
#include <core/scenario/expression/sharp_series.hpp>

namespace pmreport::scenario {

Jet<program::Bounds> over(const Expression& expression, program::Bounds time) {
  return program::round_upward([&]() -> Jet<program::Bounds> {
    const Series<2> f = sharp_series(expression.terms(), Interval(time));
    // Where there is no value there is no rate, though that of a constant be zero.
    if (!f[0].bounded()) return {};
    if (!f[1].bounded() || f.smooth < 0) return {f[0].bounds(), {}, {}};
    return {f[0].bounds(), f[1].bounds(), f.smooth < 1 ? program::Bounds{} : (2.0 * f[2]).bounds()};
  });
}

}  // namespace pmreport::scenario
