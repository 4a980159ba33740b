// The date in a PDF, without which two runs could not give the same bytes.
#pragma once

#include <string>

namespace pmreport::document::pdf {

// Stands where Cairo would write the time of day; it must be set as CAIRO_PDF_METADATA_CREATE_DATE.
extern const char* const placeholder_date;

// Seconds since 1970 from SOURCE_DATE_EPOCH, or -1 without one that makes sense.
long long source_date_epoch();

// Replaces the placeholder in a finished PDF by the date `epoch` [s since 1970], or by nothing when it is negative: a report without a date
// is better than one with a wrong date. The length stays, and with it every offset in the file.
void settle_date(std::string& pdf, long long epoch);

}  // namespace pmreport::document::pdf
