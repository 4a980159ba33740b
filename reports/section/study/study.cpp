// Section `study`: machines with other parameters, or other machines, beside one another.
#include <reports/section/study/study.hpp>

#include <reports/section/common/words/words.hpp>
#include <reports/section/study/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace pmreport::section {

namespace {

constexpr double told_from = 20;  // [s] a study that takes longer is told with its estimate

}  // namespace

analysis::MachineStudy study_of(const Analysis& a, const StudyOptions& o) {
  analysis::MachineStudy out = o.study;
  out.length = a.length();
  return out;
}

analysis::Judge judge_of(const Analysis& a, const StudyOptions& o, const analysis::MachineStudy& study, const Progress& progress) {
  std::vector<std::size_t> parameters;
  for (const StudiedParameter& p : o.over) parameters.push_back(p.index);
  return analysis::judge_of_parameters(a.machine(), std::move(parameters), study, progress);
}

analysis::DesignProblem problem_of(const Analysis& a, const StudyOptions& o, const Progress& progress) {
  analysis::DesignProblem out;
  for (const StudiedParameter& p : o.over) out.variables.push_back({p.name, p.from, p.to, p.own});
  out.goals = o.goals;
  out.constraints = o.constraints;
  const analysis::MachineStudy study = study_of(a, o);
  out.judge = judge_of(a, o, study, progress);
  out.confirm = judge_of(a, o, analysis::finer(study), progress);
  return out;
}

std::string method_words(const Analysis& a, const StudyOptions& o) {
  std::vector<std::string> out;
  if (!o.study.requests.empty())
    out.push_back(
        "Of every variant the workspace is found as the section \"workspace\" has it; coordinates that are held at home are held at the "
        "home of each.");
  const bool of_home = std::ranges::any_of(o.numbers, [](const StudiedNumber& n) { return !n.what.of_workspace(); });
  if (of_home)
    out.push_back(fmt::format("At home moments are taken over {}, the characteristic length of this scenario's machine, for all.",
                              show(a.length(), "m")));
  return fmt::format("{}", fmt::join(out, " "));
}

Judged judge_own(const analysis::Judge& judge, const StudyOptions& o, std::size_t variants, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> own;
  for (const StudiedParameter& p : o.over) own.push_back(p.own);
  const Clock::time_point start = Clock::now();
  Judged out = judge(own);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count() * static_cast<double>(variants);
  if (seconds > told_from) progress.say(fmt::format("study: {} variants, about {:.0f} min", variants, std::ceil(seconds / 60)));
  return out;
}

Result study_section(const Analysis& a, const StudyOptions& o, int number, const Progress& progress) {
  using Asked = StudyOptions::Asked;
  const std::string id = number == 1 ? "study" : fmt::format("study-{}", number);
  Result out{{id, "study", "Study", {}}, {}, {}, {}};
  switch (o.asked) {
    case Asked::sweep:
      out.section.title = "Study of parameters";
      add_sweep(a, o, progress, out);
      break;
    case Asked::variants:
      out.section.title = "Machines side by side";
      add_variants(a, o, progress, out);
      break;
    case Asked::optimise:
      out.section.title = "The best variant";
      add_optimum(a, o, progress, out);
      break;
    case Asked::pareto:
      out.section.title = "Between two goals";
      add_front(a, o, progress, out);
      break;
    case Asked::nothing:
      break;
  }
  // Behind the sentence that says what is asked, where there is one.
  if (std::string how = method_words(a, o); !how.empty() && !out.section.blocks.empty())
    out.section.blocks.insert(out.section.blocks.begin() + (o.asked == Asked::variants ? 0 : 1),
                              document::Paragraph{document::Paragraph::Tone::plain, std::move(how)});
  const std::string file = o.name.empty() ? id : "study-" + o.name;
  for (document::Data& d : out.data) d.name = file;
  for (document::Block& b : out.section.blocks)
    if (auto* f = std::get_if<figure::Figure>(&b)) f->id = file, f->data = "data/" + file + ".csv";
  for (document::Value& v : out.values)
    if (!o.name.empty()) v.name = o.name + "." + v.name;
  return out;
}

}  // namespace pmreport::section
