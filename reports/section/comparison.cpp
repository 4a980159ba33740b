// Section `comparison`.
#include <reports/section/section.hpp>

namespace pmreport::section {

Result comparison_section(const Analysis&, const scenario::SectionRequest&, const std::vector<document::Value>&) {
  return {{"comparison", "comparison", "Comparison", {}}, {}, {}, {}};
}

}  // namespace pmreport::section
