#include <reports/document/finding.hpp>

#include <reports/document/quantity.hpp>

#include <cmath>

namespace pmreport::document {

namespace {

std::string reason_of(const Evidence& e) {
  return (e.examined ? "has no value: " : "not examined: ") + (e.reason.empty() ? "nothing could be compared" : e.reason);
}

}  // namespace

std::string finding(const Evidence& e) {
  if (!e.examined) return reason_of(e);
  const std::string tolerance = "tolerance " + rounded(e.tolerance, e.unit);
  return std::isfinite(e.value) ? "measured " + rounded(e.value, e.unit) + ", " + tolerance : reason_of(e) + "; " + tolerance;
}

std::string how_it_is_shown(const Evidence& e) {
  if (std::isfinite(e.value)) return e.how;
  return e.how + (e.how.empty() ? "" : "; ") + reason_of(e);
}

}  // namespace pmreport::document
