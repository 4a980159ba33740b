// Section `reactions`.
#include <reports/section/plots.hpp>
#include <reports/section/section.hpp>
#include <reports/section/words.hpp>

namespace pmreport::section {

Result reactions_section(const Analysis& a, const scenario::SectionRequest&) {
  document::Section s{"reactions", "reactions", "Reactions", {}};
  s.blocks.push_back(extremes(a, "Extremes over the motion.", mechanics::columns_of("reactions", a.machine().topology())));
  return {s, {}, {}, {}};
}

}  // namespace pmreport::section
