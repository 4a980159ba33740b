// Section `assembly`.
#include <reports/section/section.hpp>

namespace pmreport::section {

Result assembly_section(const Analysis&, const scenario::SectionRequest&, const Stage&, const Progress&) {
  return {{"assembly", "assembly", "Assembly", {}}, {}, {}, {}};
}

}  // namespace pmreport::section
