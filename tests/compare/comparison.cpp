// Which numbers, verdicts and curves agree.
#include <catch2/catch.hpp>
#include <reports/compare/words.hpp>
#include <tests/compare/reports.hpp>

#include <cmath>
#include <limits>

using namespace pmreport;
using Catch::Contains;
using compare_test::report, compare_test::results;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// Two reports that are alike but for one value.
bool agree(double a, double b, const compare::Tolerance& tolerance = {}) {
  document::Report first = report(), second = report();
  first.values[0].value = a;
  second.values[0].value = b;
  const auto both = results({first, second});
  return compare::compare(both, tolerance).agree;
}

std::string text_of(const document::Report& a, const document::Report& b) {
  const auto both = results({a, b});
  return compare::to_text(compare::compare(both, {}));
}

}  // namespace

TEST_CASE("a report agrees with itself, and what was compared is counted") {
  CHECK_THAT(text_of(report(), report()), Contains("They agree: 3 values, 3 verdicts and 1 curve, within a relative 1e-6"));
}

TEST_CASE("two numbers agree up to the tolerance, the tolerance itself included") {
  // Powers of two: nothing is rounded. 1023 differs from 1024 by a 1024th.
  CHECK(agree(1024, 1023, {1.0 / 1024, 0}));
  CHECK_FALSE(agree(1024, 1023, {1.0 / 1025, 0}));
  CHECK(agree(1023, 1024, {1.0 / 1024, 0}));  // of the larger, whichever comes first
  CHECK(agree(-1024, -1023, {1.0 / 1024, 0}));
  CHECK(agree(0.5, 0.25, {0, 0.25}));
  CHECK_FALSE(agree(0.5, 0.25, {0, 0.2499}));
  CHECK(agree(0, 1e-13));
  CHECK_FALSE(agree(0, 1e-11));
  CHECK(agree(0, 0, {0, 0}));
  CHECK_FALSE(agree(1, -1));
}

TEST_CASE("a number that is in neither agrees, one that is in one of the two differs") {
  CHECK(agree(none, none));
  CHECK_FALSE(agree(none, 1, {1, 1e300}));
  CHECK_FALSE(agree(1, none, {1, 1e300}));
  document::Report a = report(), b = report();
  b.values[0].value = none;
  CHECK_THAT(text_of(a, b), Contains("max(x) [m]  0.5  not finite"));
}

TEST_CASE("of two reasons for no number each counts") {
  auto both = results({report(), report()});
  both[0].values[0].value = both[1].values[0].value = none;
  both[0].values[0].status = "not finite";
  both[1].values[0].status = "out of reach";
  CHECK_FALSE(compare::compare(both, {}).agree);
  both[1].values[0].status = "not finite";
  CHECK(compare::compare(both, {}).agree);
}

TEST_CASE("a value of another unit, section or name is another value") {
  for (int which = 0; which < 3; ++which) {
    document::Report other = report();
    (which == 0 ? other.values[0].unit : which == 1 ? other.values[0].section : other.values[0].name) = "velocity";
    CAPTURE(which);
    const std::string text = text_of(report(), other);
    CHECK_THAT(text, Contains("Only in A\n  section       value or curve    A\n  displacement  max(x) [m]      0.5"));
    CHECK_THAT(text, Contains("Only in B\n"));
    CHECK_THAT(text, Contains("They differ: what they share agrees") && Contains("Not in both: 2 values."));
  }
}

TEST_CASE("values of one name are held against each other in their order") {
  document::Report a = report(), b = report();
  a.values.push_back({"displacement", "max(x)", "m", 0.75});
  b.values.push_back({"displacement", "max(x)", "m", 0.75});
  auto both = results({a, b});
  CHECK(compare::compare(both, {}).agree);
  both[1].values[2].value = 0.8;
  const compare::Comparison c = compare::compare(both, {});
  REQUIRE(c.values.size() == 4);
  CHECK_FALSE(c.values[0].differs);
  CHECK(c.values[1].differs);  // beside the first of its section
}

TEST_CASE("a verdict that changed is told with its section") {
  document::Report a = report(), b = report();
  b.checks[0].passed = false;
  std::get<document::Proof>(b.sections[0].blocks[0]).lines[0].stated = document::Verdict::not_decided;
  const std::string text = text_of(a, b);
  CHECK_THAT(text, Contains("passed  failed       checks        max(abs(actuator_force)) < 400 N"));
  CHECK_THAT(text, Contains("passed  not decided  displacement  every joint meets"));
  CHECK_THAT(text, Contains("They differ: 2 of 3 verdicts"));
}

TEST_CASE("a residual that is rounded otherwise changes nothing") {
  document::Report b = report();
  std::get<document::Proof>(b.sections[0].blocks[0]).lines[0].value = 7e-13;
  const auto both = results({report(), b});
  CHECK(compare::compare(both, {}).agree);
}

TEST_CASE("a check that one report alone has is told once") {
  document::Report b = report();
  b.checks.clear();
  const std::string text = text_of(report(), b);
  CHECK_THAT(text, Contains("passed  –  checks   max(abs(actuator_force)) < 400 N") && !Contains("Only in A"));
  CHECK_THAT(text, Contains("Not in both: 1 verdict."));
}

TEST_CASE("a curve is judged by its largest value, and told where it differs most") {
  document::Report b = report();
  b.data[0].columns[1] = {1e-8, 0.5, 0};  // against 0, but small against 0.5
  auto both = results({report(), b});
  CHECK(compare::compare(both, {}).agree);
  b.data[0].columns[1] = {0, 0.5, -0.25};
  both = results({report(), b});
  const compare::Comparison c = compare::compare(both, {});
  REQUIRE(c.curves.size() == 1);
  CHECK(c.curves[0].differs);
  CHECK(c.curves[0].difference == -0.25);
  CHECK(c.curves[0].at == 2);
  CHECK(c.curves[0].relative == 0.5);
}

TEST_CASE("gaps agree with gaps alone") {
  document::Report a = report(), b = report();
  a.data[0].columns[1][1] = b.data[0].columns[1][1] = none;
  auto both = results({a, b});
  CHECK(compare::compare(both, {}).agree);
  both = results({report(), b});
  CHECK(compare::compare(both, {}).curves[0].gap);
  CHECK_THAT(compare::to_text(compare::compare(both, {})), Contains("a gap in one of them"));
}

TEST_CASE("curves of other instants differ, and are read between their samples") {
  document::Report b = report();
  b.data[0].columns = {{0, 0.5, 1, 2}, {0, 0.25, 0.5, 0}};  // the same broken line
  const auto both = results({report(), b});
  const compare::Comparison c = compare::compare(both, {});
  CHECK_FALSE(c.agree);
  CHECK(c.curves[0].difference == 0);
  CHECK_THAT(compare::verdict(c), Contains("what they share agrees") && Contains("Curves are sampled at other instants."));
  CHECK(compare::read_between({0, 2}, {0, 1}, 0.5) == 0.25);
  CHECK(std::isnan(compare::read_between({0, 2}, {0, 1}, 2.5)));
  CHECK(std::isnan(compare::read_between({0, 2}, {0, 1}, -0.5)));
}

TEST_CASE("where a curve jumps, its samples of one instant are held against those of the other in their order") {
  document::Report a = report(), b = report();
  a.data[0].columns = {{0, 1, 1, 2}, {0, 1, 5, 6}};            // jumps from 1 to 5
  b.data[0].columns = {{0, 0.5, 1, 1, 2}, {0, 0.5, 1, 5, 6}};  // the same, sampled at one instant more
  const auto both = results({a, b});
  CHECK(compare::compare(both, {}).curves[0].difference == 0);
  CHECK(compare::read_between({0, 1, 1, 2}, {0, 1, 5, 6}, 1, 1) == 5);
  CHECK(compare::read_between({0, 1, 1, 2}, {0, 1, 5, 6}, 1, 9) == 5);
  CHECK(compare::read_between({0, 1, 1, 2}, {0, 1, 5, 6}, 1.5) == 5.5);
  b.data[0].columns[1][3] = 4;
  CHECK(compare::compare(results({a, b}), {}).curves[0].difference == -1);
}

TEST_CASE("a report without data is compared by its values") {
  auto both = results({report(), report()});
  both[1].curves.clear();
  both[1].curves_missing = "it stands alone";
  const compare::Comparison c = compare::compare(both, {});
  CHECK(c.agree);
  CHECK_THAT(compare::to_text(c), Contains("Curves of B are not all compared: it stands alone."));
}

TEST_CASE("of several reports every shared value has a row with a column a report") {
  document::Report b = report(), c = report();
  b.provenance.mechanism = "stewart";
  b.values[0].value = 0.25;
  c.values.erase(c.values.begin());
  const auto all = results({report(), b, c});
  const std::string text = compare::to_text(compare::compare(all, {}));
  CHECK_THAT(text, Contains("max(x) [m]  0.5  0.25  –       -0.25       0.5  differs"));
  CHECK_THAT(text, Contains("max(l1_force) [N]  1024  1024  1024           0         0  agrees"));
  CHECK_THAT(text, Contains("reports of different mechanisms, gough and stewart"));
  CHECK_THAT(text, Contains("Not in all: 1 value."));
}

TEST_CASE("other scenarios and other programs are told in a sentence each") {
  document::Report b = report();
  b.provenance.scenario_sha256 = "0b";
  CHECK_THAT(text_of(report(), b), Contains("These are reports of different scenarios, all named motion.toml."));
  b.provenance.scenario_name = "other.toml";
  b.provenance.version = "1.1.0";
  CHECK_THAT(text_of(report(), b), Contains("These are reports of different scenarios, motion.toml and other.toml."));
  CHECK_THAT(text_of(report(), b), Contains("pmreport 1.0.0, plugin C++ and pmreport 1.1.0, plugin C++"));
}

TEST_CASE("reports that share nothing differ") {
  document::Report empty;
  empty.provenance = report().provenance;
  CHECK_THAT(text_of(report(), empty), Contains("They differ: they share nothing. Not in both: 2 values, 3 verdicts and 1 curve."));
  CHECK_THAT(text_of(empty, empty), Contains("They agree: none of them has a value."));
}

TEST_CASE("no title of a report commands a terminal") {
  auto both = results({report(), report()});
  both[1].title = "\x1b[2J\nhello\tyou";
  CHECK_THAT(compare::to_text(compare::compare(both, {})), Contains("?[2J?hello you"));
}
