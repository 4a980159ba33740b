// Columns reduced to numbers, worked out by hand.
#include <catch2/catch.hpp>

#include <core/analysis/study/reduce.hpp>
#include <tests/analysis/run.hpp>

#include <cmath>

using namespace pmreport;

namespace {

const double none = std::nan("");
const std::vector<double> column{-4, none, 3};

analysis::Reduced reduced(const std::string& how, bool absolute = false) {
  scenario::Measured m;
  m.reduction = how;
  m.absolute = absolute;
  return analysis::reduce(column, m);
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

TEST_CASE("a column without a value has none to reduce") { CHECK(std::isnan(analysis::reduce({none, none, none}, {}).value)); }

TEST_CASE("at a time between two samples a column has the value that the motion has there, not one on a line") {
  // 20 mm sin(pi t / s), samples every 0.5 s: on the line between them x would be 10 mm at 0.25 s.
  const trial::Run r(
      "title = \"Stage\"\n[mechanism]\nuse = \"stage\"\n[[section]]\nkind = \"velocity\"\n[[section]]\nkind = "
      "\"displacement\"\n[motion]\nduration = \"2 s\"\nsamples = 5\nx = \"20 mm * sin(pi*t/1 s)\"\n");
  const auto at = [&](const std::vector<std::string>& columns, double t, bool absolute = false) {
    scenario::Measured m;
    m.reduction = "at";
    m.columns = columns;
    m.time = t;
    m.absolute = absolute;
    return analysis::measure(r.analysis, m);
  };
  constexpr double pi = 3.14159265358979323846;
  CHECK(at({"x"}, 0.25).value == Approx(0.02 * std::sin(0.25 * pi)));
  CHECK(at({"x"}, 0.5).value == Approx(0.02));
  CHECK(at({"x_rate"}, 1.25).value == Approx(0.02 * pi * std::cos(1.25 * pi)));
  CHECK(at({"x"}, 1.25, true).value == Approx(0.02 * std::sin(0.25 * pi)));
  const analysis::Number largest = at({"x", "q"}, 0.25);
  CHECK(largest.value == Approx(0.02 * std::sin(0.25 * pi)));
  CHECK(largest.sample == -1);
  CHECK(std::isnan(at({"nothing"}, 0.25).value));
}
