// Evidence and numbers of a workspace.
#include <reports/section/workspace/workspace.hpp>

#include <core/analysis/workspace/answers.hpp>
#include <core/analysis/workspace/by_definition.hpp>
#include <core/text/text.hpp>
#include <reports/section/common/words/brackets.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using analysis::ScanMethod;
using document::Evidence;
using document::Verdict;

namespace {

constexpr int compared_poses = 2000;

Evidence outcome(bool passed, std::string claim, std::string how, std::string reason) {
  return Evidence::without_value(passed ? Verdict::passed : Verdict::failed, std::move(claim), std::move(how), std::move(reason));
}

void add_comparisons(const Workspace& w, std::vector<Evidence>& out) {
  if (!w.scan.orientations.empty()) return;
  if (w.proof && w.estimate) {
    const program::Bounds interval{w.scan.range() * w.estimate->low, w.scan.range() * w.estimate->high};
    const bool meet = interval.low <= w.proof->volume.high && w.proof->volume.low <= interval.high;
    out.push_back(outcome(meet, "Random poses confirm the proved volume",
                          "the 95 % interval against the proved bracket; one in twenty misses it",
                          fmt::format("{}; {}", show_bracket(interval, w.unit), show_bracket(w.proof->volume, w.unit))));
  }
  if (!w.grid) return;
  // The boundary runs through accepted cells that have a refused neighbour, and through as many refused ones.
  const std::uint64_t rim = analysis::rim_of(w, 1);
  const double cell = w.scan.cell(), measure = cell * static_cast<double>(w.grid->tally.accepted),
               slack = 2 * cell * static_cast<double>(rim);
  const auto hold = [&](const program::Bounds& b, const char* claim, const char* how) {
    // What a wrong count by a half would pass says nothing.
    if (slack > 0.5 * measure && b.high > 0) {
      out.push_back(Evidence::without_value(
          Verdict::not_decided, claim, how,
          fmt::format("{} of {} cells lie at the boundary: the grid is too coarse to tell", rim, w.grid->tally.accepted)));
      return;
    }
    out.push_back(outcome(measure - slack <= b.high && b.low <= measure + slack, claim, how,
                          fmt::format("{} with cells of {} at the boundary; {}", show_volume(measure, w.unit),
                                      show_volume(slack, w.unit, 3), show_bracket(b, w.unit))));
  };
  if (w.proof)
    hold(w.proof->volume, "The grid confirms the proved volume",
         "accepted cells against the proved bracket, apart by no more than the cells that the boundary runs through");
  if (w.estimate)
    hold({w.scan.range() * w.estimate->low, w.scan.range() * w.estimate->high}, "The grid confirms the random poses",
         "accepted cells against the 95 % interval, apart by no more than the cells that the boundary runs through");
}

}  // namespace

document::Proof workspace_proof(const Workspace& w, const mechanics::Machine& machine) {
  document::Proof out;
  const analysis::DefinitionCheck check = analysis::check_by_definition(w, machine, compared_poses);
  const std::string how =
      "the plugin's own placement and the limits as declared, against the recorded margins, at poses spread over the ranges";
  if (check.poses == 0)
    out.lines.push_back(Evidence::not_examined("Poses are accepted as the limits say", how, "no pose could be compared"));
  else
    out.lines.push_back(outcome(check.differing == 0, "Poses are accepted as the limits say", how,
                                check.differing == 0
                                    ? fmt::format("{} poses, {} of them accepted, and none differs", check.poses, check.accepted)
                                    : fmt::format("{} of {} poses differ, the first at {}", check.differing, check.poses, check.first)));
  if (!check.not_looked_at.empty())
    out.lines.push_back(Evidence::not_examined("Limits on indices, by other code", how,
                                               "there is no other code for " + listed(check.not_looked_at, "and")));
  if (w.proof && w.scan.orientations.empty()) {
    const std::string claim = "The volume is bracketed as narrowly as asked for",
                      means = w.margins.late > 0
                                  ? "relative width of the proved bracket; where forces enter the platform is taken as found at home "
                                    "and at random poses"
                                  : "relative width of the proved bracket";
    if (w.proof->empty || w.proof->enough)
      out.lines.push_back(outcome(true, claim, means, w.proof->empty ? "proved empty" : show_bracket(w.proof->volume, w.unit)));
    else
      out.lines.push_back(
          Evidence::without_value(Verdict::not_decided, claim, means, show_bracket(w.proof->volume, w.unit) + "; " + w.proof->why));
  }
  for (std::size_t i = 0; i < w.proof_at_least.size(); ++i) {
    const scan::ProvedVolume& p = w.proof_at_least[i];
    const std::string claim = fmt::format("The volume with at least {} orientations is bracketed as narrowly as asked for",
                                          w.request.at_least[i]),
                      means = "relative width of the proved bracket";
    if (p.empty || p.enough)
      out.lines.push_back(outcome(true, claim, means, p.empty ? "proved empty" : show_bracket(p.volume, w.unit)));
    else
      out.lines.push_back(Evidence::without_value(Verdict::not_decided, claim, means, show_bracket(p.volume, w.unit) + "; " + p.why));
  }
  if (w.request.safe && !(w.safe_box && w.safe_box->found) && w.home_inside) {
    const std::string why = !w.set.provable() ? analysis::unprovable(w) : w.safe_box ? w.safe_box->why : "no coordinate has a range";
    out.lines.push_back(Evidence::not_examined("A safe box around home", "every pose of it, by intervals", why));
  }
  if (!w.not_proved.empty())
    out.lines.push_back(Evidence::not_examined("A proved bracket of the volume", "boxes of poses, by intervals", w.not_proved));
  if (w.grid && w.grid->tally.on_a_limit > 0)
    out.lines.push_back(Evidence::without_value(Verdict::not_decided, "No pose of the grid lies on a limit", "a margin within its rounding",
                                                fmt::format("{} poses do, and count as accepted", w.grid->tally.on_a_limit)));
  else if (w.grid)
    out.lines.push_back(outcome(true, "No pose of the grid lies on a limit", "a margin within its rounding", "none of the poses"));
  add_comparisons(w, out.lines);
  return out;
}

std::vector<document::Value> workspace_values(const Workspace& w, const mechanics::Machine& machine, const WorkspaceOptions& options) {
  std::vector<document::Value> out;
  const std::string prefix = options.name.empty() ? "" : options.name + ".";
  const auto put = [&](const std::string& own, const std::string& unit, double x) { out.push_back({"workspace", prefix + own, unit, x}); };
  const auto number = [](std::uint64_t n) { return static_cast<double>(n); };
  const double cell = w.scan.cell();
  const auto points_at_least = [&](std::uint64_t n) { return number(analysis::points_with(w.grid->accepted_at, n)); };
  const analysis::WorkspaceAnswers answers(w);
  put("volume", w.unit, answers.volume().value);
  if (w.proof)
    put("volume_low", w.unit, w.proof->volume.low), put("volume_high", w.unit, w.proof->volume.high);
  else if (w.estimate)
    put("volume_low", w.unit, w.scan.range() * w.estimate->low), put("volume_high", w.unit, w.scan.range() * w.estimate->high);
  if (const scan::Tally* t = w.grid ? &w.grid->tally : w.estimate ? &w.estimate->tally : nullptr)
    put("poses", "", number(t->poses)), put("accepted", "", number(t->accepted)), put("on_a_limit", "", number(t->on_a_limit));
  if (w.grid) {
    put("points", "", points_at_least(1));
    put("parts", "", number(w.components->parts.size()));
    put("holes", "", number(w.components->holes.size()));
  }
  if (w.sheet) {
    put("on_the_sheet_of_home", "", number(w.sheet->poses)), put("connected", "", number(w.sheet->connected));
    put("positive_det", "", number(w.grid->positive)), put("negative_det", "", number(w.grid->negative));
  }
  for (std::size_t i = 0; i < w.request.at_least.size(); ++i) {
    const std::string n = std::to_string(w.request.at_least[i]);
    if (w.grid) put("points_with_at_least_" + n, "", points_at_least(w.request.at_least[i]));
    if (w.grid && !w.grid->by_others_at.empty())
      put("volume_at_least_" + n + "_by_other_limits", w.unit,
          cell * number(analysis::points_with(w.grid->by_others_at, w.request.at_least[i])));
    put("volume_at_least_" + n, w.unit,
        i < w.proof_at_least.size() ? w.proof_at_least[i].volume.middle()
        : w.grid                    ? cell * points_at_least(w.request.at_least[i])
                                    : std::nan(""));
  }
  for (std::size_t i = 0; i < w.scan.points.size(); ++i) {
    const Coordinate& c = machine.topology().coordinates[static_cast<std::size_t>(w.scan.points[i].input)];
    const analysis::Bracketed low = answers.end(i, false), high = answers.end(i, true);
    if (low.known()) put(c.name + "_low", c.unit, low.value), put(c.name + "_high", c.unit, high.value);
  }
  if (w.safe_box && w.safe_box->found)
    for (std::size_t i = 0; i < w.safe_axes.size(); ++i) {
      const Coordinate& c = machine.topology().coordinates[static_cast<std::size_t>(w.safe_axes[i].input)];
      put("safe_" + c.name + "_low", c.unit, w.safe_box->sides[i].low), put("safe_" + c.name + "_high", c.unit, w.safe_box->sides[i].high);
    }
  return out;
}

}  // namespace pmreport::section
