// Cuts a motion into spans until each of its claims is judged on all of them, and its extremes are known.
#pragma once

#include <core/analysis/proof/claims.hpp>
#include <core/analysis/proof/proof.hpp>
#include <core/analysis/proof/spans.hpp>

#include <deque>
#include <vector>

namespace pmreport::analysis {

// Spans are halved in generations, the coarsest first, so that a bound on their number leaves the finest open. One object, one proof.
class Prover {
 public:
  // `moving`: the program with its rates and accelerations (program::in_time). `knots`: times at which the motion may be anything but
  // smooth, rising; spans are cut there where they can be.
  Prover(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const program::Program& moving,
         const mechanics::Enclosure& motion, Bounds whole, const std::vector<double>& knots, const ProofOptions& options);

  // `out` has begin and end; gets the rest.
  void run(MotionProof& out);

 private:
  struct Leaf {  // a span, and the instants at its ends and in its middle
    Bounds time;
    const InstantFacts *begin = nullptr, *middle = nullptr, *end = nullptr;
    SpanFacts facts;
    std::vector<int> open;   // claims
    bool assembled = false;  // at every instant of it

    Instants instants() const { return {*begin, *middle, *end}; }
  };

  std::vector<Leaf> first_spans();
  double cut(Bounds time) const;
  std::pair<Leaf, Leaf> halves(Leaf&& leaf) const;
  void look(Look look, std::vector<Leaf>& leaves);
  bool divisible(const Leaf& leaf) const;
  Mark marked(const Leaf& leaf, int claim, Judgement judged) const;
  void close(const Leaf& leaf, int claim, Judgement judged);
  void close_rest(Leaf& leaf);
  void conclude_all(MotionProof& out);
  bool judge_all(Leaf& leaf);
  bool spent(std::size_t more) const;
  void settle_claims();
  std::vector<Extreme> extremes();
  void halve(const std::vector<bool>& chosen);

  const mechanics::Machine& machine_;
  Quantities quantities_;
  Spans spans_;
  Bounds whole_;
  const std::vector<double>& knots_;
  ProofOptions options_;
  double finest_;
  std::deque<InstantFacts> instants_;  // all that were looked at; their places stay
  std::vector<OpenClaim> claims_;
  std::vector<std::vector<Mark>> marks_;     // of each claim
  std::vector<std::vector<Mark>> doubtful_;  // of each: not decided where it is not either whether the mechanism can be assembled
  std::vector<Leaf> leaves_;                 // spans that are not halved any more
  bool exhausted_ = false;
};

}  // namespace pmreport::analysis
