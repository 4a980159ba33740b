#include <core/analysis/proof/sharpen.hpp>

#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>

namespace pmreport::analysis {

namespace {

using program::Bounds, program::Interval;

void sharpen_all(Bounds time, double middle, std::span<const Bounds> at_middle, std::span<const Bounds> rate, std::span<Bounds> value) {
  const Interval way = Interval(time) - Interval(middle);
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!rate[i].bounded() || !at_middle[i].bounded()) continue;
    const Bounds linear = (Interval(at_middle[i]) + Interval(rate[i]) * way).bounds();
    if (linear.bounded()) value[i] = common(value[i], linear);
  }
}

bool regular_all(std::span<const Bounds, 36> wrenches, std::span<const double, 36> inverse) {
  for (std::size_t i = 0; i < 6; ++i) {
    Interval sum(0.0);
    for (std::size_t k = 0; k < 6; ++k) {
      Interval entry(i == k ? 1.0 : 0.0);
      for (std::size_t j = 0; j < 6; ++j) entry = entry - Interval(wrenches[6 * j + k]) * inverse[6 * i + j];
      sum = sum + abs(entry);
    }
    if (!(sum.high < 1)) return false;
  }
  return true;
}

}  // namespace

void sharpen(Bounds time, double middle, std::span<const Bounds> at_middle, std::span<const Bounds> rate, std::span<Bounds> value) {
  program::round_upward([&] { sharpen_all(time, middle, at_middle, rate, value); });
}

bool regular(std::span<const Bounds, 36> wrenches, std::span<const double, 36> inverse) {
  return program::round_upward([&] { return regular_all(wrenches, inverse); });
}

}  // namespace pmreport::analysis
