// All kinds of sections.
#pragma once

#include <reports/section/kind.hpp>

#include <string>

namespace pmreport::section {

// In the order in which they are told. Every one is a section::SectionKind.
scenario::Kinds kinds();
const SectionKind& kind_of(const scenario::Section& section);  // whose kind is one of `kinds`, or another that can be made

// A Markdown table of kinds: what each shows, and its keys. README.md has it.
std::string kinds_as_markdown(scenario::Kinds kinds);

}  // namespace pmreport::section
