#include <core/analysis/proof/prover.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pmreport::analysis {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t at_first = 32;     // equal spans, to begin with
constexpr std::size_t most_knots = 512;  // of which each is an end of a span from the beginning
constexpr double rounding = 1e-13;       // of a quantity
constexpr double least_share = 1e-8;     // of the motion: no span is halved that is shorter

// The side of det G that is certain at an end of a span.
int side_at(const InstantFacts* instant) { return instant->side; }

}  // namespace

Prover::Prover(const mechanics::Machine& machine, const mechanics::MotionProgram& program, const mechanics::Enclosure& motion, Bounds whole,
               const std::vector<double>& knots, const ProofOptions& options)
    : machine_(machine),
      quantities_(machine, program),
      spans_(machine, program, quantities_, motion),
      whole_(whole),
      knots_(knots),
      options_(options),
      finest_(std::min(options.finest, std::max(least_share * whole.width(), 4 * std::nextafter(whole.high, infinite) - 4 * whole.high))),
      claims_(claims_of(machine, program, quantities_)),
      marks_(claims_.size()) {}

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
  spans_.at(times, ends);
  const std::size_t first = instants_.size();
  for (InstantFacts& f : ends) instants_.push_back(std::move(f));
  std::vector<int> all(claims_.size());
  for (std::size_t c = 0; c < all.size(); ++c) all[c] = static_cast<int>(c);
  std::vector<Leaf> out;
  for (std::size_t k = 0; k + 1 < times.size(); ++k)
    out.push_back({{times[k], times[k + 1]}, &instants_[first + k], nullptr, &instants_[first + k + 1], {}, all});
  return out;
}

std::pair<Prover::Leaf, Prover::Leaf> Prover::halves(Leaf&& leaf) const {
  const double at = leaf.middle->time;
  Leaf before{{leaf.time.low, at}, leaf.begin, nullptr, leaf.middle, {}, leaf.open},
      after{{at, leaf.time.high}, leaf.middle, nullptr, leaf.end, {}, std::move(leaf.open)};
  return {std::move(before), std::move(after)};
}

// The facts of new spans, and of their middles.
void Prover::look(std::vector<Leaf>& leaves) {
  const std::size_t n = leaves.size();
  std::vector<double> times(n);
  std::vector<Bounds> spans(n);
  for (std::size_t k = 0; k < n; ++k) spans[k] = leaves[k].time, times[k] = cut(leaves[k].time);
  std::vector<InstantFacts> middles(n);
  spans_.at(times, middles);
  std::vector<const InstantFacts*> places(n);
  for (std::size_t k = 0; k < n; ++k) {
    instants_.push_back(std::move(middles[k]));
    leaves[k].middle = places[k] = &instants_.back();
  }
  std::vector<SpanFacts> facts(n);
  spans_.over(spans, places, facts);
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

bool Prover::spent(std::size_t more) const {
  return spans_.evaluations() + 2 * static_cast<long>(more) > 2 * static_cast<long>(options_.most_intervals);
}

// Judges what is open on a leaf. What holds is closed; what cannot be known better is closed with a mark. Whether the rest asks for halves.
bool Prover::judge_all(Leaf& leaf) {
  const bool smallest = !(leaf.time.width() > finest_) || !(leaf.time.low < leaf.middle->time && leaf.middle->time < leaf.time.high);
  std::vector<int> still;
  const auto close = [&](int c, Judgement judged) {
    Mark m = mark(claims_[static_cast<std::size_t>(c)], judged, leaf.facts, *leaf.middle);
    m.side_before = side_at(leaf.begin), m.side_after = side_at(leaf.end);
    marks_[static_cast<std::size_t>(c)].push_back(m);
  };
  bool assembled = true;  // or not judged any more: it is
  for (const int c : leaf.open) {
    const OpenClaim& claim = claims_[static_cast<std::size_t>(c)];
    const bool about_assembly = claim.claim.about == Claim::About::assembled;
    const Judgement judged = judge(claim, leaf.facts, *leaf.middle);
    if (about_assembly && judged != Judgement::holds) assembled = false;
    if (about_assembly && judged == Judgement::broken) {
      close(c, judged);
      return false;  // nothing else has a meaning there
    }
    if (judged == Judgement::holds) continue;
    if (judged == Judgement::broken || judged == Judgement::hopeless)
      close(c, judged);
    else
      still.push_back(c);
  }
  // G that is singular at the middle and at both ends, as far as rounding tells, is so for a while.
  if (leaf.begin->side == 0 && leaf.middle->side == 0 && leaf.end->side == 0 && leaf.time.width() < 1e-3 * whole_.width()) {
    const auto regular =
        std::ranges::find_if(still, [&](int c) { return claims_[static_cast<std::size_t>(c)].claim.about == Claim::About::regular; });
    if (regular != still.end() && assembled) {
      close(*regular, Judgement::open);
      still.erase(regular);
    }
  }
  leaf.open = std::move(still);
  if (leaf.open.empty()) return false;
  if (!smallest) return true;
  for (const int c : leaf.open)
    if (assembled || claims_[static_cast<std::size_t>(c)].claim.about == Claim::About::assembled) close(c, Judgement::open);
  leaf.open.clear();
  return false;
}

void Prover::settle_claims() {
  std::vector<Leaf> open = first_spans();
  while (!open.empty()) {
    look(open);
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
        for (const int c : leaf.open) {
          Mark m = mark(claims_[static_cast<std::size_t>(c)], Judgement::open, leaf.facts, *leaf.middle);
          m.side_before = side_at(leaf.begin), m.side_after = side_at(leaf.end);
          marks_[static_cast<std::size_t>(c)].push_back(m);
        }
      }
      leaves_.push_back(std::move(leaf));
    }
    open = std::move(next);
  }
}

// The least value over all instants lies between the least of what is certain at some instant and the least of what bounds the leaves; the
// largest likewise. Leaves that keep the two apart are halved until they are not.
void Prover::find_extremes(MotionProof& out) {
  struct Seen {
    Bounds least{-infinite, infinite}, largest{-infinite, infinite};  // brackets
    double at_least = 0, at_largest = 0;
    double tolerance = 0;
  };
  const std::size_t count = quantities_.all.size();
  std::vector<Seen> seen(count);
  const auto skip = [&](const Leaf& leaf) {  // it cannot be assembled there
    const Bounds& reach = leaf.facts.value[0];
    return reach.bounded() && reach.high < 0;
  };
  const auto look_at_instants = [&](std::size_t from) {
    for (std::size_t k = from; k < instants_.size(); ++k) {
      const InstantFacts& f = instants_[k];
      if (!f.placed || !(f.value[0].low >= 0)) continue;
      for (std::size_t q = 0; q < count; ++q) {
        const Bounds& x = f.value[q];
        if (!x.bounded()) continue;
        if (x.high < seen[q].least.high) seen[q].least.high = x.high, seen[q].at_least = f.time;
        if (x.low > seen[q].largest.low) seen[q].largest.low = x.low, seen[q].at_largest = f.time;
      }
    }
  };
  const auto bound = [&] {
    for (std::size_t q = 0; q < count; ++q) seen[q].least.low = infinite, seen[q].largest.high = -infinite;
    for (const Leaf& leaf : leaves_) {
      if (skip(leaf)) continue;
      for (std::size_t q = 0; q < count; ++q) {
        const Bounds x = leaf.facts.value[q].bounded() ? leaf.facts.value[q] : Bounds{};
        seen[q].least.low = std::min(seen[q].least.low, x.low);
        seen[q].largest.high = std::max(seen[q].largest.high, x.high);
      }
    }
  };
  // A share of the range; of what hardly moves beside its like, of theirs; and never less than rounding.
  const auto set_tolerances = [&] {
    std::map<std::pair<Quantity::Of, OfMotion>, double> widest;
    const auto range = [&](std::size_t q) { return std::max(seen[q].largest.low - seen[q].least.high, 0.0); };
    const auto group = [&](std::size_t q) { return std::pair(quantities_.all[q].of, quantities_.all[q].order); };
    for (std::size_t q = 0; q < count; ++q) widest[group(q)] = std::max(widest[group(q)], range(q));
    for (std::size_t q = 0; q < count; ++q) {
      const double share = quantities_.all[q].order == OfMotion::acceleration ? options_.bracket_of_accelerations : options_.bracket;
      const double size = std::max(std::abs(seen[q].largest.low), std::abs(seen[q].least.high));
      seen[q].tolerance = std::max({share * range(q), 0.01 * share * widest[group(q)], rounding * (size < infinite ? size : 0)});
    }
  };
  look_at_instants(0);
  bound();
  for (std::size_t instants = instants_.size();; look_at_instants(std::exchange(instants, instants_.size())), bound()) {
    set_tolerances();
    std::vector<bool> chosen(leaves_.size());
    std::size_t many = 0;
    for (std::size_t k = 0; k < leaves_.size(); ++k) {
      const Leaf& leaf = leaves_[k];
      if (skip(leaf) || !(leaf.time.width() > finest_) || !(leaf.time.low < leaf.middle->time && leaf.middle->time < leaf.time.high))
        continue;
      for (std::size_t q = 1; q < count && !chosen[k]; ++q) {
        const Bounds &x = leaf.facts.value[q], &at = leaf.middle->value[q];
        if (!x.bounded()) {
          chosen[k] = leaf.facts.placed || leaf.time.width() > 1e-3 * whole_.width();
          continue;
        }
        if (x.width() <= 4 * at.width()) continue;  // rounding
        chosen[k] = x.low < seen[q].least.high - seen[q].tolerance || x.high > seen[q].largest.low + seen[q].tolerance;
      }
      many += chosen[k];
    }
    if (many == 0) break;
    if (spent(2 * many)) {
      exhausted_ = true;
      break;
    }
    refine(leaves_, chosen);
  }
  for (std::size_t q = 1; q < count; ++q) {
    const Seen& s = seen[q];
    Extreme e{quantities_.column(machine_, quantities_.all[q]), s.least, s.largest, s.at_least, s.at_largest};
    out.extremes.push_back(std::move(e));
  }
}

// Halves those that are chosen.
void Prover::refine(std::vector<Leaf>& leaves, const std::vector<bool>& chosen) {
  std::vector<Leaf> kept, made;
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    if (!chosen[k]) {
      kept.push_back(std::move(leaves[k]));
      continue;
    }
    auto [before, after] = halves(std::move(leaves[k]));
    made.push_back(std::move(before));
    made.push_back(std::move(after));
  }
  look(made);
  std::ranges::move(made, std::back_inserter(kept));
  leaves = std::move(kept);
}

void Prover::run(MotionProof& out) {
  settle_claims();
  out.intervals = static_cast<int>(leaves_.size());
  find_extremes(out);
  for (std::size_t c = 0; c < claims_.size(); ++c) {
    Claim& claim = claims_[c].claim;
    if (claim.about == Claim::About::regular) {
      out.meetings = meetings_of(marks_[c]);
      for (const Meeting& m : out.meetings) {
        claim.undecided.push_back(m.time);
        if (m.what == Meeting::What::crossing) claim.state = Claim::State::broken;
      }
      if (claim.state != Claim::State::broken && !out.meetings.empty()) claim.state = Claim::State::undecided;
    } else {
      conclude(claim, std::move(marks_[c]));
    }
    out.claims.push_back(std::move(claim));
  }
  out.evaluations = spans_.evaluations();
  out.exhausted = exhausted_;
  out.resolution = finest_;
}

}  // namespace pmreport::analysis
