// How many of a report's promises were kept.
#pragma once

#include <reports/document/report.hpp>

#include <array>
#include <string>
#include <vector>

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

// What was not examined and what was not decided, a sentence each, by claim; a handful, and how many more. Then what nobody asked for.
std::vector<std::string> unexamined(const Report& r);

// What fails, for the first page: checks by name, then evidence that no check tells already.
struct Failure {
  std::string name, worst, limit, message;
  std::string section;  // id of the section whose evidence it is; empty: a check
};
std::vector<Failure> failures_of(const Report& r);

// Of a finding, whether a check that fails says the same on the same page.
bool told_by_a_failure(const Report& r, const Finding& f);

// Of a line of evidence that fails, whether a check of the report fails with it that demands the same.
bool told_by_a_check(const Report& r, const Evidence& line);

}  // namespace pmreport::document
