#include <reports/section/classification/classification.hpp>

namespace pmreport::section {

namespace {

std::vector<scenario::Quantity> quantities(const scenario::Options*) {
  return {{"classification.by_rule", "", "schemes that the rule admits"},
          {"classification.base_schemes", "", "base schemes of Table 1"},
          {"classification.six_chains", "", "schemes with six chains of Table 2"}};
}

}  // namespace

const SectionKind& classification_kind() {
  static const SectionKind kind{
      {.name = "classification", .purpose = "the class of parallel-cross mechanisms", .needs = {.motion = false}, .quantities = quantities},
      [](const Context&, const scenario::Section&) { return classification_section(); }};
  return kind;
}

}  // namespace pmreport::section
