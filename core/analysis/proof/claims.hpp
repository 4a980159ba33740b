// The statements of a proof, judged span by span, and what the spans on which one does not hold add up to.
#pragma once

#include <core/analysis/proof/proof.hpp>
#include <core/analysis/proof/spans.hpp>

#include <vector>

namespace pmreport::analysis {

// A statement while it is looked at.
struct OpenClaim {
  Claim claim;
  int quantity = 0;  // that must stay in the range; -1: none, of `regular` and of what is not examined
};
std::vector<OpenClaim> claims_of(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const Quantities& quantities);

// On one span.
enum class Judgement {
  holds,
  broken,   // at every instant
  open,     // a smaller span may tell
  hopeless  // it lies as near to its limit as rounding can tell: no smaller span will
};
struct Instants {  // of a span
  const InstantFacts &begin, &middle, &end;
};
Judgement judge(const OpenClaim& claim, const SpanFacts& span, const Instants& instants);

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
Mark mark(const OpenClaim& claim, Judgement judged, const SpanFacts& span, const Instants& instants);

// Sums the marks up, in any order: state, broken and undecided stretches. A run of marks that touch has a stretch of each row of marks that
// are broken at every instant, which begins and ends within the undecided ones beside it, and is told the worst that is certain in these;
// of undecided ones beside none, that are broken for certain at an instant, a stretch about the worst of them. A run without any is
// undecided as a whole.
void conclude(Claim& claim, std::vector<Mark> marks);
// Of `regular`, the meetings besides.
std::vector<Meeting> meetings_of(std::vector<Mark> marks);

}  // namespace pmreport::analysis
