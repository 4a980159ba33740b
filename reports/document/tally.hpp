// How many of a report's promises were kept.
#pragma once

#include <reports/document/report.hpp>

#include <array>
#include <string>

namespace pmreport::document {

struct Tally {
  std::array<int, verdicts> counts{};
  int& operator[](Verdict v) { return counts[static_cast<std::size_t>(v)]; }
  int operator[](Verdict v) const { return counts[static_cast<std::size_t>(v)]; }
  Tally& operator+=(const Tally& other);
  int total() const;
  int failed() const { return (*this)[Verdict::failed] + (*this)[Verdict::error]; }
};
Tally tally_checks(const Report& r);
Tally tally_evidence(const Section& s);
Tally tally_evidence(const Report& r);

// "passed", "not decided", "error".
std::string word_of(Verdict verdict);
// "1 not decided, 2 not examined": of these, those that occur; empty: none.
std::string counted(const Tally& tally, std::initializer_list<Verdict> which);

// Of a line of evidence that fails, whether a check of the report fails with it that demands the same.
bool told_by_a_check(const Report& r, const Evidence& line);

}  // namespace pmreport::document
