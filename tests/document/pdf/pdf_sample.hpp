// A report such as the sections of the program make, for the tests of the PDF.
#pragma once

#include <reports/document/report.hpp>

#include <string>

namespace sample {

// A PNG of a ball on a ground, transparent where nothing is.
std::string ball(int width, int height);

pmreport::figure::Figure plot(const std::string& id, int panels, int columns);

// `rows` by `columns` of figures, with headings "q1 [mm]", ... and cells "row.column".
pmreport::document::Table grid(int rows, int columns);

// Every kind of block, failing and passing claims, text that would be markup, a title in several scripts.
pmreport::document::Report full_report();

}  // namespace sample
