#include <reports/section/overview.hpp>

#include <reports/section/kinds.hpp>

#include <fmt/format.h>

namespace pmreport::section {

std::vector<document::Section> overview_section(const Analysis& a) {
  figure::Figure f{"overview", "", "", figure::Width::full, 2, {}};
  std::vector<std::string> shown;
  for (const scenario::SectionKind* kind : kinds()) {
    const auto glance = static_cast<const SectionKind*>(kind)->glance;
    if (glance != nullptr && a.scenario().asks_for(*kind)) shown.push_back(glance(a, f));
  }
  if (shown.size() < 3) return {};
  f.caption = fmt::format("The motion at a glance: {}.", fmt::join(shown, "; "));
  return {document::Section{"overview", "overview", "Overview", {f}}};
}

}  // namespace pmreport::section
