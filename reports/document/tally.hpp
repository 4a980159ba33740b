// How many of a report's promises were kept.
#pragma once

#include <reports/document/report.hpp>

namespace pmreport::document {

struct Tally {
  int total = 0, failed = 0, not_examined = 0;
};
Tally tally_checks(const Report& r);
Tally tally_evidence(const Section& s);
Tally tally_evidence(const Report& r);

}  // namespace pmreport::document
