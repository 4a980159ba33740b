// What is drawn outside of all marks becomes an artifact, as PDF calls decoration: running titles, rules, repeated headings of tables.
#pragma once

#include <qpdf/QPDF.hh>

#include <string>

namespace pmreport::document::pdf {

// The content of a page in which all that paints belongs to an element of the structure or to an artifact.
std::string with_artifacts(const std::string& content);

void mark_decoration(QPDF& pdf, QPDFObjectHandle page);

}  // namespace pmreport::document::pdf
