#include <reports/section/workspace/motion_in_it.hpp>

#include <core/text/units.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <cmath>

namespace pmreport::section {

using document::Paragraph;

Drawn motion_in_workspace(const Analysis& a, const Workspace& w, const std::string& id) {
  Drawn out;
  if (!a.scenario().motion || a.samples() == 0) return out;
  const analysis::BoundaryDistance d = analysis::distance_to_boundary(w, a.machine(), a.trajectory(), a.length());
  if (d.nearest < 0) return out;
  const double least = d.distance[static_cast<std::size_t>(d.nearest)];
  const std::string limit = margin_words(w, d.margin[static_cast<std::size_t>(d.nearest)]), when = show_time(a, d.nearest);
  const std::string metric = w.margins.late > 0 ? " Readings and indices are left out." : "";
  if (least >= 0)
    out.blocks.emplace_back(
        Paragraph{Paragraph::Tone::plain,
                  fmt::format("At its samples the motion stays {} or more from the boundary, to first order, with angles counted "
                              "by arcs with a radius of {}; nearest at t = {}, to {}.{}",
                              show(least, "m"), show(a.length(), "m"), when, limit, metric)});
  else
    out.blocks.emplace_back(Paragraph{
        Paragraph::Tone::warning, fmt::format("The motion leaves the workspace: at t = {} it lies {} beyond {}, to first order.{}", when,
                                              show(-least, "m"), limit, metric)});
  const DisplayUnit unit = display_unit("m", std::abs(least) + 0.1);
  figure::Panel panel;
  panel.title = "distance to the boundary";
  panel.x = {"time", "s"};
  panel.y = {"distance", unit.label};
  figure::Series series{"", a.time(), {}};
  document::Data data{id + "-motion", {"limit", "t [s]", "distance [m]"}, {a.time(), d.distance}, {{}}};
  for (std::size_t k = 0; k < d.distance.size(); ++k) {
    series.y.push_back(d.distance[k] * unit.per_si);
    data.words[0].push_back(d.margin[k] < 0 ? "" : w.margins.margins[static_cast<std::size_t>(d.margin[k])].name);
  }
  panel.series.push_back(std::move(series));
  panel.lines.push_back({0, "boundary"});
  out.blocks.emplace_back(
      figure::Figure{id + "-motion",
                     "Distance of the motion's poses from the boundary of the workspace, to first order; negative: beyond.",
                     "data/" + id + "-motion.csv",
                     figure::Width::column,
                     1,
                     {std::move(panel)}});
  out.data.push_back(std::move(data));
  return out;
}

}  // namespace pmreport::section
