// The best variant within bounds and constraints.
#include <reports/section/study/study.hpp>

#include <reports/section/common/words/words.hpp>
#include <reports/section/study/trial_data.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

namespace pmreport::section {

using analysis::Agreement;
using analysis::DesignConstraint;
using analysis::DesignProblem;
using analysis::Optimum;
using analysis::Trial;
using document::Evidence;
using document::Paragraph;
using document::Verdict;

namespace {

// What a study says of an optimum, from its parts.
struct Told {
  const StudyOptions& o;
  const DesignProblem& problem;
  const Optimum& found;

  const Trial& best() const { return found.trials[found.best ? *found.best : *found.nearest]; }
  std::size_t goal() const { return o.goals.front().measure; }
};

std::string at_bound(int side) { return side < 0 ? "at its lower end" : side > 0 ? "at its upper end" : "between its ends"; }

document::Table table_of_parameters(const Told& t) {
  const std::vector<int> sides = at_bounds(t.problem, t.best().values);
  document::Table out{t.found.best ? "Parameters of the best variant." : "Parameters of the variant that breaks the constraints least.",
                      {"parameter", "from", "to", "this scenario", t.found.best ? "best" : "nearest", "unit", ""},
                      {false, true, true, true, true, false, false},
                      {}};
  for (std::size_t i = 0; i < t.o.over.size(); ++i) {
    const StudiedParameter& p = t.o.over[i];
    const DisplayUnit unit = unit_of(p);
    const auto number = [&](double x) { return typeset(format_number(x * unit.per_si, 6)); };
    out.rows.push_back({p.name, number(p.from), number(p.to), number(p.own), number(t.best().values[i]), unit.label, at_bound(sides[i])});
  }
  return out;
}

document::Table table_of_numbers(const Told& t) {
  document::Table out{fmt::format("Numbers, of the scenario as it stands and of that variant; closer: {}.", closer_look(t.o)),
                      {"number", "this scenario", t.found.best ? "best" : "nearest", "closer", "unit", "change"},
                      {false, true, true, true, false, false},
                      {}};
  const Judged &own = t.found.own, &now = t.best().judged, &closer = t.found.confirmed;
  for (std::size_t n = 0; n < t.o.numbers.size(); ++n) {
    const DisplayUnit unit = unit_of(t.o, n, {&own, &now});
    out.rows.push_back({title_of(t.o, n), cell(own.numbers, n, unit), cell(now.numbers, n, unit), cell(closer.numbers, n, unit), unit.label,
                        own.made() ? change(now.numbers[n], own.numbers[n]) : "–"});
  }
  return out;
}

document::Table table_of_constraints(const Told& t) {
  document::Table out{"Constraints at that variant, each by the end of its bracket that is nearer to the bound.",
                      {"constraint", "slack", "unit", "", "slack, closer"},
                      {false, true, false, false, true},
                      {}};
  for (const DesignConstraint& c : t.o.constraints) {
    const double slack = c.slack(t.best().judged);
    const DisplayUnit unit = display_unit(t.o.numbers[c.measure].unit, std::abs(c.bound));
    const auto number = [&](double x) { return std::isfinite(x) ? typeset(format_number(x * unit.per_si, 4)) : std::string("–"); };
    const bool closer = c.measure < t.found.confirmed.numbers.size();
    out.rows.push_back({words_of(t.o, c), number(slack), unit.label,
                        slack < 0                    ? "broken"
                        : active(c, t.best().judged) ? "active"
                                                     : "not active",
                        closer ? number(c.slack(t.found.confirmed)) : "–"});
  }
  return out;
}

document::Table table_of_searches(const Told& t) {
  document::Table out{
      "Searches. What the library says of its end counts for nothing: the best is the best of all variants that were tried.",
      {"search", "variants", "best that it found", "at"},
      {false, true, true, false},
      {}};
  for (const analysis::SearchEnd* s : {&t.found.first, &t.found.second, &t.found.polish}) {
    if (s->count == 0) continue;
    const bool any = s->best.has_value();
    out.rows.push_back({s->how, std::to_string(s->count),
                        any ? with_unit(t.found.trials[*s->best].judged.numbers[t.goal()], t.o.numbers[t.goal()].unit) : "–",
                        any ? place_of(t.o, t.found.trials[*s->best].values) : "nothing that keeps the constraints"});
  }
  return out;
}

std::string agreement_words(const Told& t) {
  const Optimum& f = t.found;
  switch (f.agreement) {
    case Agreement::agree:
      return "Both searches end at the same variant.";
    case Agreement::flat:
      return "Both searches end at the same value, at different variants: the goal is flat there, or has two optima that are equally good.";
    case Agreement::different:
      return fmt::format("The two searches end at different optima, {} apart: the goal has several, and there may be a better one still.",
                         typeset(fmt::format("{:.2g} %", 100 * f.apart)));
    case Agreement::one_alone:
      return "Only one of the two searches found a variant that keeps the constraints.";
    case Agreement::neither:
      return "Neither search found a variant that keeps the constraints.";
  }
  return {};
}

std::string headline(const Told& t) {
  const StudiedNumber& n = t.o.numbers[t.goal()];
  const Bracketed& now = t.best().judged.numbers[t.goal()];
  std::string out = fmt::format("Of {} the best has a {} of {}, at {}", plural(static_cast<int>(t.found.trials.size()), "variant"), n.title,
                                with_unit(now, n.unit), place_of(t.o, t.best().values));
  if (!t.found.own.made()) return out + fmt::format("; the scenario as it stands has none: {}.", printable(t.found.own.why));
  const Bracketed& own = t.found.own.numbers[t.goal()];
  out += fmt::format("; the scenario as it stands has {} ({})", with_unit(own, n.unit), change(now, own));
  if (t.problem.usable(t.found.own) && !t.problem.feasible(t.found.own)) out += ", and breaks a constraint";
  if (!t.found.own_inside) out += ", and lies outside the ranges";
  return out + ". There is no proof that there is no better one.";
}

// Of the two searches; numbers that are not told apart have none.
double goal_gap(const Told& t) {
  const Bracketed &x = t.found.trials[*t.found.first.best].judged.numbers[t.goal()],
                  &y = t.found.trials[*t.found.second.best].judged.numbers[t.goal()];
  return relative_gap(x, y);
}

// What is broken by less than a grid leaves open is not decided.
Evidence constraints_kept(const Told& t, const std::string& claim, const std::string& how) {
  const Judged& closer = t.found.confirmed;
  const auto broken = [&](const DesignConstraint& c) { return c.slack(closer) < 0; };
  const auto is_open = [&](const DesignConstraint& c) { return -c.slack(closer) <= t.best().judged.numbers[c.measure].resolution; };
  std::vector<DesignConstraint> all;
  std::ranges::copy_if(t.o.constraints, std::back_inserter(all), broken);
  if (!all.empty() && std::ranges::all_of(all, is_open))
    return Evidence::without_value(Verdict::not_decided, claim, how,
                                   fmt::format("{} is broken by less than a step of the grid may make", words_of(t.o, all.front())));
  return {claim, how, violation(t.o.constraints, closer), 0, ""};
}

std::string within_a_sentence(std::string s) {
  s.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(s.front())));
  if (s.ends_with('.')) s.pop_back();
  return s;
}

std::vector<Evidence> evidence(const Told& t) {
  std::vector<Evidence> out;
  const std::string look = closer_look(t.o), kept = "the best variant keeps every constraint at a closer look",
                    same = "the numbers of the best variant are those that the search saw";
  const Judged& closer = t.found.confirmed;
  if (!t.problem.usable(closer)) {
    out.push_back(Evidence::not_examined(same, "by " + look, "the closer look gives no numbers: " + remark(closer)));
  } else {
    if (!t.o.constraints.empty()) out.push_back(constraints_kept(t, kept, "sum of violations, each of its bound; by " + look));
    out.push_back({same, "gap between the two brackets, of the value; by " + look, disagreement(t.o, t.best().judged, closer),
                   allowed_disagreement(t.o), ""});
  }
  const std::string claim = "a second search, from elsewhere, finds the same",
                    how = fmt::format("{}, and {}", t.found.first.how, t.found.second.how);
  if (t.found.agreement == Agreement::agree || t.found.agreement == Agreement::flat)
    out.push_back({claim, how + ": gap between the brackets of the goal, of its value", goal_gap(t), analysis::same_value, ""});
  else
    out.push_back(Evidence::without_value(Verdict::not_decided, claim, how, within_a_sentence(agreement_words(t))));
  return out;
}

void add_values(const Told& t, Result& out) {
  const auto add = [&](std::string name, const std::string& unit, double x) { out.values.push_back({"study", std::move(name), unit, x}); };
  const std::vector<const Judged*> all = judged_of(t.found.trials);
  add("variants", "", static_cast<double>(all.size()));
  add("failed", "", static_cast<double>(std::ranges::count_if(all, [](const Judged* j) { return !j->made(); })));
  if (!t.found.best) return;
  for (std::size_t n = 0; n < t.o.numbers.size(); ++n) {
    const Bracketed& x = t.best().judged.numbers[n];
    if (!x.known()) continue;
    add("best_" + t.o.numbers[n].own, t.o.numbers[n].unit, x.value);
    add("best_" + t.o.numbers[n].own + "_low", t.o.numbers[n].unit, x.low);
    add("best_" + t.o.numbers[n].own + "_high", t.o.numbers[n].unit, x.high);
  }
  for (std::size_t i = 0; i < t.o.over.size(); ++i) add("at_" + t.o.over[i].name, t.o.over[i].unit, t.best().values[i]);
  const Bracketed& now = t.best().judged.numbers[t.goal()];
  if (t.found.own.made() && t.found.own.numbers[t.goal()].known() && t.found.own.numbers[t.goal()].value != 0)
    add("gain", "", now.value / t.found.own.numbers[t.goal()].value - 1);
}

// The goal over the trials in their order, and the best so far.
figure::Figure course_of(const Told& t) {
  const DisplayUnit unit = unit_of(t.o, t.goal(), judged_of(t.found.trials));
  figure::Panel p;
  p.x = {"variant", ""};
  p.y = {label_of(t.o, t.goal()), unit.label};
  figure::Series kept{"keeps all constraints", {}, {}, 0, true}, broken{"breaks a constraint", {}, {}, 1, true},
      best{"best so far", {}, {}, 2};
  if (t.o.constraints.empty()) kept.label = "variant";
  std::optional<double> so_far;
  for (std::size_t k = 0; k < t.found.trials.size(); ++k) {
    const Judged& j = t.found.trials[k].judged;
    const auto x = static_cast<double>(k + 1);
    if (t.problem.usable(j)) {
      const double y = j.numbers[t.goal()].value;
      const bool feasible = t.problem.feasible(j);
      figure::Series& to = feasible ? kept : broken;
      to.x.push_back(x), to.y.push_back(y * unit.per_si);
      if (feasible && (!so_far || (t.o.goals.front().maximise ? y > *so_far : y < *so_far))) {
        if (so_far) best.x.push_back(x), best.y.push_back(*so_far * unit.per_si);
        so_far = y;
      }
    }
    if (so_far) best.x.push_back(x), best.y.push_back(*so_far * unit.per_si);
  }
  for (figure::Series* s : {&kept, &broken, &best})
    if (!s->x.empty()) p.series.push_back(std::move(*s));
  return {"study", "The goal at every variant that was tried, in the order of the trials.", "", figure::Width::full, 1, {std::move(p)}};
}

}  // namespace

void add_optimum(const Analysis& a, const StudyOptions& o, const Progress& progress, Result& out) {
  const DesignProblem problem = problem_of(a, o, progress);
  (void)judge_own(problem.judge, o, static_cast<std::size_t>(o.evaluations), progress);
  const Optimum found = analysis::optimise(problem, static_cast<std::size_t>(o.evaluations), progress);
  const Told t{o, problem, found};
  const std::vector<const Judged*> all = judged_of(found.trials);
  auto& blocks = out.section.blocks;
  const auto say = [&](Paragraph::Tone tone, std::string s) {
    if (!s.empty()) blocks.push_back(Paragraph{tone, std::move(s)});
  };
  std::vector<std::string> names, demands;
  for (const StudiedParameter& p : o.over) names.push_back(p.name);
  for (const DesignConstraint& c : o.constraints) demands.push_back(words_of(o, c));
  say(Paragraph::Tone::plain, fmt::format("Wanted: {}, over {}{}.", words_of(o, o.goals.front()), listed(names, "and"),
                                          demands.empty() ? "" : ", with " + listed(demands, "and")));
  const bool any = found.best || found.nearest;
  if (found.best)
    say(Paragraph::Tone::plain, headline(t));
  else
    say(Paragraph::Tone::warning, any ? fmt::format("None of {} keeps every constraint; that which comes nearest is told.",
                                                    plural(static_cast<int>(all.size()), "variant"))
                                      : fmt::format("None of {} could be judged.", plural(static_cast<int>(all.size()), "variant")));
  say(Paragraph::Tone::note, failures(all));
  say(Paragraph::Tone::note, cut_off(all));
  if (any) {
    if (found.best) say(Paragraph::Tone::plain, agreement_words(t));
    blocks.push_back(table_of_parameters(t));
    blocks.push_back(table_of_numbers(t));
    if (!o.constraints.empty()) blocks.push_back(table_of_constraints(t));
    blocks.push_back(table_of_searches(t));
    blocks.push_back(course_of(t));
  }
  if (found.best)
    blocks.push_back(document::Proof{evidence(t)});
  else
    blocks.push_back(document::Proof{{Evidence::not_examined("the best variant keeps every constraint at a closer look", closer_look(o),
                                                             "no variant that was tried keeps them all")}});
  out.data.push_back(data_of_trials(o, problem, found.trials));
  add_values(t, out);
}

}  // namespace pmreport::section
