// Numbers beside each other: what a reader must be able to tell apart.
#include <catch2/catch.hpp>
#include <core/text/digits.hpp>
#include <limits>

using namespace pmreport;
using Texts = std::vector<std::string>;

TEST_CASE("numbers that the usual digits tell apart are written as usual") {
  CHECK(format_together({600, 500}, 4, 2) == Texts{"600", "500"});
  CHECK(format_together({31.2, 25}, 4, 2) == Texts{"31.2", "25"});
  CHECK(format_together({-20, 20}, 5, 3) == Texts{"-20", "20"});
  CHECK(format_together({1.2e-5, 3.4e7}, 4, 2) == Texts{"1.2e-5", "3.4e7"});
}

TEST_CASE("numbers that differ by little get the digits that show it, both alike") {
  CHECK(format_together({1200.06, 1200}, 4, 2) == Texts{"1200.06", "1200.00"});
  CHECK(format_together({65.99998, 66.00002}, 5, 3) == Texts{"65.99998", "66.00002"});
  CHECK(format_together({65.99998123, 66.00002014}, 5, 3) == Texts{"65.9999812", "66.0000201"});
  CHECK(format_together({-0.000012, 1234.5}, 4, 2) == Texts{"-1.2e-5", "1234"});
  CHECK(format_together({1000000.3, 1000000}, 4, 2) == Texts{"1000000.3", "1000000.0"});
  CHECK(format_together({1.0000001e-9, 1e-9}, 3, 2) == Texts{"1.0000001e-9", "1e-9"});
}

TEST_CASE("a number just outside a range is told from its end") {
  CHECK(format_outside(1000.0001, 10, 1000, 6) == "1000.0001");
  CHECK(format_outside(9.99999999, 10, 1000, 6) == "9.99999999");
  CHECK(format_outside(5000, 10, 1000, 6) == "5000");
}

TEST_CASE("rounding sets nothing apart, and no more digits are written than a double has") {
  CHECK(format_together({550 + 1e-13, 550}, 4, 2, 1e-12) == Texts{"550", "550"});
  CHECK(format_together({550, 550}, 4, 2) == Texts{"550", "550"});
  for (const std::string& text : format_together({1e5 + 3e-11, 1e5}, 4, 2)) CHECK(text.size() <= 16);  // 15 digits and the point
}

TEST_CASE("what is not a number stands for itself beside the others") {
  CHECK(format_together({std::numeric_limits<double>::quiet_NaN(), 1200.06, 1200}, 4, 2) == Texts{"—", "1200.06", "1200.00"});
  CHECK(format_together({}, 4, 2).empty());
}
