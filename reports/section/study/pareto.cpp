// The best variants between two goals.
#include <reports/section/study/study.hpp>

#include <reports/section/common/words/words.hpp>
#include <reports/section/study/trial_data.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::section {

using analysis::DesignProblem;
using analysis::Front;
using analysis::FrontPoint;
using document::Evidence;
using document::Paragraph;

namespace {

document::Table table_of(const StudyOptions& o, const Front& f) {
  document::Table out{
      fmt::format("The front: no variant that was tried is better in one goal without being worse in the other. Numbers by {}.",
                  closer_look(o)),
      {""},
      {true},
      {}};
  std::vector<DisplayUnit> parameters, numbers;
  for (const StudiedParameter& p : o.over) {
    parameters.push_back(unit_of(p));
    out.headings.push_back(heading(p.name, parameters.back())), out.numeric.push_back(true);
  }
  std::vector<const Judged*> all;
  for (const FrontPoint& p : f.points) all.push_back(&p.confirmed);
  for (std::size_t n = 0; n < o.numbers.size(); ++n) {
    numbers.push_back(unit_of(o, n, all));
    out.headings.push_back(heading(label_of(o, n), numbers.back())), out.numeric.push_back(true);
  }
  for (std::size_t k = 0; k < f.points.size(); ++k) {
    std::vector<std::string> row{std::to_string(k + 1)};
    const std::vector<double>& values = f.trials[f.points[k].trial].values;
    for (std::size_t i = 0; i < o.over.size(); ++i) row.push_back(typeset(format_number(values[i] * parameters[i].per_si, 6)));
    for (std::size_t n = 0; n < o.numbers.size(); ++n) row.push_back(cell(f.points[k].confirmed.numbers, n, numbers[n]));
    out.rows.push_back(std::move(row));
  }
  return out;
}

figure::Figure figure_of(const StudyOptions& o, const DesignProblem& problem, const Front& f) {
  const std::size_t across = o.goals[0].measure, up = o.goals[1].measure;
  const std::vector<const Judged*> all = judged_of(f.trials);
  const DisplayUnit x = unit_of(o, across, all), y = unit_of(o, up, all);
  figure::Panel p;
  p.x = {label_of(o, across), x.label};
  p.y = {label_of(o, up), y.label};
  figure::Series front{"front", {}, {}, 0}, marks{"", {}, {}, 0, true}, tried{"tried", {}, {}, 8, true},
      own{"this scenario", {}, {}, 3, true};
  const auto add = [&](figure::Series& to, const Judged& j) {
    to.x.push_back(j.numbers[across].value * x.per_si), to.y.push_back(j.numbers[up].value * y.per_si);
  };
  for (const analysis::Trial& t : f.trials)
    if (problem.feasible(t.judged)) add(tried, t.judged);
  for (const FrontPoint& q : f.points) add(front, f.trials[q.trial].judged), add(marks, f.trials[q.trial].judged);
  if (problem.usable(f.own)) add(own, f.own);
  for (figure::Series* s : {&tried, &front, &marks, &own})
    if (!s->x.empty()) p.series.push_back(std::move(*s));
  return {"study",
          fmt::format("Wanted: {}, and {}. Every variant that was tried and keeps all constraints, and the front between them.",
                      words_of(o, o.goals[0]), words_of(o, o.goals[1])),
          "",
          figure::Width::full,
          1,
          {std::move(p)}};
}

void add_values(const StudyOptions& o, const Front& f, Result& out) {
  const auto add = [&](std::string name, const std::string& unit, double x) { out.values.push_back({"study", std::move(name), unit, x}); };
  add("variants", "", static_cast<double>(f.trials.size()));
  add("failed", "", static_cast<double>(std::ranges::count_if(f.trials, [](const analysis::Trial& t) { return !t.judged.made(); })));
  add("points", "", static_cast<double>(f.points.size()));
  for (std::size_t n = 0; n < o.numbers.size(); ++n) {
    const StudiedNumber& number = o.numbers[n];
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const FrontPoint& p : f.points)
      if (p.confirmed.numbers[n].known())
        low = std::min(low, p.confirmed.numbers[n].value), high = std::max(high, p.confirmed.numbers[n].value);
    if (low > high) continue;
    add("largest_" + number.own, number.unit, high);
    add("smallest_" + number.own, number.unit, low);
  }
}

}  // namespace

void add_front(const Analysis& a, const StudyOptions& o, const Progress& progress, Result& out) {
  const DesignProblem problem = problem_of(a, o, progress);
  (void)judge_own(problem.judge, o, static_cast<std::size_t>(o.evaluations), progress);
  const Front f = analysis::front(problem, static_cast<std::size_t>(o.points), static_cast<std::size_t>(o.evaluations), progress);
  const std::vector<const Judged*> all = judged_of(f.trials);
  auto& blocks = out.section.blocks;
  const auto say = [&](Paragraph::Tone tone, std::string s) {
    if (!s.empty()) blocks.push_back(Paragraph{tone, std::move(s)});
  };
  std::vector<std::string> names, demands;
  for (const StudiedParameter& p : o.over) names.push_back(p.name);
  for (const analysis::DesignConstraint& c : o.constraints) demands.push_back(words_of(o, c));
  say(Paragraph::Tone::plain, fmt::format("Wanted: {}, and {}, over {}{}.", words_of(o, o.goals[0]), words_of(o, o.goals[1]),
                                          listed(names, "and"), demands.empty() ? "" : ", with " + listed(demands, "and")));
  if (f.points.empty())
    say(Paragraph::Tone::warning, fmt::format("None of {} {}.", plural(static_cast<int>(all.size()), "variant"),
                                              f.nearest ? "keeps every constraint" : "could be judged"));
  else if (f.points.size() == 1)
    say(Paragraph::Tone::plain, "One variant is the best in both goals: they do not work against each other here.");
  if (f.dominated > 0)
    say(Paragraph::Tone::plain, fmt::format("Of {} {} dominated by others, which are as good in both goals and better in one.",
                                            plural(static_cast<int>(all.size()), "variant"),
                                            f.dominated == 1 ? std::string("1 is") : fmt::format("{} are", f.dominated)));
  if (f.dropped > 0)
    say(Paragraph::Tone::note, fmt::format("{} fell behind another, or broke a constraint, at the closer look, and left the front.",
                                           plural(static_cast<int>(f.dropped), "point")));
  say(Paragraph::Tone::note, failures(all));
  say(Paragraph::Tone::note, cut_off(all));
  if (!f.points.empty()) {
    blocks.push_back(figure_of(o, problem, f));
    blocks.push_back(table_of(o, f));
    double worst = 0;
    for (const FrontPoint& p : f.points) worst = std::max(worst, disagreement(o, f.trials[p.trial].judged, p.confirmed));
    blocks.push_back(document::Proof{
        {{"the numbers of every point of the front are those that the search saw",
          "largest gap between the two brackets, of the value; by " + closer_look(o), worst, allowed_disagreement(o), ""}}});
  } else {
    blocks.push_back(document::Proof{{Evidence::not_examined("the numbers of every point of the front are those that the search saw",
                                                             closer_look(o), "there is no front")}});
  }
  out.data.push_back(data_of_trials(o, problem, f.trials));
  add_values(o, f, out);
}

}  // namespace pmreport::section
