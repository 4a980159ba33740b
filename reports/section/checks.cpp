// The gates of a report.
#include <reports/section/check_words.hpp>
#include <reports/section/checks.hpp>
#include <reports/section/common/words/brackets.hpp>
#include <reports/section/common/words/demands.hpp>
#include <reports/section/common/words/limits.hpp>
#include <reports/section/common/words/singular_words.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pmreport::section {

namespace {

// The column without which a check has no value, and why it has none.
std::string why_no_value(const Analysis& a, const scenario::Check& c) {
  if (!c.quantity.empty()) return "its section could not compute it";
  for (const std::string& name : c.columns) {
    const ColumnId column = ColumnId::named(name);
    if (!a.has(column)) return name + " is not computed in this run";
    scenario::Measured alone = c;
    alone.columns = {name};
    if (std::isfinite(analysis::measure(a, alone).value)) continue;
    if (c.reduction != "at") return fmt::format("{} has none at any sample: {}", name, why_nothing(a));
    const std::string& why = a.why(a.sample_at(c.time));
    return fmt::format("{} has none at that time{}", name, why.empty() ? "" : ": " + why);
  }
  return "it has no columns";
}

// One bound of a check, the number that comes nearest to breaking it, and whether it does.
struct Verdict {
  Number found;
  bool passed;                        // by the samples
  double bound;                       // SI
  std::string demand, broken;         // "< 400 N"; "not below 400 N"
  std::optional<Bounds> proved = {};  // the number over every instant lies within
  std::optional<bool> decided = {};   // by that; none: the bound lies within, and the samples decide

  bool holds() const { return passed && decided.value_or(true); }
};

// A bound that the number lies below, or above, whatever it is within its bracket.
std::optional<bool> decided_by(const std::optional<Bounds>& b, double bound, bool below) {
  if (!b) return {};
  if (below ? b->high < bound : b->low > bound) return true;
  if (below ? b->low >= bound : b->high <= bound) return false;
  return {};
}

Verdict judge(const Analysis& a, const Proved& p, const scenario::Check& c, const std::vector<document::Value>& values, double bound,
              bool below) {
  const Number found = measure(a, c, values, below);
  const std::string limit = written(bound, c);
  const bool passed = std::isfinite(found.value) && (below ? found.value < bound : found.value > bound);
  const auto proved = analysis::measure_proved(p.proof, c, below);
  return {found,
          passed,
          bound,
          (below ? "< " : "> ") + limit,
          std::string("not ") + (below ? "below " : "above "),
          proved,
          decided_by(proved, bound, below)};
}

// Of a group every column must be near: the one farthest away counts.
Verdict judge_equality(const Analysis& a, const Proved& p, const scenario::Check& c, const std::vector<document::Value>& values) {
  const double wanted = *c.equals;
  const Number high = measure(a, c, values, true), low = measure(a, c, values, false);
  const Number found = std::abs(low.value - wanted) > std::abs(high.value - wanted) ? low : high;
  const bool exact = c.within == 0;
  const std::string near = exact ? "" : written(c.within, c);
  const auto most = analysis::measure_proved(p.proof, c, true), least = analysis::measure_proved(p.proof, c, false);
  std::optional<bool> decided;
  if (most && least) {
    const bool within = most->high <= wanted + c.within && least->low >= wanted - c.within;
    const bool beyond = most->low > wanted + c.within || least->high < wanted - c.within;
    if (within || beyond) decided = within;
  }
  const bool by_most = !most || !least || std::abs(most->middle() - wanted) >= std::abs(least->middle() - wanted);
  return {found,
          std::abs(found.value - wanted) <= c.within,
          wanted,
          "= " + written(wanted, c) + (exact ? "" : " ± " + near),
          exact ? "not " : "not within " + near + " of ",
          by_most ? most : least,
          decided};
}

// What the bracket says of a number, where the samples do not say it alone.
std::string bracket_words(const Verdict& v, const scenario::Check& c) {
  const std::string told = "at every instant: " + known_words(*v.proved, c);
  return v.decided ? told : told + "; the bound lies within this bracket, so the samples decide";
}

// What a section knows of a quantity from both sides, such as a volume: its values of the same name with _low and _high.
std::optional<Bounds> known_of(const scenario::Check& c, const std::vector<document::Value>& values) {
  if (c.quantity.empty()) return {};
  std::optional<double> low, high;
  for (const document::Value& v : values) {
    const std::string name = v.section + "." + v.name;
    if (name == c.quantity + "_low") low = v.value;
    if (name == c.quantity + "_high") high = v.value;
  }
  if (!low || !high || !(*low <= *high)) return {};
  return Bounds{*low, *high};
}
// Where a bound lies between them.
std::string open_words(const scenario::Check& c, const std::vector<Verdict>& verdicts, const std::vector<document::Value>& values) {
  const std::optional<Bounds> known = known_of(c, values);
  const auto within = [&](const Verdict& v) { return known->low < v.bound && v.bound < known->high; };
  if (!known || c.equals || std::ranges::none_of(verdicts, within)) return "";
  return "it lies within " + bounds_words(*known, c) + ", and the bound too, so their middle decides";
}

document::Check evaluate(const Analysis& a, const Proved& p, const scenario::Check& c, const std::vector<document::Value>& values) {
  std::vector<Verdict> verdicts;
  if (c.below) verdicts.push_back(judge(a, p, c, values, *c.below, true));
  if (c.above) verdicts.push_back(judge(a, p, c, values, *c.above, false));
  if (c.equals) verdicts.push_back(judge_equality(a, p, c, values));
  document::Check out;
  out.line = c.line;
  out.unit = c.unit;
  out.told_in = c.written_in;
  out.passed = true;
  out.proved = std::ranges::all_of(verdicts, [](const Verdict& v) { return v.decided.has_value(); });
  std::vector<std::string> brackets;  // each once
  for (const Verdict& v : verdicts) {
    out.limit += (out.limit.empty() ? "" : ", ") + v.demand;
    out.passed = out.passed && v.holds();
    const bool complete = std::isfinite(v.found.value), by_proof_alone = v.passed && !v.holds();
    const Apart told = measured_words(v.found.value, v.bound, c);
    if (out.measured.empty() || !v.holds()) {
      out.value = v.found.value;
      out.bound = v.bound;
      out.measured = !complete ? "no value" : by_proof_alone ? known_words(*v.proved, c) : told.value;
      if (v.proved) out.bracket = {v.proved->low, v.proved->high};
    }
    if (v.proved)
      if (std::string words = bracket_words(v, c); std::ranges::find(brackets, words) == brackets.end())
        brackets.push_back(std::move(words));
    if (v.holds()) continue;
    if (!complete)
      out.message = c.that + " has no value: " + why_no_value(a, c);
    else if (by_proof_alone)
      out.message = fmt::format("{}: {} at every instant, which is {}{}; the samples alone keep it, at {}", c.that,
                                known_words(*v.proved, c), v.broken, told.beside, told.value);
    else
      out.message = fmt::format("{}{}: {} is {}, which is {}{}", v.found.sample >= 0 ? "t = " + show_time(a, v.found.sample) + ": " : "",
                                c.that, c.quantity.empty() ? v.found.column : "it", told.value, v.broken, told.beside);
  }
  if (const std::string open = open_words(c, verdicts, values); !open.empty()) {
    if (out.passed)
      brackets.push_back(open);
    else
      out.message += "; " + open;
  }
  if (out.passed) out.message = fmt::format("{}", fmt::join(brackets, "; "));
  out.name = c.that + " " + out.limit;
  return out;
}

// What every report demands of its motion.
document::Check demand(const std::string& name, int broken, const std::string& measured, const std::string& message) {
  document::Check c;
  c.name = name;
  c.measured = measured;
  c.limit = "none";
  c.value = broken;
  c.passed = broken == 0;
  if (!c.passed) c.message = message;
  return c;
}

// Samples without a pose have no forces; the demand that every sample can be assembled tells them, so they break no limit here. A motion of
// which no sample could be judged has kept nothing.
document::Check limits_kept(const Analysis& a) {
  const LimitCount n = count_limits(a);
  const std::vector<std::string> sentences = limit_sentences(a);
  document::Check c = demand("limits of forces, speeds, powers and reactions are kept", n.broken,
                             fmt::format("at {} of {} samples", n.judged - n.broken, a.samples()), first_and_number(sentences));
  c.limit = "at all";
  if (n.judged == 0 && n.broken == 0) c.passed = false, c.message = "no sample has forces to hold against the limits";
  return c;
}

}  // namespace

// Of a group the column counts that comes nearest to breaking a bound: the largest of an upper one.
Number measure(const Analysis& a, const scenario::Measured& m, const std::vector<document::Value>& values, bool largest) {
  if (!m.quantity.empty()) {
    for (const document::Value& v : values)
      if (v.section + "." + v.name == m.quantity) return {v.value, -1, ""};
    return {};
  }
  return analysis::measure(a, m, largest);
}

namespace {

// "between the samples t = 1.2 s and t = 1.21 s": where the first stretch of a claim begins.
std::string between_samples(const Analysis& a, const ProvedClaim& c) {
  if (c.broken.empty()) return "";
  const double t = c.broken.front().begin.middle();
  const auto after = std::ranges::upper_bound(a.time(), t);
  const int next = std::clamp(static_cast<int>(after - a.time().begin()), 1, a.samples() - 1);
  return fmt::format(", first between the samples t = {} and t = {}", show_time(a, next - 1), show_time(a, next));
}

// How many keep it.
std::string of_samples(const Analysis& a, int broken) { return fmt::format("at {} of {} samples", a.samples() - broken, a.samples()); }
// Where a claim is proved to hold.
const char* proved_words(const Proved& p) {
  return p.holds(ProvedClaim::About::assembled) ? "at every instant (proved)" : "wherever it can be assembled (proved)";
}

std::string first(const std::vector<std::string>& sentences) { return sentences.empty() ? std::string() : sentences.front(); }

// Of kinds of claims: a demand that the samples keep and the proof refutes fails by the proof; one that both keep holds at every instant.
document::Check demand_always(const Analysis& a, const Proved& p, const char* name, int broken, const std::vector<std::string>& sentences,
                              std::initializer_list<ProvedClaim::About> kinds) {
  document::Check c = demand(name, broken, of_samples(a, broken), first_and_number(sentences));
  c.limit = "at all";
  if (broken > 0 || !p.proof.unexamined.empty()) return c;
  std::size_t stretches = 0, claims = 0;
  bool all_hold = true;
  std::string where;
  for (const ProvedClaim::About about : kinds)
    for (const ProvedClaim* claim : p.of(about)) {
      ++claims;
      all_hold = all_hold && claim->state == ProvedClaim::State::holds;
      if (claim->state != ProvedClaim::State::broken) continue;
      stretches += std::max<std::size_t>(1, claim->broken.size());
      if (where.empty()) where = between_samples(a, *claim);
    }
  if (stretches > 0) {
    c = demand(name, static_cast<int>(stretches), plural(static_cast<int>(stretches), "time") + " between samples", first(sentences));
    if (c.message.ends_with('.')) c.message.pop_back();
    c.message += where + "." + number_of_others(sentences);
    c.proved = true;
  } else if (claims > 0 && all_hold) {
    c.measured = proved_words(p), c.proved = true;
  }
  return c;
}

document::Check regularity(const Analysis& a, const Proved& p) {
  const std::vector<std::string> lost = broken_words(p, ProvedClaim::About::regular);
  int met = singularities_met(a);
  if (met == 0 && !lost.empty()) met = 1;
  const std::vector<std::string> sentences = singularity_sentences(a);
  document::Check c = demand(demands::regularity, met, met == 0 ? "never" : plural(met, "time"),
                             sentences.empty() ? as_sentence(first(lost)) : first_and_number(sentences));
  c.limit = "never";
  if (c.passed && p.holds(ProvedClaim::About::regular))
    c.message = fmt::format("det G keeps its sign {}; the constraints of all bodies are judged at the samples.", proved_words(p));
  return c;
}

}  // namespace

std::vector<document::Check> evaluate_checks(const Analysis& a, const std::vector<document::Value>& values) {
  return evaluate_checks(a, proved(a), values);
}

std::vector<document::Check> evaluate_checks(const Analysis& a, const Proved& p, const std::vector<document::Value>& values) {
  std::vector<document::Check> out;
  for (const scenario::Check& c : a.scenario().checks) out.push_back(evaluate(a, p, c, values));

  if (!a.scenario().motion) return out;  // nothing moves: there is nothing to demand of it

  int broken = 0;
  for (const SampleRun& i : a.broken()) broken += i.last - i.first + 1;
  out.push_back(
      demand_always(a, p, demands::assembly, a.count(Outcome::unreachable), assembly_sentences(a, p), {ProvedClaim::About::assembled}));
  out.push_back(
      demand_always(a, p, demands::limits, broken, range_sentences(a, p), {ProvedClaim::About::stroke, ProvedClaim::About::joint_limit}));
  if (a.scenario().limits.any()) out.push_back(limits_kept(a));
  out.push_back(regularity(a, p));
  return out;
}

}  // namespace pmreport::section
