// The first page: what the report is about, how it ended, what is where.
#pragma once

#include <reports/document/pdf/pdf_blocks.hpp>

#include <string>
#include <vector>

namespace pmreport::document::pdf {

struct Entry {  // of the contents and the outline
  std::string number, title, destination;
};

// `sections` are the entries of the report's sections, in their order; `checks` that of its checks.
void put_title(Composer& c, const std::vector<Entry>& sections, const Entry& checks);
void put_contents(Composer& c, const std::vector<Entry>& entries);

}  // namespace pmreport::document::pdf
