// The numbers of sections, figures and tables: the same wherever the report is read, so that "Table 7" means one thing.
#pragma once

#include <reports/document/report.hpp>

namespace pmreport::document {

struct Numbering {
  std::vector<std::string> sections;     // "1", in the order of the report's sections
  std::string checks, scenario, files;   // "12", "A", "B"; empty where the report has no such part
  std::vector<std::vector<int>> blocks;  // of every block of every section: among figures or among tables; 0: it has no number
};

// Figures are plots and galleries of pictures, which share one count; tables are those of results. Evidence and checks have none. The order
// of the parts: sections, checks, scenario, files, and the provenance as a colophon without a number.
Numbering numbering_of(const Report& r);

// "(a)" of the first of several pictures under one number.
std::string letter_of(std::size_t picture);

}  // namespace pmreport::document
