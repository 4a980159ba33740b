// The gates of a report.
#include <reports/section/checks.hpp>
#include <reports/section/common/limits.hpp>
#include <reports/section/common/singular_words.hpp>
#include <reports/section/common/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pmreport::section {

namespace {

document::Check evaluate(const Analysis& a, const scenario::Check& c, const std::vector<document::Value>& values) {
  document::Check out;
  out.line = c.line;
  out.unit = c.unit;
  out.passed = true;
  const auto judge = [&](double bound, bool below) {
    const Number f = measure(a, c, values, below);
    const bool complete = std::isfinite(f.value), passed = complete && (below ? f.value < bound : f.value > bound);
    out.passed = out.passed && passed;
    if (!out.limit.empty()) out.limit += ", ";
    out.limit += (below ? "< " : "> ") + show(bound, c.unit, 6);
    if (out.measured.empty() || !passed) {
      out.value = f.value;
      out.bound = bound;
      out.measured = complete ? show(f.value, c.unit, 6) : "no value";
    }
    if (passed) return;
    if (!complete)
      out.message = c.quantity.empty() ? "a column has no value to judge: no sample of it could be computed"
                                       : c.that + " has no value: its section could not compute it";
    else
      out.message =
          fmt::format("{}{}: {} is {}, which is not {} {}", f.sample >= 0 ? "t = " + show_time(a, f.sample) + ": " : "", c.that,
                      c.quantity.empty() ? f.column : "it", show(f.value, c.unit, 6), below ? "below" : "above", show(bound, c.unit, 6));
  };
  if (c.below) judge(*c.below, true);
  if (c.above) judge(*c.above, false);
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
  out.push_back(demand("strokes and joint limits are kept", broken, std::to_string(broken) + of,
                       a.breaches().empty() ? "" : sentence(a, a.breaches().front())));
  if (a.scenario().limits.any()) out.push_back(limits_kept(a));
  const int singular = singularities_met(a);
  out.push_back(demand("no singular surface is met", singular, plural(singular, "time"), first(singularity_sentences(a))));
  return out;
}

}  // namespace pmreport::section
