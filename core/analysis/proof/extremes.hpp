// The least and the largest value of each quantity over all instants, from both sides: no more than what is certain at some instant, and
// no less than what bounds the spans that the motion is cut into.
#pragma once

#include <core/analysis/proof/claims.hpp>
#include <core/analysis/proof/proof.hpp>
#include <core/analysis/proof/spans.hpp>

#include <limits>
#include <vector>

namespace pmreport::analysis {

class ExtremeSearch {
 public:
  ExtremeSearch(const mechanics::Machine& machine, const Quantities& quantities, const ProofOptions& options);

  // An instant of the motion, at which values are taken.
  void see(const InstantFacts& instant);
  // The spans, all of them, anew: between `begin_bounds` and `end_bounds`.
  void begin_bounds();
  void bound(const SpanFacts& span);
  void end_bounds();

  // Whether this span keeps the two sides of some bracket farther apart than they may be, and a smaller one could do better: of values and
  // rates, or of accelerations.
  enum class Stage { values_and_rates, accelerations };
  bool wants(Stage stage, const SpanFacts& span, const Instants& instants) const;

  std::vector<Extreme> found(const mechanics::Machine& machine) const;

 private:
  struct Bracket {
    Bounds least, largest;
    double at_least = 0, at_largest = 0;
    double tolerance = 0;
    std::vector<double> decide;  // values that it should not hold

    double range() const { return std::max(largest.low - least.high, 0.0); }
  };
  double share(const Quantity& q) const;

  const Quantities& quantities_;
  const ProofOptions& options_;
  std::vector<Bracket> brackets_;  // of each quantity; that of the reach is not looked at
};

}  // namespace pmreport::analysis
