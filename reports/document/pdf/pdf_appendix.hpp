// What stands behind the report: the scenario as it was read, files for other programs, and the colophon.
#pragma once

#include <reports/document/pdf/pdf_attachments.hpp>
#include <reports/document/pdf/pdf_blocks.hpp>

namespace pmreport::document::pdf {

void put_listing(Composer& c, const std::string& text);
void put_files(Composer& c);  // what lies beside the report for other programs

// What made the report, and what is attached to it, small, at its very end; links to `destination` lead here.
void put_colophon(Composer& c, const Provenance& p, const Attachments& attached, const std::string& destination);

}  // namespace pmreport::document::pdf
