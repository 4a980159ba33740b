// The largest and the smallest number among variants, as far as they are told apart.
#pragma once

#include <reports/section/kind.hpp>
#include <reports/section/study/words.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::section {

// Index of the variant that has it, and of those whose brackets meet its own. None: no variant has the number.
struct ExtremeVariant {
  std::size_t index = 0;
  std::vector<std::size_t> alike;
};
std::optional<ExtremeVariant> extreme(const std::vector<const Judged*>& all, std::size_t number, bool largest);

// "The volume of the workspace is largest, 0.0123 m³, at ..., and smallest, ..., at ...; two others are not told apart from it."
// `where`: what is said of a variant, "at base_radius = 250 mm".
std::string extremes_sentence(const StudyOptions& o, std::size_t number, const std::vector<const Judged*>& all,
                              const std::function<std::string(std::size_t)>& where);

// variants, failed, and of each number its largest and smallest value, and that of each of the first `most` variants.
void add_values_of_variants(const StudyOptions& o, const std::vector<const Judged*>& all, std::size_t most, Result& out);

}  // namespace pmreport::section
