// Section `singularity`.
#include <reports/section/section.hpp>

namespace pmreport::section {

Result singularity_section(const Analysis&, const scenario::SectionRequest&, const Stage&, const Progress&) {
  return {{"singularity", "singularity", "Singularity", {}}, {}, {}, {}};
}

}  // namespace pmreport::section
