#include <core/analysis/proof/extremes.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace pmreport::analysis {

namespace {

constexpr double rounding = 1e-13;      // of a quantity
constexpr double sharpened = 1e-3;      // of its usual tolerance: where a bracket has what it should tell from an extreme
constexpr double beside_others = 0.01;  // of what its like moves: what hardly moves beside it needs no brackets of its own size
constexpr double beside_itself = 0.01;  // of a rate: one that hardly changes needs none either

}  // namespace

ExtremeSearch::ExtremeSearch(const mechanics::Machine& machine, const Quantities& quantities, const ProofOptions& options)
    : quantities_(quantities), options_(options), brackets_(quantities.all.size()) {
  for (std::size_t q = 1; q < brackets_.size(); ++q) {
    brackets_[q].least = {-infinity, infinity}, brackets_[q].largest = {-infinity, infinity};
    for (const auto& [column, x] : options.decide)
      if (column == quantities.column(machine, quantities.all[q])) brackets_[q].decide.push_back(x);
  }
}

void ExtremeSearch::see(const InstantFacts& instant) {
  if (!instant.assembled) return;
  for (std::size_t q = 1; q < brackets_.size(); ++q) {
    const Bounds& x = instant.value[q];
    Bracket& b = brackets_[q];
    if (!x.bounded()) continue;
    if (x.high < b.least.high) b.least.high = x.high, b.at_least = instant.time;
    if (x.low > b.largest.low) b.largest.low = x.low, b.at_largest = instant.time;
  }
}

void ExtremeSearch::begin_bounds() {
  for (Bracket& b : brackets_) b.least.low = infinity, b.largest.high = -infinity;
}

// Where the mechanism cannot be assembled there are no values.
void ExtremeSearch::bound(const SpanFacts& span) {
  if (span.value[0].bounded() && span.value[0].high < 0) return;
  for (std::size_t q = 1; q < brackets_.size(); ++q) {
    const Bounds x = span.value[q].bounded() ? span.value[q] : Bounds{};
    brackets_[q].least.low = std::min(brackets_[q].least.low, x.low);
    brackets_[q].largest.high = std::max(brackets_[q].largest.high, x.high);
  }
}

double ExtremeSearch::share(const Quantity& q) const {
  if (q.order == OfMotion::acceleration) return options_.bracket_of_accelerations;
  return q.of == Quantity::Of::joint || q.of == Quantity::Of::derived ? options_.bracket_of_others : options_.bracket;
}

void ExtremeSearch::end_bounds() {
  std::map<std::pair<Quantity::Of, OfMotion>, double> widest;
  const auto like = [&](std::size_t q) { return std::pair(quantities_.all[q].of, quantities_.all[q].order); };
  for (std::size_t q = 1; q < brackets_.size(); ++q) widest[like(q)] = std::max(widest[like(q)], brackets_[q].range());
  for (std::size_t q = 1; q < brackets_.size(); ++q) {
    Bracket& b = brackets_[q];
    const double size = std::max(std::abs(b.largest.low), std::abs(b.least.high));
    const double largest = size < infinity ? size : 0;
    const double moves =
        std::max({b.range(), beside_others * widest[like(q)], quantities_.all[q].order == OfMotion::value ? 0 : beside_itself * largest});
    b.tolerance = std::max(share(quantities_.all[q]) * moves, rounding * largest);
    if (std::ranges::any_of(b.decide, [&](double x) { return b.least.has(x) || b.largest.has(x); })) b.tolerance *= sharpened;
  }
}

bool ExtremeSearch::wants(Stage stage, const SpanFacts& span, const Instants& instants) const {
  for (std::size_t q = 1; q < brackets_.size(); ++q) {
    if ((quantities_.all[q].order == OfMotion::acceleration) != (stage == Stage::accelerations)) continue;
    const Bounds& x = span.value[q];
    const Bracket& b = brackets_[q];
    if (!x.bounded()) return true;
    const double narrowest = std::min({instants.begin.value[q].width(), instants.middle.value[q].width(), instants.end.value[q].width()});
    const bool rounding_alone = x.width() <= 4 * narrowest;
    if (!rounding_alone && (x.low < b.least.high - b.tolerance || x.high > b.largest.low + b.tolerance)) return true;
  }
  return false;
}

std::vector<Extreme> ExtremeSearch::found(const mechanics::Machine& machine) const {
  std::vector<Extreme> out;
  for (std::size_t q = 1; q < brackets_.size(); ++q) {
    const Bracket& b = brackets_[q];
    out.push_back({quantities_.column(machine, quantities_.all[q]), b.least, b.largest, b.at_least, b.at_largest});
  }
  return out;
}

}  // namespace pmreport::analysis
