// Section `speed`.
#include <reports/section/plots.hpp>
#include <reports/section/section.hpp>
#include <reports/section/words.hpp>

namespace pmreport::section {

Result speed_section(const Analysis& a) {
  document::Section s{"speed", "speed", "Speed", {}};
  s.blocks.push_back(extremes(a, "Extremes over the motion.", mechanics::columns_of("speed", a.machine().topology())));
  return {s, {}, {}, {}};
}

}  // namespace pmreport::section
