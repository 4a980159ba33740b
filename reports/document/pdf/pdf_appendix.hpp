// What stands behind the report: the scenario as it was read, and what made the report.
#pragma once

#include <reports/document/pdf/pdf_blocks.hpp>

namespace pmreport::document::pdf {

void put_listing(Composer& c, const std::string& text);
void put_provenance(Composer& c, const Provenance& p);
void put_files(Composer& c);  // what lies beside the report for other programs

}  // namespace pmreport::document::pdf
