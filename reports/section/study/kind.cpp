#include <reports/section/study/keys.hpp>
#include <reports/section/study/study.hpp>

#include <core/scenario/section/keys.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::section {

namespace {

std::vector<scenario::Quantity> quantities(const scenario::Options* options) {
  using Asked = StudyOptions::Asked;
  const StudyOptions plain;
  const auto& o = options != nullptr ? static_cast<const StudyOptions&>(*options) : plain;
  const std::string prefix = "study." + (o.name.empty() ? "" : o.name + ".");
  std::vector<scenario::Quantity> out;
  const auto add = [&](const std::string& name, const std::string& unit, const std::string& title, bool count = false) {
    out.push_back({prefix + name, unit, title, count});
  };
  add("variants", "", "variants that were judged", true);
  add("failed", "", "variants that could not be made or judged", true);
  const bool best = o.asked == Asked::optimise, rows = o.asked == Asked::sweep || o.asked == Asked::variants;
  if (o.asked == Asked::pareto) add("points", "", "points of the front", true);
  for (const StudiedNumber& n : o.numbers) {
    if (best) {
      add("best_" + n.own, n.unit, n.title + ", best variant");
      add("best_" + n.own + "_low", n.unit, n.title + ", best variant, lower end of its bracket");
      add("best_" + n.own + "_high", n.unit, n.title + ", best variant, upper end of its bracket");
      continue;
    }
    add("largest_" + n.own, n.unit, "largest " + n.title);
    add("smallest_" + n.own, n.unit, "smallest " + n.title);
    if (!rows) continue;
    std::size_t count = 1;
    for (const StudiedParameter& p : o.over) count *= p.count;
    if (o.asked == Asked::variants) count = o.variants.size();
    for (std::size_t k = 1; k <= std::min(count, most_variants_told); ++k)
      add(fmt::format("{}_{}", n.own, k), n.unit, fmt::format("{}, variant {}", n.title, k));
  }
  if (!best) return out;
  for (const StudiedParameter& p : o.over) add("at_" + p.name, p.unit, p.name + " of the best variant");
  add("gain", "", "relative gain over the scenario as it stands");
  return out;
}

}  // namespace

const SectionKind& study_kind() {
  static const SectionKind kind{{.name = "study",
                                 .purpose = "what other parameters, or other machines, would give: sweeps, machines side by side, the best "
                                            "variant, fronts between two goals",
                                 .several = true,
                                 .keys = study_keys(),
                                 .needs = {.motion = false},
                                 .quantities = quantities,
                                 .make_options = scenario::plain_options<StudyOptions>,
                                 .complete = complete_study},
                                [](const Context& c, const scenario::Section& s) {
                                  return study_section(c.analysis, options_of<StudyOptions>(s), c.number, c.progress);
                                },
                                true};
  return kind;
}

}  // namespace pmreport::section
