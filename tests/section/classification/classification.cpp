// Section `classification`: the numbers of its tables against each other and against those that the text of the paper states.
#include <catch2/catch.hpp>

#include <tests/section/report_words.hpp>
#include <tests/section/whole_report.hpp>

#include <string>

using namespace pmreport;
using namespace whole_report;
using Catch::Contains;
using report_words::check_proofs, report_words::table_of, report_words::text_of, report_words::value;

namespace {

// "12 (14)": the number in Table 1, and by the rule; "12": both.
std::pair<int, int> both(const std::string& cell) {
  const int base = std::stoi(cell);
  const auto open = cell.find('(');
  return {base, open == std::string::npos ? base : std::stoi(cell.substr(open + 1))};
}

}  // namespace

TEST_CASE("the numbers of schemes add up, by rows and by columns, to those of the paper's text and of the rule") {
  const auto r = of_gantry(asking_for({"classification"}));
  const document::Section& s = section_of(r, "classification");
  const document::Table& t = table_of(s, "Numbers of schemes");
  REQUIRE(t.rows.size() > 2);
  REQUIRE(t.headings.size() == 8);  // k, six of m, all
  std::vector<std::pair<int, int>> sums(7);
  for (std::size_t row = 0; row + 1 < t.rows.size(); ++row) {
    int base = 0, rule = 0;
    for (std::size_t m = 1; m <= 7; ++m) {
      const auto [b, by_rule] = both(t.rows[row][m]);
      sums[m - 1].first += b, sums[m - 1].second += by_rule;
      if (m < 7) base += b, rule += by_rule;
    }
    CHECK(both(t.rows[row][7]) == std::pair(base, rule));
  }
  for (std::size_t m = 1; m <= 7; ++m) CHECK(both(t.rows.back()[m]) == sums[m - 1]);
  CHECK(t.rows.back()[0] == "all");
  CHECK(sums[6].first == 118);  // "118" of the paper's text
  CHECK(value(r, "base_schemes") == 118);
  CHECK(value(r, "by_rule") == sums[6].second);
  check_proofs(s, 2);
}

TEST_CASE("the text tells how many schemes the rule admits, and how many the paper leaves out") {
  const auto r = of_gantry(asking_for({"classification"}));
  const int rule = int(value(r, "by_rule")), base = int(value(r, "base_schemes"));
  CHECK_THAT(text_of(section_of(r, "classification")), Contains("It admits " + std::to_string(rule) + " schemes.") &&
                                                           Contains("The " + std::to_string(rule - base) + " marked by a star"));
}
