// The gates of a report.
#include <reports/section/checks.hpp>
#include <reports/section/common/limits.hpp>
#include <reports/section/common/singular_words.hpp>
#include <reports/section/common/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace pmreport::section {

namespace {

// A bound as it was written, to the last digit that says something.
std::string written(double bound, const std::string& unit) {
  constexpr int usual = 6, most = 12;
  const double shown = bound * display_unit(unit, std::abs(bound)).per_si;
  int digits = usual;
  while (digits < most && std::abs(std::strtod(format_number(shown, digits).c_str(), nullptr) - shown) > 1e-12 * std::abs(shown)) ++digits;
  return show(bound, unit, digits);
}

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
  bool passed;
  double bound;                // SI
  std::string demand, broken;  // "< 400 N"; "not below 400 N"
};

Verdict judge(const Analysis& a, const scenario::Check& c, const std::vector<document::Value>& values, double bound, bool below) {
  const Number found = measure(a, c, values, below);
  const std::string limit = written(bound, c.unit);
  const bool passed = std::isfinite(found.value) && (below ? found.value < bound : found.value > bound);
  return {found, passed, bound, (below ? "< " : "> ") + limit, std::string("not ") + (below ? "below " : "above ")};
}

// Of a group every column must be near: the one farthest away counts.
Verdict judge_equality(const Analysis& a, const scenario::Check& c, const std::vector<document::Value>& values) {
  const double wanted = *c.equals;
  const Number high = measure(a, c, values, true), low = measure(a, c, values, false);
  const Number found = std::abs(low.value - wanted) > std::abs(high.value - wanted) ? low : high;
  const bool exact = c.within == 0;
  const std::string near = exact ? "" : written(c.within, c.unit);
  return {found, std::abs(found.value - wanted) <= c.within, wanted, "= " + written(wanted, c.unit) + (exact ? "" : " ± " + near),
          exact ? "not " : "not within " + near + " of "};
}

document::Check evaluate(const Analysis& a, const scenario::Check& c, const std::vector<document::Value>& values) {
  std::vector<Verdict> verdicts;
  if (c.below) verdicts.push_back(judge(a, c, values, *c.below, true));
  if (c.above) verdicts.push_back(judge(a, c, values, *c.above, false));
  if (c.equals) verdicts.push_back(judge_equality(a, c, values));
  document::Check out;
  out.line = c.line;
  out.unit = c.unit;
  out.passed = true;
  for (const Verdict& v : verdicts) {
    out.limit += (out.limit.empty() ? "" : ", ") + v.demand;
    out.passed = out.passed && v.passed;
    const bool complete = std::isfinite(v.found.value);
    const Apart told = show_apart(v.found.value, v.bound, c.unit, 6);
    if (out.measured.empty() || !v.passed) {
      out.value = v.found.value;
      out.bound = v.bound;
      out.measured = complete ? told.value : "no value";
    }
    if (v.passed) continue;
    if (!complete)
      out.message = c.that + " has no value: " + why_no_value(a, c);
    else
      out.message = fmt::format("{}{}: {} is {}, which is {}{}", v.found.sample >= 0 ? "t = " + show_time(a, v.found.sample) + ": " : "",
                                c.that, c.quantity.empty() ? v.found.column : "it", told.value, v.broken, told.beside);
  }
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
                             fmt::format("{} of {} samples", n.broken, a.samples()), sentences.empty() ? "" : sentences.front());
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

std::vector<document::Check> evaluate_checks(const Analysis& a, const std::vector<document::Value>& values) {
  std::vector<document::Check> out;
  for (const scenario::Check& c : a.scenario().checks) out.push_back(evaluate(a, c, values));

  if (!a.scenario().motion) return out;  // nothing moves: there is nothing to demand of it

  int broken = 0;
  for (const SampleRun& i : a.broken()) broken += i.last - i.first + 1;
  const int unreachable = a.count(Outcome::unreachable);
  const std::string of = fmt::format(" of {} samples", a.samples());
  const auto first = [](const std::vector<std::string>& sentences) { return sentences.empty() ? std::string() : sentences.front(); };
  out.push_back(demand("every sample can be assembled", unreachable, std::to_string(unreachable) + of, first(reach_sentences(a))));
  out.push_back(demand("strokes and joint limits are kept", broken, std::to_string(broken) + of, first(breach_sentences(a))));
  if (a.scenario().limits.any()) out.push_back(limits_kept(a));
  const int singular = singularities_met(a);
  out.push_back(demand("no singular surface is met", singular, plural(singular, "time"), first(singularity_sentences(a))));
  return out;
}

}  // namespace pmreport::section
