// Section `drives`.
#include <reports/section/plots.hpp>
#include <reports/section/section.hpp>
#include <reports/section/words.hpp>

namespace pmreport::section {

Result drives_section(const Analysis& a) {
  document::Section s{"drives", "drives", "Drives", {}};
  s.blocks.push_back(extremes(a, "Extremes over the motion.", mechanics::columns_of("drives", a.machine().topology())));
  return {s, {}, {}, {}};
}

}  // namespace pmreport::section
