#include <reports/section/every_instant/every_instant.hpp>

#include <core/text/units.hpp>
#include <reports/section/common/words/brackets.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

namespace pmreport::section {

using document::Bracket;
using document::EveryInstant;
using document::Paragraph;
using About = ProvedClaim::About;
using State = ProvedClaim::State;

namespace {

Bracket bracket_of(const Bounds& b) { return {b.low, b.high}; }

const char* name_of(About about) {
  switch (about) {
    case About::assembled:
      return "assembly";
    case About::stroke:
      return "stroke";
    case About::joint_limit:
      return "joint limit";
    case About::regular:
      return "regularity";
  }
  return "";
}

const char* name_of(State state) {
  switch (state) {
    case State::holds:
      return "holds";
    case State::broken:
      return "broken";
    case State::undecided:
      return "not decided";
    case State::unexamined:
      return "not examined";
  }
  return "";
}

const char* name_of(Meeting::What what) {
  return what == Meeting::What::crossing ? "crossing" : what == Meeting::What::touch ? "touch" : "unbounded";
}

EveryInstant::Claim result_of(const Proved& p, const ProvedClaim& c) {
  EveryInstant::Claim out;
  out.about = name_of(c.about);
  out.subject = subject_of(p, c);
  const bool ranged = c.about == About::stroke || c.about == About::joint_limit;
  if (ranged) {
    out.unit = unit_of(p, c);
    out.range = {c.range.min, c.range.max};
  }
  const bool nothing = c.about == About::regular && p.singular_everywhere;
  out.state = nothing ? "not applicable" : name_of(c.state);
  out.reason = nothing ? "the architecture is singular at every pose" : c.reason;
  if (nothing) return out;
  for (const ProvedClaim::Broken& b : c.broken)
    out.broken.push_back({bracket_of(b.begin), bracket_of(b.end), ranged ? (b.above ? "above" : "below") : "", bracket_of(b.worst), b.at});
  for (const Bounds& b : c.undecided) out.undecided.push_back(bracket_of(b));
  return out;
}

constexpr std::size_t meetings_shown = 24;

// Where det G is zero, or may be; each happens within its times.
document::Table table_of_meetings(const MotionProof& proof) {
  document::Table table{"Where the motion meets a singular surface, or may: the times outside of which it is proved not to.",
                        {"what", "from t [s]", "to t [s]"},
                        {false, true, true},
                        {}};
  for (const Meeting& m : proof.meetings) {
    if (table.rows.size() == meetings_shown) break;
    const Ends ends = ends_of(m.time, 1);
    table.rows.push_back({m.what == Meeting::What::crossing ? "det G changes its sign"
                          : m.what == Meeting::What::touch  ? "det G touches zero, or comes too near to tell"
                                                            : "G may grow beyond all bounds",
                          ends.low, ends.high});
  }
  if (proof.meetings.size() > meetings_shown)
    table.caption += fmt::format(" The first {} of {}; all are in results.json.", meetings_shown, proof.meetings.size());
  return table;
}

// One row a quantity, SI. Column names as in the other data.
document::Data data_of(const std::vector<ExtremeShown>& extremes) {
  document::Data out{"every_instant",
                     {"quantity", "unit", "least_low", "least_high", "least_at [s]", "largest_low", "largest_high", "largest_at [s]"},
                     std::vector<std::vector<double>>(6),
                     std::vector<std::vector<std::string>>(2)};
  for (const ExtremeShown& e : extremes) {
    out.words[0].push_back(e.column.name);
    out.words[1].push_back(e.column.unit);
    const double row[] = {e.extreme->least.low,   e.extreme->least.high,   e.extreme->at_least,
                          e.extreme->largest.low, e.extreme->largest.high, e.extreme->at_largest};
    for (std::size_t c = 0; c < 6; ++c) out.columns[c].push_back(row[c]);
  }
  return out;
}

Paragraph::Tone tone_of(const Proved& p) {
  bool broken = false, open = !p.proof.unexamined.empty();
  for (const About about : {About::assembled, About::stroke, About::joint_limit, About::regular}) {
    broken = broken || p.any(about, State::broken);
    open = open || p.any(about, State::undecided) || p.any(about, State::unexamined);
  }
  return broken ? Paragraph::Tone::warning : open ? Paragraph::Tone::note : Paragraph::Tone::plain;
}

}  // namespace

AtEveryInstant every_instant_section(const Analysis& a, const Proved& p, const std::vector<analysis::Unseen>& unseen) {
  AtEveryInstant out;
  document::Section& s = out.section;
  s.id = s.kind = "every-instant";
  s.title = "At every instant";
  const auto show = [&s](document::Block block) { s.blocks.push_back(std::move(block)); };
  show(Paragraph{tone_of(p), motion_sentence(p)});
  if (p.proof.unexamined.empty()) {
    show(Paragraph{
        Paragraph::Tone::plain,
        fmt::format(
            "Interval arithmetic on the recorded geometry of the plugin, rounding included, says what no sample can: what is true of "
            "all instants of a span of time. The motion is cut into as many spans as that takes, {} here; times are told to {} or "
            "better where rounding allows it.",
            p.proof.intervals, format_number(1e6 * p.proof.resolution, 2) + " µs")});
    if (!p.proof.meetings.empty() && !p.singular_everywhere) show(table_of_meetings(p.proof));
    const std::vector<ExtremeShown> extremes = extremes_shown(a, p);
    if (document::Table table = table_of_extremes(a, extremes); !table.rows.empty()) show(std::move(table));
    if (!extremes.empty()) {
      show(Paragraph{Paragraph::Tone::note, "All brackets, of coordinates and derived quantities too, are in data/every_instant.csv."});
      out.data.push_back(data_of(extremes));
    }
  }
  show(proof_of_motion(a, p, unseen));
  return out;
}

EveryInstant every_instant_results(const Analysis& a, const Proved& p) {
  EveryInstant out;
  out.sentence = motion_sentence(p);
  out.unexamined = p.proof.unexamined;
  out.begin = p.proof.begin, out.end = p.proof.end;
  out.intervals = p.proof.intervals, out.evaluations = p.proof.evaluations;
  out.exhausted = p.proof.exhausted, out.resolution = p.proof.resolution;
  for (const ProvedClaim& c : p.proof.claims) out.claims.push_back(result_of(p, c));
  for (const Meeting& m : p.proof.meetings) out.meetings.push_back({name_of(m.what), bracket_of(m.time)});
  for (const ExtremeShown& e : extremes_shown(a, p))
    out.extremes.push_back({e.column.name, e.column.unit, bracket_of(e.extreme->least), bracket_of(e.extreme->largest), e.extreme->at_least,
                            e.extreme->at_largest});
  return out;
}

}  // namespace pmreport::section
