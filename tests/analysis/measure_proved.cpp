// Brackets of columns reduced as checks ask: against the least and largest of numbers drawn from them.
#include <catch2/catch.hpp>

#include <core/analysis/study/reduce.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace pmreport;
using analysis::MotionProof;
using program::Bounds;

namespace {

MotionProof proof(const std::vector<std::pair<Bounds, Bounds>>& columns) {
  MotionProof p;
  p.end = 1;
  for (std::size_t i = 0; i < columns.size(); ++i)
    p.extremes.push_back({analysis::ColumnId::named("q" + std::to_string(i + 1)), columns[i].first, columns[i].second});
  return p;
}

scenario::Measured measured(const std::string& reduction, bool absolute, std::vector<std::string> columns) {
  scenario::Measured m;
  m.reduction = reduction, m.absolute = absolute, m.columns = std::move(columns);
  return m;
}

}  // namespace

TEST_CASE("the bracket of a column's largest and least value is its own") {
  const MotionProof p = proof({{{-3, -2}, {4, 5}}});
  CHECK(*measure_proved(p, measured("max", false, {"q1"})) == Bounds{4, 5});
  CHECK(*measure_proved(p, measured("min", false, {"q1"})) == Bounds{-3, -2});
}

TEST_CASE("of a group the bracket is that of the column that counts") {
  const MotionProof p = proof({{{0, 1}, {4, 5}}, {{2, 3}, {4.5, 4.6}}});
  const auto both = measured("max", false, {"q1", "q2"});
  CHECK(*measure_proved(p, both, true) == Bounds{4.5, 5});
  CHECK(*measure_proved(p, both, false) == Bounds{4, 4.6});
  CHECK(*measure_proved(p, measured("min", false, {"q1", "q2"}), false) == Bounds{0, 1});
}

TEST_CASE("where one column has no bracket, or the number is no least or largest, there is none") {
  const MotionProof p = proof({{{0, 1}, {4, 5}}, {{}, {4, 5}}});
  CHECK_FALSE(measure_proved(p, measured("max", false, {"q1", "q3"})));
  CHECK_FALSE(measure_proved(p, measured("max", false, {"q1", "q2"})));
  CHECK_FALSE(measure_proved(p, measured("rms", false, {"q1"})));
  CHECK_FALSE(measure_proved(p, measured("at", false, {"q1"})));
  MotionProof none = p;
  none.unexamined = "no program";
  CHECK_FALSE(measure_proved(none, measured("max", false, {"q1"})));
}

TEST_CASE("the bracket of a magnitude holds that of every column between its extremes") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(-3, 3), share(0, 1);
  for (int i = 0; i < 20000; ++i) {
    // A column that runs from m to M, both known within a little; it is continuous, so it passes zero where they have opposite signs.
    const double a = place(random), b = place(random), m = std::min(a, b), M = std::max(a, b);
    const double w = 0.5 * (M - m) * share(random);
    const Bounds least{m - w * share(random), m + w * share(random)}, largest{M - w * share(random), M + w * share(random)};
    CAPTURE(m, M, least.low, least.high, largest.low, largest.high);
    const MotionProof p = proof({{least, largest}});
    const double most = std::max(std::abs(m), std::abs(M)), fewest = m <= 0 && M >= 0 ? 0 : std::min(std::abs(m), std::abs(M));
    CHECK(measure_proved(p, measured("max", true, {"q1"}))->has(most));
    CHECK(measure_proved(p, measured("min", true, {"q1"}))->has(fewest));
  }
}
