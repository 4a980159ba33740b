// Series of a function of time, of every order that is asked for.
#include <catch2/catch.hpp>
#include <core/program/intervals/rounding.hpp>
#include <core/scenario/expression/series.hpp>

using namespace pmreport;
using scenario::Series;

namespace {

template <int K>
void check_time() {
  CAPTURE(K);
  int smooth = 0, degree = 0;
  program::Bounds value, rate{1, 1};
  program::round_upward([&] {
    const auto t = Series<K>::time(program::Interval(2.0, 3.0));
    smooth = t.smooth, degree = t.degree, value = t[0].bounds();
    if constexpr (K > 0) rate = t[1].bounds();
  });
  CHECK(smooth == Series<K>::always);
  CHECK(degree == 1);
  CHECK(value.low == 2);
  CHECK(value.high == 3);
  CHECK(rate.low == 1);
  CHECK(rate.high == 1);
}

}  // namespace

TEST_CASE("time is smooth and rises by itself, whatever the order of its series") {
  check_time<0>();
  check_time<1>();
  check_time<2>();
}
