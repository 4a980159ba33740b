// How much of a report is shown: at every level the same values, checks, evidence and data.
#include <catch2/catch.hpp>

#include <reports/document/levels.hpp>
#include <reports/document/tally.hpp>
#include <tests/document/sample.hpp>

#include <string>

using namespace pmreport::document;

namespace {

Table of_rows(std::size_t n, bool ranked) {
  Table t{"Limits, the worst first. In the order of time.", {"limit"}, {false}, {}};
  for (std::size_t k = 0; k < n; ++k) t.rows.push_back({"row " + std::to_string(k)});
  t.ranked = ranked;
  return t;
}

}  // namespace

TEST_CASE("long tables stand at the end, and a line where they were says so") {
  Report r = sample::report();
  r.sections[0].blocks.emplace_back(of_rows(40, false));
  r.sections[1].blocks.emplace_back(of_rows(14, false));
  const Report a = arranged(r, Detail::engineering);
  REQUIRE(a.sections.size() == r.sections.size() + 1);
  const Section& end = a.sections.back();
  CHECK(end.title == "Long tables");
  REQUIRE(end.blocks.size() == 1);
  CHECK(std::get<Table>(end.blocks[0]).rows.size() == 40);
  CHECK(std::get<Table>(end.blocks[0]).caption == "Displacement: Limits, the worst first. In the order of time.");
  CHECK(std::get<Paragraph>(a.sections[0].blocks.back()).text == "Limits, the worst first: 40 rows, in section \"Long tables\".");
  CHECK(std::get<Table>(a.sections[1].blocks.back()).rows.size() == 14);
}

TEST_CASE("of a long table whose worst rows stand first these stay where it was") {
  Report r = sample::report();
  r.sections[0].blocks.emplace_back(of_rows(40, true));
  const Report a = arranged(r, Detail::engineering);
  const Table& left = std::get<Table>(a.sections[0].blocks.back());
  REQUIRE(left.rows.size() == 5);
  CHECK(left.rows[4][0] == "row 4");
  CHECK(left.caption.ends_with("The first 5 of 40; all are in section \"Long tables\"."));
  CHECK(std::get<Table>(a.sections.back().blocks[0]).rows.size() == 40);
}

TEST_CASE("a brief report keeps warnings, a figure and all evidence of each section, and no check, value or file is lost") {
  Report r = sample::report();
  r.sections[0].blocks.emplace_back(of_rows(40, false));
  r.sections.push_back({"words", "words", "Words", {Paragraph{Paragraph::Tone::plain, "nothing else"}}});
  const Report a = arranged(r, Detail::brief);
  CHECK(a.sections.size() == r.sections.size() - 1);
  for (const Section& s : a.sections)
    for (const Block& b : s.blocks) CHECK_FALSE(std::holds_alternative<Table>(b));
  CHECK(tally_evidence(a).counts == tally_evidence(r).counts);
  CHECK(a.checks.size() == r.checks.size());
  CHECK(a.values.size() == r.values.size());
  CHECK(a.data.size() == r.data.size());
  CHECK(arranged(r, Detail::full).sections.size() == r.sections.size());
}
