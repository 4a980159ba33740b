// The statements of a proof, judged span by span, and what the spans on which one does not hold add up to.
#pragma once

#include <core/analysis/proof/proof.hpp>
#include <core/analysis/proof/spans.hpp>

#include <vector>

namespace pmreport::analysis {

// A statement while it is looked at.
struct OpenClaim {
  Claim claim;
  int quantity = 0;  // that must stay in the range; of `regular` none
};
std::vector<OpenClaim> claims_of(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const Quantities& quantities);

// On one span.
enum class Judgement {
  holds,
  broken,    // at every instant
  open,      // a smaller span may tell
  hopeless,  // it lies as near to its limit as rounding can tell: no smaller span will
  void_      // where the mechanism cannot be assembled nothing else is judged
};
Judgement judge(const OpenClaim& claim, const SpanFacts& span, const InstantFacts& middle);

// What a claim came to on a span that is not halved any more.
struct Mark {
  Bounds time;
  enum class What { broken, undecided, unbounded } what = What::undecided;  // unbounded: of `regular`, G may have no bound
  bool above = false;                                                       // the upper end is left, or would be
  bool broken_within = false;                                               // for certain at `at`, an instant in it
  Bounds value;                                                             // of its quantity in it
  double at = 0;
  Bounds value_at;
  int side_before = 0, side_after = 0;  // of det G, at its ends; 0: not certain
};
Mark mark(const OpenClaim& claim, Judgement judged, const SpanFacts& span, const InstantFacts& middle);

// Sums the marks up, in any order: state, broken and undecided stretches. A run of marks that touch has stretches of those that are broken,
// each of which begins and ends within the undecided ones beside it; a run without any is undecided as a whole.
void conclude(Claim& claim, std::vector<Mark> marks);
// Of `regular`, the meetings besides.
std::vector<Meeting> meetings_of(std::vector<Mark> marks);

}  // namespace pmreport::analysis
