#include <core/analysis/proof/prover.hpp>

#include <core/analysis/proof/extremes.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pmreport::analysis {

namespace {

constexpr std::size_t at_first = 32;     // equal spans, to begin with
constexpr std::size_t most_knots = 512;  // of which each is an end of a span from the beginning
constexpr double least_share = 1e-8;     // of the motion: no span is halved that is shorter
constexpr int assembly = 0;              // the first claim

}  // namespace

Prover::Prover(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const program::Program& moving,
               const mechanics::Enclosure& motion, Bounds whole, const std::vector<double>& knots, const ProofOptions& options)
    : machine_(machine),
      quantities_(machine, program),
      spans_(machine, program, moving, quantities_, motion),
      whole_(whole),
      knots_(knots),
      options_(options),
      finest_(std::min(options.finest, std::max(least_share * whole.width(), 4 * std::nextafter(whole.high, infinity) - 4 * whole.high))),
      claims_(claims_of(machine, program, quantities_)),
      marks_(claims_.size()),
      doubtful_(claims_.size()) {}

// Where a span is cut: at the knot next to its middle, when there is one in its middle half; else in the middle.
double Prover::cut(Bounds time) const {
  const double middle = time.middle(), quarter = 0.25 * time.width();
  const auto after = std::lower_bound(knots_.begin(), knots_.end(), middle);
  double best = middle, distance = quarter;
  for (const auto knot : {after, after == knots_.begin() ? knots_.end() : after - 1})
    if (knot != knots_.end() && std::abs(*knot - middle) < distance) best = *knot, distance = std::abs(*knot - middle);
  return best;
}

std::vector<Prover::Leaf> Prover::first_spans() {
  std::vector<double> times;
  for (std::size_t k = 0; k <= at_first; ++k)
    times.push_back(k == at_first ? whole_.high : whole_.low + whole_.width() * static_cast<double>(k) / static_cast<double>(at_first));
  if (knots_.size() <= most_knots)
    for (const double t : knots_)
      if (whole_.low < t && t < whole_.high) times.push_back(t);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<InstantFacts> ends(times.size());
  spans_.at(Look::whole, times, ends);
  const std::size_t first = instants_.size();
  for (InstantFacts& f : ends) instants_.push_back(std::move(f));
  std::vector<int> all;
  for (std::size_t c = 0; c < claims_.size(); ++c)
    if (claims_[c].claim.reason.empty()) all.push_back(static_cast<int>(c));
  std::vector<Leaf> out;
  for (std::size_t k = 0; k + 1 < times.size(); ++k)
    out.push_back({{times[k], times[k + 1]}, &instants_[first + k], nullptr, &instants_[first + k + 1], {}, all, false});
  return out;
}

std::pair<Prover::Leaf, Prover::Leaf> Prover::halves(Leaf&& leaf) const {
  const double at = leaf.middle->time;
  Leaf before{{leaf.time.low, at}, leaf.begin, nullptr, leaf.middle, {}, leaf.open, leaf.assembled},
      after{{at, leaf.time.high}, leaf.middle, nullptr, leaf.end, {}, std::move(leaf.open), leaf.assembled};
  return {std::move(before), std::move(after)};
}

// The facts of new spans, and of their middles.
void Prover::look(Look look, std::vector<Leaf>& leaves) {
  const std::size_t n = leaves.size();
  std::vector<double> times(n);
  std::vector<Bounds> spans(n);
  for (std::size_t k = 0; k < n; ++k) spans[k] = leaves[k].time, times[k] = cut(leaves[k].time);
  std::vector<InstantFacts> middles(n);
  spans_.at(look, times, middles);
  std::vector<const InstantFacts*> places(n);
  for (std::size_t k = 0; k < n; ++k) {
    instants_.push_back(std::move(middles[k]));
    leaves[k].middle = places[k] = &instants_.back();
  }
  std::vector<SpanFacts> facts(n);
  spans_.over(look, spans, places, facts);
  for (std::size_t k = 0; k < n; ++k) {
    leaves[k].facts = std::move(facts[k]);
    // A quantity whose rate has one sign is at its ends no less than anywhere: between its values there.
    for (std::size_t q = 0; q < quantities_.all.size(); ++q) {
      const Bounds &rate = leaves[k].facts.rate[q], &begin = leaves[k].begin->value[q], &end = leaves[k].end->value[q];
      if (rate.bounded() && (rate.low >= 0 || rate.high <= 0) && begin.bounded() && end.bounded())
        leaves[k].facts.value[q] = common(leaves[k].facts.value[q], hull(begin, end));
    }
  }
}

bool Prover::divisible(const Leaf& leaf) const {
  return leaf.time.width() > finest_ && leaf.time.low < leaf.middle->time && leaf.middle->time < leaf.time.high;
}

bool Prover::spent(std::size_t more) const {
  return spans_.evaluations() + 2 * static_cast<long>(more) > 2 * static_cast<long>(options_.most_intervals);
}

Mark Prover::marked(const Leaf& leaf, int claim, Judgement judged) const {
  Mark m = mark(claims_[static_cast<std::size_t>(claim)], judged, leaf.facts, leaf.instants());
  m.side_before = leaf.begin->side, m.side_after = leaf.end->side;
  return m;
}

// Notes that a claim does not hold on a leaf, or may not.
void Prover::close(const Leaf& leaf, int claim, Judgement judged) {
  marks_[static_cast<std::size_t>(claim)].push_back(marked(leaf, claim, judged));
}

// All that is still open on a leaf is not decided.
void Prover::close_rest(Leaf& leaf) {
  for (const int c : leaf.open) {
    if (leaf.assembled || c == assembly)
      close(leaf, c, Judgement::open);
    else
      doubtful_[static_cast<std::size_t>(c)].push_back(marked(leaf, c, Judgement::open));
  }
  leaf.open.clear();
}

// Judges what is open on a leaf. What holds is closed; what cannot be known better is closed with a mark. Whether the rest asks for halves.
bool Prover::judge_all(Leaf& leaf) {
  std::vector<int> still;
  const bool brief = leaf.time.width() < 1e-3 * whole_.width();
  const auto at_all_instants = [&](auto&& what) { return what(*leaf.begin) && what(*leaf.middle) && what(*leaf.end); };
  for (const int c : leaf.open) {
    const OpenClaim& claim = claims_[static_cast<std::size_t>(c)];
    Judgement judged = judge(claim, leaf.facts, leaf.instants());
    if (c == assembly) {
      if (judged == Judgement::broken) {
        close(leaf, c, judged);
        return false;  // nothing else has a meaning there
      }
      leaf.assembled = judged == Judgement::holds;
      const auto open = [](const InstantFacts& f) { return !f.assembled && !(f.value[0].bounded() && f.value[0].high < 0); };
      if (!leaf.assembled && brief && at_all_instants(open)) judged = Judgement::hopeless;
    } else if (judged == Judgement::open && brief && leaf.assembled) {
      // What no instant of three tells is so for a while: G that is singular as far as rounding tells, a number without bounds.
      const auto q = static_cast<std::size_t>(claim.quantity);
      const bool about_regularity = claim.claim.about == Claim::About::regular;
      const auto untold = [&](const InstantFacts& f) { return about_regularity ? f.side == 0 : !f.value[q].bounded(); };
      if (at_all_instants(untold)) judged = Judgement::hopeless;
    }
    const bool settled = c == assembly || leaf.assembled;  // where there may be no pose nothing else is broken
    if (judged == Judgement::open || (judged != Judgement::holds && !settled))
      still.push_back(c);
    else if (judged != Judgement::holds)
      close(leaf, c, judged);
    if (c == assembly && judged == Judgement::hopeless) {  // nor will anything else be told
      leaf.open.erase(leaf.open.begin());
      close_rest(leaf);
      return false;
    }
  }
  leaf.open = std::move(still);
  if (leaf.open.empty()) return false;
  if (divisible(leaf)) return true;
  close_rest(leaf);
  return false;
}

void Prover::settle_claims() {
  std::vector<Leaf> open = first_spans();
  while (!open.empty()) {
    look(Look::whole, open);
    std::vector<Leaf> next;
    const bool last = spent(2 * open.size());
    for (Leaf& leaf : open) {
      const bool halve = judge_all(leaf);
      if (halve && !last) {
        auto [before, after] = halves(std::move(leaf));
        next.push_back(std::move(before));
        next.push_back(std::move(after));
        continue;
      }
      if (halve) {
        exhausted_ = true;
        close_rest(leaf);
      }
      leaves_.push_back(std::move(leaf));
    }
    open = std::move(next);
  }
}

// Spans that keep a bracket wide are halved until none does: of values and rates first, then of accelerations, as far as the evaluations
// for these go.
std::vector<Extreme> Prover::extremes() {
  ExtremeSearch search(machine_, quantities_, options_);
  std::size_t seen = 0;
  for (const auto stage : {ExtremeSearch::Stage::values_and_rates, ExtremeSearch::Stage::accelerations}) {
    const long begun = spans_.evaluations();
    while (true) {
      for (; seen < instants_.size(); ++seen) search.see(instants_[seen]);
      search.begin_bounds();
      for (const Leaf& leaf : leaves_) search.bound(leaf.facts);
      search.end_bounds();
      std::vector<bool> chosen(leaves_.size());
      std::size_t many = 0;
      for (std::size_t k = 0; k < leaves_.size(); ++k) {
        const Leaf& leaf = leaves_[k];
        chosen[k] = leaf.assembled && divisible(leaf) && search.wants(stage, leaf.facts, leaf.instants());
        many += chosen[k];
      }
      if (many == 0) break;
      if (spent(2 * many)) break;
      const long after = spans_.evaluations() - begun + 4 * static_cast<long>(many);  // two halves each, and their middles
      if (after > (stage == ExtremeSearch::Stage::accelerations ? options_.most_for_accelerations : options_.most_for_brackets)) break;
      halve(chosen);
    }
  }
  return search.found(machine_);
}

// Halves those that are chosen.
void Prover::halve(const std::vector<bool>& chosen) {
  std::vector<Leaf> kept, made;
  for (std::size_t k = 0; k < leaves_.size(); ++k) {
    if (!chosen[k]) {
      kept.push_back(std::move(leaves_[k]));
      continue;
    }
    auto [before, after] = halves(std::move(leaves_[k]));
    made.push_back(std::move(before));
    made.push_back(std::move(after));
  }
  look(Look::quantities, made);
  std::ranges::move(made, std::back_inserter(kept));
  leaves_ = std::move(kept);
}

namespace {

// A stretch in which a quantity has its extreme is as bad as that.
void know_worst(Claim& claim, const Extreme* extreme) {
  for (Claim::Broken& b : claim.broken) {
    if (extreme == nullptr) continue;
    const double at = b.above ? extreme->at_largest : extreme->at_least;
    const Bounds& worst = b.above ? extreme->largest : extreme->least;
    if (b.begin.low <= at && at <= b.end.high && worst.bounded()) b.worst = worst, b.at = at;
  }
}

}  // namespace

void Prover::conclude_all(MotionProof& out) {
  // Where it is not decided whether the mechanism can be assembled; not the moment between where it can and where it cannot.
  std::vector<Bounds> unknown;
  for (std::size_t c = 0; c < claims_.size(); ++c) {
    Claim& claim = claims_[c].claim;
    for (const Mark& m : doubtful_[c])
      if (m.broken_within || std::ranges::any_of(unknown, [&](const Bounds& t) { return t.low <= m.time.low && m.time.high <= t.high; }))
        marks_[c].push_back(m);
    if (claim.about == Claim::About::regular) {
      out.meetings = meetings_of(marks_[c]);
      for (const Meeting& m : out.meetings) {
        claim.undecided.push_back(m.time);
        if (m.what == Meeting::What::crossing) claim.state = Claim::State::broken;
      }
      if (claim.state != Claim::State::broken && !out.meetings.empty()) claim.state = Claim::State::undecided;
    } else if (claim.reason.empty()) {
      conclude(claim, std::move(marks_[c]));
      if (claims_[c].quantity > 0)
        know_worst(claim, out.extreme(quantities_.column(machine_, quantities_.all[static_cast<std::size_t>(claims_[c].quantity)])));
    }
    if (c == assembly) {
      unknown = claim.undecided;
      for (const Claim::Broken& b : claim.broken)
        for (const Bounds& end : {b.begin, b.end})
          if (end.width() > 4 * finest_) unknown.push_back(end);
    }
    out.claims.push_back(std::move(claim));
  }
}

void Prover::run(MotionProof& out) {
  settle_claims();
  out.intervals = static_cast<int>(leaves_.size());
  out.extremes = extremes();
  conclude_all(out);
  out.evaluations = spans_.evaluations();
  out.exhausted = exhausted_;
  out.resolution = finest_;
}

}  // namespace pmreport::analysis
