#include <core/analysis/residuals.hpp>

#include <catch2/catch.hpp>
#include <cmath>

using namespace pmreport::analysis;

namespace {
constexpr double tolerance = 1e-9;
constexpr Measure m = Measure::difference_acceleration;
}  // namespace

TEST_CASE("residuals are judged as they are where their sides are known well enough") {
  Residuals r(3);
  set(r[0], m, 2e-10), set(r[2], m, 5e-10, 1e-12);
  const Worst w = r.worst(m, tolerance);
  CHECK(w.value == 5e-10);
  CHECK(w.sample == 2);
  CHECK(w.compared == 2);
  CHECK(w.poorly_known == 0);
  CHECK(w.undecided == 0);
}

TEST_CASE("a residual whose sides are poorly known is held against what is known, and one of which nothing is known against nothing") {
  Residuals r(4);
  set(r[0], m, 5e-6, 1e-5);  // half of what is known
  set(r[1], m, 3e-10);
  set(r[2], m, 1e3, 0.5);
  Worst w = r.worst(m, tolerance);
  CHECK(w.value == Approx(0.5 * tolerance));
  CHECK(w.sample == 0);
  CHECK(w.compared == 2);
  CHECK(w.poorly_known == 1);
  CHECK(w.poorest == 1e-5);
  CHECK(w.undecided == 1);
  set(r[3], m, 3e-5, 1e-5);
  w = r.worst(m, tolerance);
  CHECK(w.value > tolerance);  // three times what is known: a fault
  CHECK(w.sample == 3);
  CHECK(r.worst(m).value == 3e-5);  // as they are
}

TEST_CASE("a residual that is not a number does not pass") {
  Residuals r(1);
  set(r[0], m, std::nan(""));
  CHECK(std::isinf(r.worst(m, tolerance).value));
}
