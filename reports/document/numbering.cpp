#include <reports/document/numbering.hpp>

namespace pmreport::document {

Numbering numbering_of(const Report& r) {
  Numbering n;
  int figures = 0, tables = 0;
  for (const Section& s : r.sections) {
    n.sections.push_back(std::to_string(n.sections.size() + 1));
    std::vector<int>& numbers = n.blocks.emplace_back();
    for (const Block& block : s.blocks) {
      const auto* gallery = std::get_if<Gallery>(&block);
      if (std::holds_alternative<figure::Figure>(block) || (gallery != nullptr && !gallery->pictures.empty())) {
        numbers.push_back(++figures);
      } else {
        numbers.push_back(std::holds_alternative<Table>(block) ? ++tables : 0);
      }
    }
  }
  if (!r.checks.empty()) n.checks = std::to_string(n.sections.size() + 1);
  n.scenario = "A";
  if (!r.files.empty()) n.files = "B";
  return n;
}

std::string letter_of(std::size_t picture) {
  return picture < 26 ? std::string("(") + static_cast<char>('a' + picture) + ")" : "(" + std::to_string(picture + 1) + ")";
}

}  // namespace pmreport::document
