#include <reports/document/finding.hpp>

#include <reports/document/quantity.hpp>
#include <reports/document/tally.hpp>

#include <cmath>

namespace pmreport::document {

namespace {

// "not decided: at t = 1.2 s"; "has no value: no sample can be assembled".
std::string reason_of(const Evidence& e) {
  return (e.stated ? word_of(*e.stated) : "has no value") + ": " + (e.reason.empty() ? "nothing could be compared" : e.reason);
}

}  // namespace

std::string finding(const Evidence& e) {
  if (e.stated) return reason_of(e);
  const std::string tolerance = "tolerance " + rounded(e.tolerance, e.unit);
  if (!std::isfinite(e.value)) return reason_of(e) + "; " + tolerance;
  return "measured " + rounded(e.value, e.unit) + ", " + tolerance + (e.reason.empty() ? "" : ": " + e.reason);
}

std::string how_it_is_shown(const Evidence& e) {
  const bool plain = !e.stated && std::isfinite(e.value);
  if (plain && e.reason.empty()) return e.how;
  return e.how + (e.how.empty() ? "" : "; ") + (plain ? e.reason : reason_of(e));
}

std::string number_shown(const Evidence& e, double number) { return e.has_numbers() ? rounded(number, e.unit) : "–"; }

}  // namespace pmreport::document
