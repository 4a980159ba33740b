// The data files: every number as it was, every gap a gap, no heading a formula.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <reports/document/write.hpp>

#include <tests/document/sample.hpp>

using namespace pmreport::document;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

std::string first_line(const std::string& heading) { return lines_of(to_csv({"d", {heading, "b"}, {{1}, {2}}})).front(); }

}  // namespace

TEST_CASE("a number read back from the data is bit for bit the number that was written") {
  std::vector<double> numbers{0.0, -0.0, 0.1, 1.0 / 3.0, 1e308, -1e-300, std::numeric_limits<double>::denorm_min(), 9007199254740993.0,
                              5e22};
  std::mt19937_64 random(20240607);
  while (numbers.size() < 5000) {
    const double number = std::bit_cast<double>(random());
    if (std::isfinite(number)) numbers.push_back(number);
  }
  const auto lines = lines_of(to_csv({"d", {"x [m]"}, {numbers}}));
  REQUIRE(lines.size() == numbers.size() + 1);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    CAPTURE(i, lines[i + 1]);
    double back = 0;
    const auto [end, error] = std::from_chars(lines[i + 1].data(), lines[i + 1].data() + lines[i + 1].size(), back);
    REQUIRE(error == std::errc());
    REQUIRE(end == lines[i + 1].data() + lines[i + 1].size());
    REQUIRE(std::bit_cast<std::uint64_t>(back) == std::bit_cast<std::uint64_t>(numbers[i]));
  }
}

TEST_CASE("what is not finite is an empty cell") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK(to_csv({"d", {"t [s]", "x [m]", "y [m]"}, {{0, 1, 2}, {nan, 0.5, -infinity}, {3, infinity, 4}}}) ==
        "t [s],x [m],y [m]\n0,,3\n1,0.5,\n2,,4\n");
}

TEST_CASE("an empty cell alone in its row is still a row") {
  CHECK(to_csv({"d", {"x"}, {{1, std::numeric_limits<double>::quiet_NaN(), 2}}}) == "x\n1\n\"\"\n2\n");
}

TEST_CASE("a heading that a spreadsheet would run is made text") {
  for (const std::string start : {"=", "+", "-", "@"}) {
    CAPTURE(start);
    CHECK(first_line(start + "cmd|x") == "'" + start + "cmd|x,b");
  }
  CHECK(first_line("l1 - l2 [m]") == "l1 - l2 [m],b");
}

TEST_CASE("a heading with commas and quotation marks is quoted as RFC 4180 says") {
  CHECK(first_line("a, \"b\"") == "\"a, \"\"b\"\"\",b");
  CHECK(first_line("=1,2") == "\"'=1,2\",b");
  CHECK(first_line("<script>") == "<script>,b");
}

TEST_CASE("data whose columns are not equally long are a mistake of ours, not a file") {
  CHECK_THROWS_AS(to_csv({"d", {"a", "b"}, {{1, 2}, {1}}}), std::logic_error);
  CHECK_THROWS_AS(to_csv({"d", {"a"}, {{1}, {1}}}), std::logic_error);
}

TEST_CASE("long data are handed over in pieces of whole lines that join to the whole") {
  Data d{"d", {"a", "b"}, {{}, {}}};
  for (int k = 0; k < 200'000; ++k)
    for (std::vector<double>& column : d.columns) column.push_back(k / 3.0);
  std::string whole;
  std::size_t pieces = 0;
  to_csv(d, [&](std::string_view piece) {
    CHECK(piece.ends_with('\n'));
    CHECK(piece.size() < std::size_t{2} << 20);
    whole += piece;
    ++pieces;
  });
  CHECK(pieces > 4);
  CHECK(whole.starts_with("a,b\n0,0\n0.3333333333333333,0.3333333333333333\n"));
  CHECK(whole.ends_with("66666.33333333333,66666.33333333333\n"));
  CHECK(std::count(whole.begin(), whole.end(), '\n') == 200'001);
}
