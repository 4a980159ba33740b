#include <reports/section/transmission/transmission.hpp>

#include <reports/section/common/plots.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;

namespace {

// What the motion's worst is, for hurried readers too.
std::string worst_words(const Analysis& a) {
  const ColumnId local = column_of(OfMachine::local_transmission), cosine = column_of(OfMachine::least_cosine);
  const bool by_local = a.has(local);
  if (!by_local && !a.has(cosine)) return "";
  const ColumnId column = by_local ? local : cosine;
  const WorstSample least = extreme_of(a, {{column, ""}});
  if (least.sample < 0) return "";
  const auto known = std::ranges::count_if(a.column(column), [](double x) { return std::isfinite(x); });
  const auto below = std::ranges::count_if(a.column(column), [](double x) { return x < analysis::good_transmission; });
  return fmt::format("{} is {} at least, at t = {}; it is {}.",
                     by_local ? "The local transmission index" : "The least cosine of a pressure angle",
                     typeset(format_number(least.value, 3)), show_time(a, least.sample),
                     below > 0              ? fmt::format("below 0.7 at {} of {} samples", below, a.samples())
                     : known == a.samples() ? std::string("0.7 or more along the whole motion")
                                            : fmt::format("0.7 or more at all {} of {} samples that have it", known, a.samples()));
}

}  // namespace

Result transmission_section(const Context& c, const TransmissionOptions& r) {
  const Analysis& a = c.analysis;
  Result out;
  document::Section& s = out.section = {"transmission", "transmission", "Transmission", {}};
  const auto tell = [&](const std::string& text, Paragraph::Tone tone = Paragraph::Tone::plain) {
    if (!text.empty()) s.blocks.push_back(Paragraph{tone, text});
  };
  const bool moves = a.samples() > 0;
  const std::string worst = moves ? worst_words(a) : "";
  tell(worst);
  if (!worst.empty()) out.findings.push_back({document::Finding::Kind::result, worst});
  if (moves) {
    s.blocks.push_back(transmission_figure(a));
    s.blocks.push_back(transmission_worst(a));
    const auto least = [&](const char* group_name, bool largest = false) {
      return extreme_of(a, group(a, analysis::transmission_columns, group_name), largest).value;
    };
    for (const auto& [name, group_name] : {std::pair{"least_output", "output_transmission"},
                                           {"least_input", "input_transmission"},
                                           {"least_constraint", "constraint_transmission"},
                                           {"least_local", "local_transmission"},
                                           {"least_conditioning", "local_conditioning"}})
      out.values.push_back({"transmission", name, "", least(group_name)});
    out.values.push_back({"transmission", "least_cosine", "", std::cos(least("pressure_angle", true))});
  }
  c.progress.stop_if_asked();
  if (!r.poses.empty()) {
    PosesOfTransmission poses = transmission_poses(a, r.poses);
    for (const std::string& text : poses.refused) tell(text, Paragraph::Tone::warning);
    if (!poses.table.rows.empty()) s.blocks.push_back(std::move(poses.table)), out.data.push_back(std::move(poses.data));
    std::ranges::move(poses.values, std::back_inserter(out.values));
  }
  if (r.map) {
    MapOfTransmission map = transmission_map(a, *r.map);
    tell(map.told);
    s.blocks.push_back(std::move(map.drawn.figure));
    out.data.push_back(std::move(map.drawn.data));
    std::ranges::move(map.values, std::back_inserter(out.values));
  }
  c.progress.stop_if_asked();
  if (r.grid) {
    GridOfTransmission grid = transmission_over_grid(a, *r.grid);
    if (grid.table) s.blocks.push_back(std::move(*grid.table));
    tell(grid.told, Paragraph::Tone::warning);
    std::ranges::move(grid.values, std::back_inserter(out.values));
  }
  std::ranges::move(transmission_definitions(a), std::back_inserter(s.blocks));
  s.blocks.push_back(transmission_proof(a, r));
  return out;
}

}  // namespace pmreport::section
