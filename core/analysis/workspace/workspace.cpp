#include <core/analysis/workspace/workspace.hpp>

#include <core/analysis/workspace/scan_of.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

namespace {

constexpr double most_poses = 1e11;                        // that a grid is begun with
constexpr std::size_t most_memory = std::size_t{2} << 30;  // [bytes] of what a grid keeps
constexpr double told_before = 60;                         // [s] a scan that takes longer is told with its estimate

bool asks(const WorkspaceRequest& r, ScanMethod m) { return std::ranges::find(r.methods, m) != r.methods.end(); }

// Its meaning is that of what decides a scan besides its set and its range: of what the late margins are made from, which are functions of
// the mechanism.
chunks::Work work_of(const Workspace& w, const mechanics::Machine& machine, const char* method) {
  chunks::Meaning m;
  m << machine.info().name;
  for (const std::vector<double>& values : machine.values()) {
    m << values.size();
    for (const double x : values) m << x;
  }
  for (const mechanics::PoseLimit& l : w.margins.limits) m << l.group << l.name << l.value << l.min << l.max;
  for (const mechanics::AskedLimit& asked : w.request.limits.asked)
    if (const auto* c = std::get_if<mechanics::AskedCompliance>(&asked.what)) m << c->drive_stiffness << c->horizontal;
  m << w.margins.late << w.margins.every << w.request.tool.has_value();
  if (w.request.tool)
    for (const double x : *w.request.tool) m << x;
  return {fmt::format("workspace {} {}", method, w.request.name), m.value()};
}

// A scan told by how far it is.
scan::Watch watch_of(const Progress& progress, std::string what) {
  scan::Watch out;
  out.done = [&progress, what](double share) { progress.say(fmt::format("{}: {:.0f} %", what, 100 * share)); };
  out.stop_if_asked = progress.stop_if_asked;
  return out;
}

void count_the_grid(Workspace& w, const mechanics::Machine& machine, const Progress& progress) {
  scan::GridOptions options;
  options.reasons = w.request.reasons;
  options.keep_poses = w.request.one_sheet;
  program::Program sign;
  if (w.request.one_sheet) {
    sign = mechanics::determinant_program(machine);
    if (w.tool) sign = w.tool->of_tool(sign);
    options.sign = &sign;
  }
  double poses = static_cast<double>(w.scan.orientation_count());
  for (const scan::Axis& a : w.scan.points) poses *= static_cast<double>(a.count);
  if (poses > most_poses)
    throw ScanTooLarge(
        fmt::format("the grid has {:.3g} poses, and at most {:.0e} are counted: give it fewer values, or use method = "
                    "\"proof\" or \"monte-carlo\"",
                    poses, most_poses));
  if (const std::size_t memory = scan::memory_needed(w.set, w.scan, options); memory > most_memory)
    throw ScanTooLarge(fmt::format("the grid would keep {} MiB, and {} MiB are allowed: give it fewer points{}", memory >> 20,
                                   most_memory >> 20, w.request.one_sheet ? ", or leave out one_sheet" : ""));
  if (const double seconds = scan::seconds_needed(w.set, w.scan, options); seconds > told_before)
    progress.say(fmt::format("workspace: {:.3g} poses, about {:.0f} min at most", poses, std::ceil(seconds / 60)));
  w.grid = scan::count_grid(w.set, w.scan, options, watch_of(progress, "workspace, grid"), work_of(w, machine, "grid"), progress.sharing);
  std::vector<std::size_t> counts;
  for (const scan::Axis& a : w.scan.points) counts.push_back(a.count);
  w.components = scan::components(counts, w.grid->accepted_at);
  if (!w.request.one_sheet) return;
  std::vector<std::size_t> turned;
  for (const ScanRange& r : w.request.orientations) turned.push_back(r.count);
  w.sheet = scan::sheet_of(counts, turned, *w.grid, nearest_to_home(w, machine));
}

void estimate_the_share(Workspace& w, const mechanics::Machine& machine, const Progress& progress) {
  const scan::MonteCarloOptions options{w.request.poses, w.request.seed, w.request.reasons};
  const std::size_t need = w.request.at_least.empty() ? 1 : static_cast<std::size_t>(w.request.at_least.front());
  w.estimate = scan::monte_carlo(w.set, w.scan, need, options, watch_of(progress, "workspace, Monte Carlo"),
                                 work_of(w, machine, "Monte Carlo"), progress.sharing);
}

void prove_volumes(Workspace& w, const mechanics::Machine& machine, const Progress& progress) {
  scan::VolumeOptions options;
  options.gap = w.request.gap, options.seconds = w.request.seconds;
  const auto proved = [&](const std::string& of) {
    return scan::prove_volume(w.set, w.scan, options, watch_of(progress, "workspace, proof" + of), work_of(w, machine, "proof"),
                              progress.sharing);
  };
  if (w.scan.orientations.empty()) {
    w.proof = proved("");
    return;
  }
  for (const std::uint64_t need : w.request.at_least) {
    options.need = static_cast<std::size_t>(need);
    w.proof_at_least.push_back(proved(fmt::format(", {}", need)));
  }
  w.proof = w.proof_at_least.front();
}

void prove(Workspace& w, const mechanics::Machine& machine, const Progress& progress) {
  w.not_proved = unprovable(w);
  if (!w.not_proved.empty()) return;
  try {
    prove_volumes(w, machine, progress);
  } catch (const program::ProgramError& e) {
    w.proof.reset(), w.proof_at_least.clear();
    w.not_proved = fmt::format("the limits are too long a program to be proved over so many coordinates: {}", e.what());
  }
}

void find_safe_poses(Workspace& w, const mechanics::Machine& machine, const Progress& progress) {
  if (!w.home_inside || !w.set.provable()) return;
  if (!w.request.orientation_list.empty()) {
    w.safe_box = scan::SafeBox{}, w.safe_box->why = "its orientations would be a list; ranges of them have a box";
    return;
  }
  scan::Scan around = w.scan;
  around.orientations.clear(), around.turned.clear();
  around.at = home_of(w, machine);
  for (const ScanRange& r : w.request.orientations) around.points.push_back({r.coordinate, r.from, r.to, r.count});
  std::erase_if(around.points, [](const scan::Axis& a) { return a.from == a.to; });
  std::vector<double> centre;
  scan::SafeOptions options;
  for (const scan::Axis& a : around.points) {
    const double at = around.at[static_cast<std::size_t>(a.input)], low = std::min(a.from, a.to), high = std::max(a.from, a.to);
    if (!(low < at && at < high)) {
      w.safe_box = scan::SafeBox{}, w.safe_box->why = "home lies outside the scanned range";
      return;
    }
    centre.push_back(at);
    options.proportions.push_back(0.5 * (high - low));
  }
  if (!w.request.proportions.empty()) options.proportions = w.request.proportions;
  if (centre.empty()) return;
  w.safe_axes = around.points;
  w.safe_proportions = options.proportions;
  try {
    w.safe_box = scan::safe_box(w.set, around, centre, options, watch_of(progress, "workspace, safe box"));
    w.safe_ball = scan::safe_ball(w.set, around, centre, options, watch_of(progress, "workspace, safe ball"));
  } catch (const program::ProgramError& e) {
    w.safe_box = scan::SafeBox{}, w.safe_ball.reset();
    w.safe_box->why = fmt::format("the limits are too long a program to be proved over so many coordinates: {}", e.what());
  }
}

}  // namespace

std::string unprovable(const Workspace& w) {
  if (w.set.provable()) return {};
  using Group = mechanics::PoseLimit::Group;
  const std::size_t size = w.margins.margins.size();
  std::vector<std::string> no_program, at_all_orientations;
  for (std::size_t m = size - w.margins.late; m < size; ++m) {
    const mechanics::PoseLimit& limit = w.margins.limits[static_cast<std::size_t>(w.margins.margins[m].limit)];
    const bool by_program = limit.group == Group::pressure || limit.group == Group::transmission;
    std::vector<std::string>& names = by_program ? at_all_orientations : no_program;
    if (by_program && m < size - w.margins.every) continue;
    if (names.empty() || names.back() != limit.name) names.push_back(limit.name);
  }
  if (!no_program.empty())
    return fmt::format("no proof looks at {}: readings, condition numbers and compliances are judged pose by pose",
                       listed(no_program, "and"));
  return fmt::format("no proof looks at {}: what all orientations of a point must keep is judged pose by pose",
                     listed(at_all_orientations, "and"));
}

Workspace workspace(const mechanics::Machine& machine, const WorkspaceRequest& request, const Progress& progress) {
  Workspace w;
  std::string why;
  if (request.tool && !(w.tool = mechanics::ToolPoint::of(machine, *request.tool, &why)))
    throw NoProgram("the workspace of a tool point cannot be scanned: " + why);
  const Eigen::VectorXd home = machine.home();
  w.request = completed(request, scanned_pose(w, {home.data(), static_cast<std::size_t>(home.size())}));
  const std::optional<mechanics::PoseMargins> margins = mechanics::pose_margins(machine, request.limits, &why);
  if (!margins) throw NoProgram("a workspace is scanned by the mechanism's recorded geometry, and there is none: " + why);
  w.margins = *margins;
  if (w.tool) {
    w.margins.program = w.tool->of_tool(w.margins.program);
    w.margins.judge_late = w.tool->of_tool(w.margins.judge_late);
    if (w.margins.late_over_boxes) w.margins.late_over_boxes = w.tool->of_tool(*w.margins.late_over_boxes);
  }
  w.set = set_of(w.margins);
  w.scan = scan_of(w.request, machine);
  w.unit = unit_of(w.scan, machine);
  judge_home(w, machine);
  progress.stop_if_asked();
  chunks::Attempts attempts;
  if (asks(w.request, ScanMethod::proof)) attempts.add([&] { prove(w, machine, progress); });
  if (asks(w.request, ScanMethod::grid)) attempts.add([&] { count_the_grid(w, machine, progress); });
  if (asks(w.request, ScanMethod::monte_carlo)) attempts.add([&] { estimate_the_share(w, machine, progress); });
  attempts.demand();
  chunks::leave_to_collector(progress.sharing);
  if (w.request.safe) find_safe_poses(w, machine, progress);
  return w;
}

}  // namespace pmreport::analysis
