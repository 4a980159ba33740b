#include <core/analysis/design/machine_numbers.hpp>

#include <core/analysis/workspace/answers.hpp>
#include <core/mechanics/singularity/singularity.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace pmreport::analysis {

namespace {

using What = MachineNumber::What;

std::optional<mechanics::Conditioning> at_home(const mechanics::Machine& m, double length) {
  const mechanics::Jacobian g = m.jacobian(m.home_pose());
  return g.known() ? std::optional(mechanics::conditioning(m, g.matrix, length)) : std::nullopt;
}

}  // namespace

Judged judge(const mechanics::Machine& machine, const MachineStudy& study, const Progress& progress) {
  Judged out;
  const Progress quiet{[](const std::string&) {}, progress.stop_if_asked};
  std::map<std::size_t, Workspace> done;
  for (const MachineNumber& n : study.numbers) {
    if (!n.of_workspace() || done.contains(n.workspace)) continue;
    WorkspaceRequest request = study.requests[n.workspace];
    // The volume alone is asked for; what ends by the clock would differ from run to run.
    request.safe = request.reasons = request.one_sheet = false;
    request.seconds = std::numeric_limits<double>::infinity();
    try {
      done.emplace(n.workspace, workspace(machine, request, quiet));
    } catch (const NoProgram& e) {
      return {{}, e.what()};
    } catch (const ScanTooLarge& e) {
      return {{}, e.what()};
    }
  }
  const std::optional<mechanics::Conditioning> home = at_home(machine, study.length);
  for (const MachineNumber& n : study.numbers) {
    if (n.what == What::condition || n.what == What::smallest_singular_value) {
      out.numbers.push_back(!home ? Bracketed{} : Bracketed::plain(n.what == What::condition ? home->condition() : home->smallest));
      continue;
    }
    const WorkspaceAnswers a(done.at(n.workspace));
    if (!a.any()) return {{}, done.at(n.workspace).not_proved};
    out.numbers.push_back(n.what == What::volume ? a.volume() : a.end(n.axis, n.what == What::high));
  }
  const auto note = [&](std::string s) {
    if (std::ranges::find(out.notes, s) == out.notes.end()) out.notes.push_back(std::move(s));
  };
  for (const auto& [index, w] : done) {
    const WorkspaceAnswers a(w);
    if (a.empty()) note(w.home_refused_by.empty() ? "empty" : fmt::format("empty; home is refused by {}", w.home_refused_by));
    if (const std::vector<std::string> cut = a.cut_off(machine.topology()); !cut.empty())
      note(fmt::format("may go on beyond the range of {}", listed(cut, "and"))), out.cut_off = true;
    if (a.ended_early()) note(fmt::format("the proof ended early: {}", w.proof->why));
  }
  return out;
}

MachineStudy finer(MachineStudy study) {
  for (WorkspaceRequest& r : study.requests) {
    r.gap /= 10;
    for (ScanRange& range : r.scan)
      if (range.count > 1) range.count = 2 * range.count - 1;
    r.poses *= 4;
    ++r.seed;
  }
  return study;
}

Judge judge_of_parameters(const mechanics::Machine& machine, std::vector<std::size_t> parameters, MachineStudy study,
                          const Progress& progress) {
  return [&machine, &progress, parameters = std::move(parameters), study = std::move(study)](const std::vector<double>& values) -> Judged {
    mechanics::ParameterValues all = machine.values();
    for (std::size_t i = 0; i < parameters.size(); ++i) all[parameters[i]] = {values[i]};
    try {
      return judge(*machine.with(std::move(all)), study, progress);
    } catch (const mechanics::MechanismError& e) {
      if (e.status != PM_BAD_ARGUMENT) throw;
      return {{}, e.what()};
    }
  };
}

}  // namespace pmreport::analysis
