// Columns reduced to numbers, worked out by hand.
#include <catch2/catch.hpp>

#include <core/analysis/study/reduce.hpp>

#include <cmath>

using namespace pmreport;

namespace {

const double none = std::nan("");
const std::vector<double> instants{0, 1, 3}, column{-4, none, 3};

analysis::Reduced reduced(const std::string& how, bool absolute = false, double at = 0) {
  scenario::Measured m;
  m.reduction = how;
  m.absolute = absolute;
  m.time = at;
  return analysis::reduce(instants, column, m);
}

}  // namespace

TEST_CASE("a sample without a value counts for nothing in a smallest, a largest and a mean") {
  CHECK(reduced("min").value == -4);
  CHECK(reduced("min").sample == 0);
  CHECK(reduced("max").value == 3);
  CHECK(reduced("max").sample == 2);
  CHECK(reduced("max", true).value == 4);
  CHECK(reduced("rms").value == Approx(std::sqrt((16.0 + 9) / 2)));
  CHECK(reduced("rms").sample == -1);
}

TEST_CASE("the value at a time lies on the line between its neighbours, and is none where one has none") {
  scenario::Measured m;
  m.reduction = "at";
  m.time = 2.5;
  CHECK(analysis::reduce(instants, {0, 2, 6}, m).value == Approx(5));
  CHECK(std::isnan(reduced("at", false, 0.5).value));
  CHECK(reduced("at", false, 3).value == 3);
  CHECK(std::isnan(analysis::reduce(instants, {none, none, none}, {}).value));
}
