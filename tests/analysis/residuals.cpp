#include <core/analysis/residuals.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace pmreport::analysis;

namespace {

constexpr double tolerance = 1e-9;
constexpr Measure m = Measure::difference_acceleration;

struct Seen {
  int sample;
  double value, error = 0;
};
Residuals of(const std::vector<Seen>& seen) {
  Residuals out;
  for (const Seen& s : seen) {
    Row row;
    set(row, m, s.value, s.error);
    out.add(s.sample, row);
  }
  return out;
}

}  // namespace

TEST_CASE("residuals are judged as they are where their sides are known well enough") {
  const Worst w = of({{0, 2e-10}, {2, 5e-10, 1e-12}}).worst(m, tolerance);
  CHECK(w.value == 5e-10);
  CHECK(w.sample == 2);
  CHECK(w.compared == 2);
  CHECK(w.poorly_known == 0);
  CHECK(w.undecided == 0);
}

TEST_CASE("a residual whose sides are poorly known is held against what is known, and one of which nothing is known against nothing") {
  std::vector<Seen> seen{{0, 5e-6, 1e-5}, {1, 3e-10}, {2, 1e3, 0.5}};  // half of what is known; exact; nothing is known
  Worst w = of(seen).worst(m, tolerance);
  CHECK(w.value == Approx(0.5 * tolerance));
  CHECK(w.sample == 0);
  CHECK(w.compared == 2);
  CHECK(w.poorly_known == 1);
  CHECK(w.poorest == 1e-5);
  CHECK(w.undecided == 1);
  seen.push_back({3, 3e-5, 1e-5});
  w = of(seen).worst(m, tolerance);
  CHECK(w.value > tolerance);  // three times what is known: a fault
  CHECK(w.sample == 3);
  CHECK(of(seen).worst(m).value == 3e-5);  // as they are
}

TEST_CASE("a residual that is not a number does not pass") { CHECK(std::isinf(of({{0, std::nan("")}}).worst(m, tolerance).value)); }

TEST_CASE("residuals of blocks are told as those of all samples, the first of equal ones whatever the order") {
  const std::vector<Seen> first{{0, 2e-10}, {1, 4e-10, 1e-12}, {2, 1, 0.5}}, second{{3, 4e-10}, {4, 4e-10, 1e-12}, {5, 3e-10}};
  Residuals there = of(second), here = of(first);
  there.join(here);
  here.join(of(second));
  for (const Residuals& r : {here, there}) {
    const Worst w = r.worst(m, tolerance);
    CHECK(w.value == 4e-10);
    CHECK(w.sample == 1);
    CHECK(w.compared == 5);
    CHECK(w.undecided == 1);
  }
}
