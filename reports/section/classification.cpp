// Section `classification`.
#include <reports/section/section.hpp>

namespace pmreport::section {

Result classification_section() { return {{"classification", "classification", "Classification", {}}, {}, {}, {}}; }

}  // namespace pmreport::section
