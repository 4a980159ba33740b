// What was proved of a motion for every instant, in words. Pieces of a sentence begin with a small letter and have no stop.
#pragma once

#include <core/analysis/proof/proof.hpp>
#include <reports/section/common/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

using ProvedClaim = analysis::Claim;
using analysis::Meeting;
using analysis::MotionProof;
using program::Bounds;

// A proof, and what its words need beside it.
struct Proved {
  const MotionProof& proof;
  const Topology& topology;
  bool singular_everywhere = false;  // then regularity is nothing to speak of

  std::vector<const ProvedClaim*> of(ProvedClaim::About about) const;
  bool holds(ProvedClaim::About about) const;  // all of a kind, of which there is one at least
  bool any(ProvedClaim::About about, ProvedClaim::State state) const;
};
Proved proved(const Analysis& a);

// "l3", "A1": what a claim is of; empty: the whole mechanism. Of a joint with two limits "U1, axis 2".
std::string subject_of(const Proved& p, const ProvedClaim& c);
std::string unit_of(const Proved& p, const ProvedClaim& c);  // of a stroke or the limit of a joint, SI

// "strokes, joint limits and regularity hold at every instant from 0 s to 10 s (proved, 323 intervals)": those kinds of which all claims
// hold; empty: none.
std::string holding_words(const Proved& p);
// "l3 leaves its stroke from t = 1.2031 s to 1.8420 s, at most by 2.3 mm (802.3 mm at t = 1.64 s, its stroke ends at 800 mm)"; alike ones
// share a piece. Of regularity what is certain: "det G changes its sign at t = 3.314159 s".
std::vector<std::string> broken_words(const Proved& p, ProvedClaim::About about);
// Of strokes and joint limits together, the worst first.
std::vector<std::string> broken_limits(const Proved& p);
// "whether l3 keeps its stroke is not decided from t = 3.12 s to 3.14 s".
std::vector<std::string> undecided_words(const Proved& p, ProvedClaim::About about);
// "joint limits were not examined: the program has no arc tangent".
std::vector<std::string> unexamined_words(const Proved& p, ProvedClaim::About about);

// All of it as one sentence: what holds, what is broken, what is not decided and what was not examined.
std::string motion_sentence(const Proved& p);
// The same without what is broken, which sentences of their own tell; empty: nothing else is to be told.
std::string remaining_sentence(const Proved& p);

// What the samples and the proof say of reach, told once. The samples know why a pose cannot be assembled; what they do not show the proof
// tells.
std::vector<std::string> assembly_sentences(const Analysis& a, const Proved& p);
// Of strokes and joint limits: by the proof where it knows of all that the samples show, else by the samples.
std::vector<std::string> range_sentences(const Analysis& a, const Proved& p);

// A piece as a sentence.
std::string as_sentence(std::string piece);

}  // namespace pmreport::section
