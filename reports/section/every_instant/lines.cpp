// The evidence of the section "At every instant".
#include <core/analysis/proof/recording_check.hpp>
#include <reports/section/common/words/demands.hpp>
#include <reports/section/common/words/motion_words.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/every_instant/every_instant.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Evidence;
using document::Verdict;
using About = ProvedClaim::About;
using State = ProvedClaim::State;

namespace {

struct Kind {
  About about;
  const char *whole, *one, *many;  // "Strokes are kept"; "The stroke of l3 is kept", "The strokes of l3 and l4 are kept"
  const char* how;
  const char* none;  // why there may be no claim of the kind
  const char* demanded_by;
};

constexpr Kind kinds[] = {
    {About::assembled, "The mechanism can be assembled", "", "",
     "the recorded geometry of the plugin on spans of time: within each every reach is not negative and every number finite", "",
     demands::assembly},
    {About::stroke, "Strokes are kept", "The stroke of {} is kept", "The strokes of {} are kept",
     "actuator values on spans of time against their strokes; counted are the times that one is left", "no actuator has a stroke that ends",
     demands::limits},
    {About::joint_limit, "Joint limits are kept", "The limit of {} is kept", "The limits of {} are kept",
     "joint angles on spans of time against their limits; counted are the times that one is left",
     "no joint has a range that bounds its motion", demands::limits},
    {About::regular, "det G keeps its sign, and G is finite", "", "",
     "G on spans of time, times its inverse in the middle: no row is as far as 1 from that of the identity; counted are the times that "
     "det G changes its sign",
     "the architecture is singular at every pose", demands::regularity},
};

Verdict verdict_of(State s) {
  switch (s) {
    case State::holds:
      return Verdict::passed;
    case State::broken:
      return Verdict::failed;
    case State::undecided:
      return Verdict::not_decided;
    case State::unexamined:
      break;
  }
  return Verdict::not_examined;
}

std::string joined(const std::vector<std::string>& pieces) { return fmt::format("{}", fmt::join(pieces, "; ")); }

// Of a part of the proof, the claims of one kind in one state.
Evidence line_of(const Proved& all, const Kind& kind, State state) {
  const std::vector<const ProvedClaim*> of_kind = all.of(kind.about);
  MotionProof part = all.proof;
  part.claims.clear();
  std::vector<std::string> names;
  int stretches = 0;
  for (const ProvedClaim* c : of_kind) {
    if (c->state != state) continue;
    part.claims.push_back(*c);
    stretches += std::max(static_cast<int>(c->broken.size()), 1);
    if (std::string name = subject_of(all, *c); std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  const Proved p{part, all.topology, all.singular_everywhere};
  const bool whole = part.claims.size() == of_kind.size();
  const std::string claim = whole ? kind.whole : fmt::format(fmt::runtime(names.size() == 1 ? kind.one : kind.many), names_of(names));
  std::vector<std::string> pieces = broken_words(p, kind.about);
  for (std::string& piece : undecided_words(p, kind.about)) pieces.push_back(std::move(piece));
  switch (state) {
    case State::holds:
      return {claim, kind.how, 0, 0, "", "", {}, kind.demanded_by};
    case State::broken: {
      if (kind.about == About::regular)
        stretches = std::max(1, static_cast<int>(std::ranges::count(part.meetings, Meeting::What::crossing, &Meeting::what)));
      return {claim, kind.how, double(stretches), 0, "", joined(pieces), {}, kind.demanded_by};
    }
    case State::undecided:
      return Evidence::without_value(verdict_of(state), claim, kind.how, joined(pieces));
    case State::unexamined:
      break;
  }
  std::vector<std::string> reasons;
  for (const ProvedClaim& c : part.claims)
    if (std::ranges::find(reasons, c.reason) == reasons.end()) reasons.push_back(c.reason);
  return Evidence::without_value(verdict_of(state), claim, kind.how, joined(reasons));
}

void add_lines(document::Proof& to, const Proved& p, const Kind& kind) {
  if (kind.about == About::regular && p.singular_everywhere) {
    to.lines.push_back(Evidence::without_value(Verdict::not_applicable, kind.whole, kind.how, kind.none));
  } else if (!p.proof.unexamined.empty()) {
    to.lines.push_back(Evidence::not_examined(kind.whole, kind.how, p.proof.unexamined));
  } else if (p.of(kind.about).empty()) {
    to.lines.push_back(Evidence::without_value(Verdict::not_applicable, kind.whole, kind.how, kind.none));
  } else {
    for (const State state : {State::holds, State::broken, State::undecided, State::unexamined})
      if (p.any(kind.about, state)) to.lines.push_back(line_of(p, kind, state));
  }
}

Evidence smoothness(const Analysis& a) {
  const char *claim = "Values and rates of the prescribed motion do not jump",
             *how =
                 "the values, rates and accelerations on both sides of every switch of an expression and every knot of a path; counted are "
                 "the jumps of values and rates";
  if (a.scenario().motion->by_forces())
    return Evidence::without_value(Verdict::not_applicable, claim, how, "the motion is not prescribed, it follows from forces");
  const int jumps = count_jumps(a);
  const auto sentences = [](std::vector<std::string> all) {
    for (std::string& s : all)
      if (s.ends_with('.')) s.pop_back();
    return joined(all);
  };
  if (jumps > 0 && !must_be_smooth(a))
    return Evidence::without_value(Verdict::not_applicable, claim, how,
                                   "the report shows nothing that follows from rates; " + sentences(jump_sentences(a)));
  return {claim, how, double(jumps), 0, "", sentences(jumps > 0 ? jump_sentences(a) : acceleration_sentences(a)), {}, demands::smoothness};
}

Evidence visibility(const std::vector<analysis::Unseen>& unseen, const Analysis& a) {
  std::vector<std::string> sentences = unseen_sentences(a, unseen);
  for (std::string& s : sentences)
    if (s.ends_with('.')) s.pop_back();
  return {
      "The samples show the motion",
      "how far everything goes between two samples beyond both, of all that it moves: a twentieth of a value, a quarter of a rate or an "
      "acceleration that the report shows; counted is what goes farther",
      double(unseen.size()),
      0,
      "",
      joined(sentences),
      {},
      demands::visibility};
}

// All of the proof stands on it.
Evidence recording(const Proved& p) {
  const char *claim = "What was recorded is what the plugin computes",
             *how = "the recorded operations against placements and G of the plugin, at samples of the motion";
  if (std::isnan(p.proof.recording))
    return Evidence::not_examined(claim, how, p.proof.unexamined.empty() ? "no sample has a pose to compare" : p.proof.unexamined);
  return {claim, how, p.proof.recording, analysis::recording_rounding, ""};
}

}  // namespace

document::Proof proof_of_motion(const Analysis& a, const Proved& p, const std::vector<analysis::Unseen>& unseen) {
  document::Proof out;
  out.lines.push_back(recording(p));
  for (const Kind& kind : kinds) add_lines(out, p, kind);
  out.lines.push_back(smoothness(a));
  out.lines.push_back(visibility(unseen, a));
  return out;
}

}  // namespace pmreport::section
