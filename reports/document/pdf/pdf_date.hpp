// The date in a PDF: never the time of day, without which two runs could not give the same bytes.
#pragma once

#include <string>

namespace pmreport::document::pdf {

// Seconds since 1970 from SOURCE_DATE_EPOCH, or -1 without one that makes sense.
long long source_date_epoch();

// "D:20231114221320Z"; `epoch` [s since 1970] lies before the year 10000.
std::string pdf_date(long long epoch);

// "2023-11-14T22:13:20Z", as XMP wants it.
std::string iso_date(long long epoch);

}  // namespace pmreport::document::pdf
