#include <reports/section/study/trial_data.hpp>

#include <reports/section/common/words/words.hpp>
#include <reports/section/study/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::section {

using analysis::ScanMethod;

namespace {

bool any_by(const StudyOptions& o, ScanMethod m) {
  return std::ranges::any_of(o.study.requests, [&](const analysis::WorkspaceRequest& r) { return r.methods.front() == m; });
}

}  // namespace

std::vector<const Judged*> judged_of(const std::vector<analysis::Trial>& trials) {
  std::vector<const Judged*> out;
  for (const analysis::Trial& t : trials) out.push_back(&t.judged);
  return out;
}

document::Data data_of_trials(const StudyOptions& o, const analysis::DesignProblem& problem, const std::vector<analysis::Trial>& trials) {
  document::Data out;
  out.headings = {"asked for by", "remark"};
  out.words.resize(2);
  for (const analysis::Trial& t : trials) {
    out.words[0].push_back(t.by);
    out.words[1].push_back(remark(t.judged));
  }
  for (std::size_t i = 0; i < o.over.size(); ++i) {
    out.headings.push_back(o.over[i].name + (o.over[i].unit.empty() ? "" : " [" + o.over[i].unit + "]"));
    out.columns.emplace_back();
    for (const analysis::Trial& t : trials) out.columns.back().push_back(t.values[i]);
  }
  add_columns(o, judged_of(trials), out);
  out.headings.push_back("feasible");
  out.columns.emplace_back();
  for (const analysis::Trial& t : trials) out.columns.back().push_back(problem.feasible(t.judged) ? 1 : 0);
  return out;
}

double relative_gap(const Bracketed& x, const Bracketed& y) {
  const double gap = std::max({0.0, x.low - y.high, y.low - x.high}) - x.resolution - y.resolution,
               size = std::max(std::abs(x.value), std::abs(y.value));
  return gap > 0 ? gap / size : 0.0;
}

double disagreement(const StudyOptions& o, const Judged& seen, const Judged& closer) {
  double out = 0;
  for (std::size_t n = 0; n < o.numbers.size(); ++n) {
    if (n >= seen.numbers.size() || n >= closer.numbers.size()) return std::numeric_limits<double>::quiet_NaN();
    const Bracketed &x = seen.numbers[n], &y = closer.numbers[n];
    if (!x.known() && !y.known()) continue;  // an end of an empty set, both times
    if (!x.known() || !y.known()) return std::numeric_limits<double>::quiet_NaN();
    out = std::max(out, relative_gap(x, y));
  }
  return out;
}

double allowed_disagreement(const StudyOptions& o) { return any_by(o, ScanMethod::monte_carlo) ? analysis::same_value : 0.0; }

std::string closer_look(const StudyOptions& o) {
  std::string out;
  const auto add = [&](const char* s) { out += (out.empty() ? "" : ", ") + std::string(s); };
  if (any_by(o, ScanMethod::proof)) add("a proof to a tenth of the gap");
  if (any_by(o, ScanMethod::grid)) add("a grid of half the steps");
  if (any_by(o, ScanMethod::monte_carlo)) add("four times as many random poses, others than before");
  return out.empty() ? "the same numbers once more" : out;
}

std::string words_of(const StudyOptions& o, const analysis::DesignConstraint& c) {
  return fmt::format("{} {} {}", title_of(o, c.measure), c.below ? "≤" : "≥", show(c.bound, o.numbers[c.measure].unit, 6));
}

std::string words_of(const StudyOptions& o, const analysis::DesignGoal& g) {
  return fmt::format("the {} as {} as possible", title_of(o, g.measure), g.maximise ? "large" : "small");
}

}  // namespace pmreport::section
