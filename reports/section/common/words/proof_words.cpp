#include <reports/section/common/words/proof_words.hpp>

#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/model/joint_motion.hpp>
#include <core/text/text.hpp>
#include <reports/section/common/words/brackets.hpp>
#include <reports/section/common/words/limits.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pmreport::section {

using About = ProvedClaim::About;
using State = ProvedClaim::State;

namespace {

constexpr std::array kinds{About::assembled, About::stroke, About::joint_limit, About::regular};

std::string time_words(double t) { return format_number(t, 6) + " s"; }

// "a, b and c"; of many the first few, how many more, and the last.
std::string some(const std::vector<std::string>& pieces) {
  if (pieces.size() <= told_one_by_one) return listed(pieces);
  const std::vector<std::string> first(pieces.begin(), pieces.begin() + told_one_by_one);
  return fmt::format("{} and {} more times, the last {}", fmt::join(first, ", "), pieces.size() - told_one_by_one, pieces.back());
}

std::string stretch_words(const ProvedClaim::Broken& b) {
  const std::string begin = instant_words(b.begin), end = instant_words(b.end);
  return begin == end ? "at t = " + begin : fmt::format("from t = {} to {}", begin, end);
}

std::string when_broken(const ProvedClaim& c) {
  std::vector<std::string> pieces;
  for (const ProvedClaim::Broken& b : c.broken) pieces.push_back(stretch_words(b));
  return some(pieces);
}

std::string when_undecided(const std::vector<Bounds>& spans) {
  std::vector<std::string> pieces;
  for (const Bounds& b : spans) pieces.push_back(span_words(b));
  return some(pieces);
}

double excess(const ProvedClaim& c, const ProvedClaim::Broken& b) {
  return b.above ? b.worst.high - c.range.max : c.range.min - b.worst.low;
}

const ProvedClaim::Broken* worst_of(const ProvedClaim& c) {
  const ProvedClaim::Broken* out = nullptr;
  for (const ProvedClaim::Broken& b : c.broken)
    if (b.worst.bounded() && (out == nullptr || excess(c, b) > excess(c, *out))) out = &b;
  return out;
}

// ", at most by 2.3 mm (802.3 mm at t = 1.64 s, its stroke ends at 800 mm)"; `whose`: of several, the one that goes farthest.
std::string farthest_words(const Proved& p, const ProvedClaim& c, const std::string& whose) {
  const ProvedClaim::Broken* worst = worst_of(c);
  if (worst == nullptr) return "";
  const std::string unit = unit_of(p, c);
  const double limit = worst->above ? c.range.max : c.range.min;
  const Apart told = show_apart(worst->worst.middle(), limit, unit);
  std::string range;
  if (c.about == About::stroke) {
    range = fmt::format("its stroke {} at {}", worst->above ? "ends" : "begins", told.beside);
  } else {
    const Joint& joint = p.topology.joints[static_cast<std::size_t>(c.index)];
    range = "its limit is " + told.beside + (joint.from.isZero() ? "" : " from " + mechanics::origin_of(p.topology, joint));
  }
  return fmt::format(", at most{} by {} ({} at t = {}, {})", whose.empty() ? "" : " " + whose, show(excess(c, *worst), unit, 3), told.value,
                     time_words(worst->at), range);
}

// Claims about the same thing of every limb: strokes, or limits of joints of one letter.
bool alike(const Proved& p, const ProvedClaim& x, const ProvedClaim& y) {
  const auto letters = [&](const ProvedClaim& c) {
    const std::string name = subject_of(p, c);
    return name.substr(0, name.find_first_of("0123456789"));
  };
  return x.about == y.about && unit_of(p, x) == unit_of(p, y) && (x.about == About::stroke || letters(x) == letters(y));
}

using Group = std::vector<const ProvedClaim*>;
std::vector<Group> grouped(const Proved& p, const std::vector<const ProvedClaim*>& claims) {
  std::vector<Group> out;
  for (const ProvedClaim* c : claims) {
    const auto found = std::ranges::find_if(out, [&](const Group& g) { return alike(p, *g.front(), *c); });
    (found != out.end() ? *found : out.emplace_back()).push_back(c);
  }
  return out;
}

std::vector<const ProvedClaim*> in_state(const Proved& p, About about, State state) {
  std::vector<const ProvedClaim*> out = p.of(about);
  std::erase_if(out, [&](const ProvedClaim* c) { return c->state != state; });
  return out;
}

std::string named(const Proved& p, const Group& g) {
  std::vector<std::string> names;
  for (const ProvedClaim* c : g)
    if (std::string name = subject_of(p, *c); std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  return names_of(names);
}

// "its stroke", "their strokes", "its limit".
std::string what_of(const Group& g) {
  return fmt::format("{} {}{}", g.size() == 1 ? "its" : "their", g.front()->about == About::stroke ? "stroke" : "limit",
                     g.size() == 1 ? "" : "s");
}
std::string of_joints(const Group& g) { return g.front()->about != About::joint_limit ? "" : g.size() == 1 ? "joint " : "joints "; }

// Of several alike: between which times at all, and which goes farthest.
std::string leave_words(const Proved& p, const Group& g) {
  if (g.size() == 1)
    return fmt::format("{}{} leaves its {} {}{}", of_joints(g), subject_of(p, *g.front()),
                       g.front()->about == About::stroke ? "stroke" : "limit", when_broken(*g.front()), farthest_words(p, *g.front(), ""));
  const ProvedClaim* worst = nullptr;
  const ProvedClaim::Broken *first = nullptr, *last = nullptr;
  std::size_t stretches = 0;
  for (const ProvedClaim* c : g) {
    stretches += c->broken.size();
    for (const ProvedClaim::Broken& b : c->broken) {
      if (first == nullptr || b.begin.low < first->begin.low) first = &b;
      if (last == nullptr || b.end.high > last->end.high) last = &b;
    }
    if (const auto* w = worst_of(*c); w != nullptr && (worst == nullptr || excess(*c, *w) > excess(*worst, *worst_of(*worst)))) worst = c;
  }
  std::string out = fmt::format("{}{} leave {}", of_joints(g), named(p, g), what_of(g));
  if (first != nullptr)
    out += fmt::format(", {} in all, between t = {} and {}", stretches == 1 ? "once" : fmt::format("{} times", stretches),
                       instant_words(first->begin), instant_words(last->end));
  if (worst != nullptr) out += farthest_words(p, *worst, subject_of(p, *worst));
  return out;
}

// By how far it is left, as a share of the range.
void worst_first(std::vector<Group>& groups) {
  const auto badness = [&](const Group& g) {
    double out = 0;
    for (const ProvedClaim* c : g)
      if (const auto* w = worst_of(*c)) out = std::max(out, excess(*c, *w) / std::max(c->range.max - c->range.min, 1e-300));
    return std::isfinite(out) ? out : 0.0;
  };
  std::ranges::stable_sort(groups, [&](const Group& x, const Group& y) { return badness(x) > badness(y); });
  for (Group& g : groups)
    std::ranges::stable_sort(g, [&](const ProvedClaim* x, const ProvedClaim* y) { return badness({x}) > badness({y}); });
}

std::vector<std::string> leaving(const Proved& p, const std::vector<const ProvedClaim*>& broken) {
  std::vector<Group> groups = grouped(p, broken);
  worst_first(groups);
  std::vector<std::string> out;
  for (const Group& g : groups) out.push_back(leave_words(p, g));
  return out;
}

std::vector<std::string> meetings_of(const Proved& p, Meeting::What what) {
  std::vector<std::string> out;
  for (const Meeting& m : p.proof.meetings)
    if (m.what == what) out.push_back(what == Meeting::What::crossing ? "at t = " + instant_words(m.time) : span_words(m.time));
  return out;
}

std::vector<std::string> broken_regularity(const Proved& p) {
  std::vector<std::string> out;
  if (const auto crossings = meetings_of(p, Meeting::What::crossing); !crossings.empty())
    out.push_back("det G changes its sign " + some(crossings));
  if (!out.empty()) return out;
  for (const ProvedClaim* c : in_state(p, About::regular, State::broken))
    out.push_back(c->broken.empty() ? std::string("regularity is lost") : "regularity is lost " + when_broken(*c));
  return out;
}

std::vector<std::string> undecided_regularity(const Proved& p) {
  std::vector<std::string> out;
  if (const auto touches = meetings_of(p, Meeting::What::touch); !touches.empty())
    out.push_back("det G touches zero, or comes so near that it is not decided whether it does, " + some(touches));
  if (const auto ends = meetings_of(p, Meeting::What::unbounded); !ends.empty())
    out.push_back("whether G stays finite is not decided " + some(ends));
  for (const ProvedClaim* c : p.of(About::regular)) {
    std::vector<Bounds> rest = c->undecided;
    std::erase_if(rest, [&](const Bounds& b) {
      return std::ranges::any_of(p.proof.meetings, [&](const Meeting& m) { return m.time.low <= b.high && m.time.high >= b.low; });
    });
    if (!rest.empty())
      out.push_back("whether det G keeps its sign is not decided " + when_undecided(rest));
    else if (c->state == State::undecided && c->undecided.empty() && out.empty())
      out.emplace_back("whether det G keeps its sign is not decided");
  }
  return out;
}

std::string kind_words(About about) {
  switch (about) {
    case About::assembled:
      return "assembly";
    case About::stroke:
      return "strokes";
    case About::joint_limit:
      return "joint limits";
    case About::regular:
      return "regularity";
  }
  return "";
}

std::string joined(const std::vector<std::string>& pieces) {
  return pieces.empty() ? "" : as_sentence(fmt::format("{}", fmt::join(pieces, "; ")));
}

void add(std::vector<std::string>& to, std::vector<std::string> more) {
  for (std::string& piece : more) to.push_back(std::move(piece));
}

std::string sentence(const Proved& p, bool with_broken) {
  if (!p.proof.unexamined.empty()) return "What holds between the samples was not examined: " + p.proof.unexamined + ".";
  std::vector<std::string> pieces;
  if (std::string holding = holding_words(p); !holding.empty()) pieces.push_back(std::move(holding));
  if (with_broken)
    for (const About about : kinds) add(pieces, broken_words(p, about));
  for (const About about : kinds) add(pieces, undecided_words(p, about));
  for (const About about : kinds) add(pieces, unexamined_words(p, about));
  if (p.proof.exhausted) pieces.push_back(fmt::format("the bound on the number of intervals was reached at {}", p.proof.intervals));
  return joined(pieces);
}

}  // namespace

std::vector<const ProvedClaim*> Proved::of(About about) const {
  std::vector<const ProvedClaim*> out;
  if (about == About::regular && singular_everywhere) return out;
  for (const ProvedClaim& c : proof.claims)
    if (c.about == about) out.push_back(&c);
  return out;
}

bool Proved::holds(About about) const {
  const std::vector<const ProvedClaim*> claims = of(about);
  return !claims.empty() && std::ranges::all_of(claims, [](const ProvedClaim* c) { return c->state == State::holds; });
}

bool Proved::any(About about, State state) const {
  return std::ranges::any_of(of(about), [&](const ProvedClaim* c) { return c->state == state; });
}

Proved proved(const Analysis& a) { return {a.proof(), a.machine().topology(), a.singular_everywhere()}; }

std::string unit_of(const Proved& p, const ProvedClaim& c) {
  const auto at = static_cast<std::size_t>(c.index);
  return c.about == About::stroke ? p.topology.actuators[at].unit : mechanics::motion_unit(p.topology.joints[at]);
}

std::string subject_of(const Proved& p, const ProvedClaim& c) {
  if (c.about == About::stroke) return p.topology.actuators[static_cast<std::size_t>(c.index)].name;
  if (c.about != About::joint_limit) return "";
  const Joint& joint = p.topology.joints[static_cast<std::size_t>(c.index)];
  return joint.limits.size() > 1 ? fmt::format("{} (axis {})", joint.name, c.limit + 1) : joint.name;
}

std::string holding_words(const Proved& p) {
  std::vector<std::string> names;
  for (const About about : {About::stroke, About::joint_limit, About::regular})
    if (p.holds(about)) names.push_back(kind_words(about));
  // The moment between what can be assembled and what cannot is not judged.
  const std::string where =
      p.holds(About::assembled) ? "" : " at which the mechanism can be assembled, but for the last microsecond before it cannot,";
  const std::string when = fmt::format("at every instant{} from {} to {} (proved, {})", where, time_words(p.proof.begin),
                                       time_words(p.proof.end), plural(p.proof.intervals, "interval"));
  if (!names.empty())
    return fmt::format("{} {} {}", listed(names), names.back() == "regularity" && names.size() == 1 ? "holds" : "hold", when);
  return p.holds(About::assembled) ? "the mechanism can be assembled " + when : "";
}

std::vector<std::string> broken_words(const Proved& p, About about) {
  if (about == About::regular) return p.any(about, State::broken) ? broken_regularity(p) : std::vector<std::string>{};
  const std::vector<const ProvedClaim*> broken = in_state(p, about, State::broken);
  if (about != About::assembled) return leaving(p, broken);
  std::vector<std::string> out;
  for (const ProvedClaim* c : broken) out.push_back("the mechanism cannot be assembled " + when_broken(*c));
  return out;
}

std::vector<std::string> broken_limits(const Proved& p) {
  std::vector<const ProvedClaim*> broken = in_state(p, About::stroke, State::broken);
  for (const ProvedClaim* c : in_state(p, About::joint_limit, State::broken)) broken.push_back(c);
  return leaving(p, broken);
}

// A claim that is broken may be undecided elsewhere.
std::vector<std::string> undecided_words(const Proved& p, About about) {
  if (about == About::regular) return undecided_regularity(p);
  std::vector<const ProvedClaim*> claims = p.of(about);
  std::erase_if(claims, [](const ProvedClaim* c) { return c->undecided.empty() && c->state != State::undecided; });
  std::vector<std::string> out;
  if (claims.empty()) return out;
  if (about == About::assembled) {
    out.push_back("whether the mechanism can be assembled is not decided " + when_undecided(claims.front()->undecided));
    return out;
  }
  for (const Group& g : grouped(p, claims)) {
    std::vector<Bounds> spans;
    for (const ProvedClaim* c : g)
      for (const Bounds& b : c->undecided)
        if (std::ranges::find(spans, b) == spans.end()) spans.push_back(b);
    std::ranges::sort(spans, {}, &Bounds::low);
    const std::string when = spans.empty() ? "" : " " + when_undecided(spans);
    out.push_back(
        fmt::format("whether {}{} {} {} is not decided{}", of_joints(g), named(p, g), g.size() == 1 ? "keeps" : "keep", what_of(g), when));
  }
  return out;
}

std::vector<std::string> unexamined_words(const Proved& p, About about) {
  std::vector<std::pair<std::string, Group>> by_reason;
  for (const ProvedClaim* c : in_state(p, about, State::unexamined)) {
    const auto found = std::ranges::find_if(by_reason, [&](const auto& r) { return r.first == c->reason; });
    (found != by_reason.end() ? found->second : by_reason.emplace_back(c->reason, Group{}).second).push_back(c);
  }
  std::vector<std::string> out;
  for (const auto& [reason, g] : by_reason) {
    const bool whole = g.size() == p.of(about).size();
    const std::string what = whole ? kind_words(about) : fmt::format("the {} of {}", kind_words(about), named(p, g));
    const bool one = about == About::assembled || about == About::regular;
    out.push_back(fmt::format("{} {} not examined{}", what, one ? "was" : "were", reason.empty() ? "" : ": " + reason));
  }
  return out;
}

std::string motion_sentence(const Proved& p) { return sentence(p, true); }
std::string remaining_sentence(const Proved& p) { return sentence(p, false); }

std::vector<std::string> assembly_sentences(const Analysis& a, const Proved& p) {
  std::vector<std::string> out = reach_sentences(a);
  if (out.empty())
    for (const std::string& piece : broken_words(p, About::assembled)) out.push_back(as_sentence(piece));
  return out;
}

std::vector<std::string> range_sentences(const Analysis& a, const Proved& p) {
  const auto knows = [&](const LimitBreach& b) {
    const std::string name = b.subject.substr(0, b.subject.find(" ("));
    return std::ranges::any_of(in_state(p, b.stroke ? About::stroke : About::joint_limit, State::broken), [&](const ProvedClaim* c) {
      const std::string& own = c->about == About::stroke ? p.topology.actuators[static_cast<std::size_t>(c->index)].name
                                                         : p.topology.joints[static_cast<std::size_t>(c->index)].name;
      return name == (b.stroke ? own : "joint " + own);
    });
  };
  if (!std::ranges::all_of(a.breaches(), knows)) return breach_sentences(a);
  std::vector<std::string> out;
  for (const std::string& piece : broken_limits(p)) out.push_back(as_sentence(piece));
  return out;
}

// Only letters of ASCII begin a piece; a name of the program stays as it is written.
std::string as_sentence(std::string piece) {
  if (piece.empty()) return piece;
  const std::string first = piece.substr(0, piece.find(' '));
  for (const char* word : {"strokes", "joint", "joints", "regularity", "the", "whether", "assembly"})
    if (first == word || first == std::string(word) + ",") piece[0] = static_cast<char>(piece[0] - 'a' + 'A');
  return piece + ".";
}

}  // namespace pmreport::section
