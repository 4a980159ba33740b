// Section `dynamics`.
#include <reports/section/plots.hpp>
#include <reports/section/section.hpp>
#include <reports/section/words.hpp>

namespace pmreport::section {

Result dynamics_section(const Analysis& a, const scenario::SectionRequest&) {
  document::Section s{"dynamics", "dynamics", "Dynamics", {}};
  s.blocks.push_back(extremes(a, "Extremes over the motion.", mechanics::columns_of("dynamics", a.machine().topology())));
  return {s, {}, {}, {}};
}

}  // namespace pmreport::section
