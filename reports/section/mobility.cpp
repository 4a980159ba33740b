// Section `mobility`.
#include <reports/section/section.hpp>

namespace pmreport::section {

Result mobility_section(const Analysis&, const scenario::SectionRequest&) { return {{"mobility", "mobility", "Mobility", {}}, {}, {}, {}}; }

}  // namespace pmreport::section
