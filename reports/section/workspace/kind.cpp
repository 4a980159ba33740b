#include <reports/section/workspace/keys.hpp>
#include <reports/section/workspace/workspace.hpp>

#include <core/scenario/section/keys.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::section {

namespace {

using analysis::ScanMethod;
using O = WorkspaceOptions;

std::vector<scenario::Quantity> quantities(const scenario::Options* plain) {
  // Of options that are not known: those of a section over three lengths, asked by every method.
  O any;
  any.unit = "m^3";
  any.scanned = any.safe_scanned = {"x", "y", "z"};
  any.request.methods = {ScanMethod::proof, ScanMethod::grid, ScanMethod::monte_carlo};
  const O& o = plain != nullptr ? static_cast<const O&>(*plain) : any;
  const auto asks = [&](ScanMethod m) { return std::ranges::find(o.request.methods, m) != o.request.methods.end(); };
  const std::string& unit = o.unit;
  std::vector<scenario::Quantity> out;
  const auto add = [&](const std::string& own, const std::string& of, const std::string& title, bool count = false) {
    out.push_back({quantity_name(o, own), of, title, count});
  };
  add("volume", unit, "volume of the workspace");
  if (asks(ScanMethod::proof) || asks(ScanMethod::monte_carlo)) {
    add("volume_low", unit, "least that it can be, by the method");
    add("volume_high", unit, "most that it can be, by the method");
  }
  if (asks(ScanMethod::grid) || asks(ScanMethod::monte_carlo)) {
    add("poses", "", "poses that were looked at", true);
    add("accepted", "", "accepted poses", true);
    add("on_a_limit", "", "poses so near a limit that rounding decides", true);
  }
  if (asks(ScanMethod::grid)) {
    add("points", "", "points of the grid with an accepted orientation", true);
    add("parts", "", "separate parts", true);
    add("holes", "", "holes", true);
  }
  if (o.request.one_sheet) {
    add("on_the_sheet_of_home", "", "accepted poses that home is connected with on its side of every singular surface", true);
    add("connected", "", "accepted poses that home is connected with", true);
    add("positive_det", "", "accepted poses at which det G is positive", true);
    add("negative_det", "", "accepted poses at which det G is negative", true);
  }
  for (const std::uint64_t n : o.request.at_least) {
    const std::string text = std::to_string(n);
    add("volume_at_least_" + text, unit, "volume with at least " + text + " orientations");
    if (asks(ScanMethod::grid) && std::ranges::any_of(o.request.limits.asked, &mechanics::AskedLimit::every))
      add("volume_at_least_" + text + "_by_other_limits", unit,
          "volume with at least " + text + " orientations, without the limits that must hold at every one");
    if (asks(ScanMethod::grid)) add("points_with_at_least_" + text, "", "points with at least " + text + " orientations", true);
  }
  for (std::size_t i = 0; i < o.scanned.size(); ++i) {
    const std::string of = !o.units.empty() ? o.units[i] : "m";
    add(o.scanned[i] + "_low", of, "least " + o.scanned[i] + " of the workspace");
    add(o.scanned[i] + "_high", of, "most " + o.scanned[i] + " of the workspace");
  }
  for (std::size_t i = 0; i < o.safe_scanned.size(); ++i) {
    const std::string of = !o.safe_units.empty() ? o.safe_units[i] : "m";
    add("safe_" + o.safe_scanned[i] + "_low", of, "least " + o.safe_scanned[i] + " of the safe box");
    add("safe_" + o.safe_scanned[i] + "_high", of, "most " + o.safe_scanned[i] + " of the safe box");
  }
  return out;
}

// A grid counts at every point, and keeps three bits of every pose where its sheets are told; surface and slices are drawn of its points.
MemoryNeed::Part memory_of(const O& o, bool first) {
  constexpr double of_point = 8, of_pose = 3.0 / 8, of_any = 280e6;  // programs of its limits, boxes that are looked at again, surfaces
  const bool grid = std::ranges::find(o.request.methods, ScanMethod::grid) != o.request.methods.end();
  double points = 1, orientations = std::max<double>(1, static_cast<double>(o.request.orientation_list.size()));
  for (const analysis::ScanRange& range : o.request.scan) points *= static_cast<double>(std::max<std::size_t>(1, range.count));
  for (const analysis::ScanRange& range : o.request.orientations) orientations *= static_cast<double>(range.count);
  const double poses = o.request.one_sheet ? points * orientations : 0;
  return {(grid ? points * of_point + poses * of_pose : 0) + (first ? of_any : 0),
          grid ? fmt::format("a workspace of {:.4g} points, {:.4g} orientations each", points, orientations) : "a workspace",
          grid ? "fewer values on its axes" : ""};
}

}  // namespace

const SectionKind& workspace_kind() {
  static const SectionKind kind{
      {.name = "workspace",
       .purpose = "where the mechanism reaches: volume, proved or counted, what limits it, holes, slices, and limits for a controller",
       .several = true,
       .keys = workspace_keys(),
       .needs = {.motion = false, .pictures = true},
       .quantities = quantities,
       .make_options = scenario::plain_options<O>,
       .complete = complete_workspace},
      [](const Context& c, const scenario::Section& s) { return workspace_section(c, options_of<O>(s)); },
      true,
      [](const scenario::Loaded&, const scenario::Section& s, bool first) { return memory_of(options_of<O>(s), first); }};
  return kind;
}

}  // namespace pmreport::section
