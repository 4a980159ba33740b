#include <catch2/catch.hpp>
#include <pmreport/partials.hpp>
#include <tests/pmreport/functions.hpp>

using namespace pmreport;
using functions::Random;

namespace {

constexpr int tries = 50;
constexpr double rounding = 1e-13;
constexpr double difference_tolerance = 1e-10;  // of the differences below: truncation 1e-13, rounding 1e-19 / h

using P = Partials<double, 3>;

template <class F>
long double difference(F&& f) {
  constexpr long double h = 0x1p-8L;
  const auto odd = [&](int k) { return f(k * h) - f(-k * h); };
  return (45 * odd(1) - 9 * odd(2) + odd(3)) / (60 * h);
}

Approx near(long double expected, double tolerance) { return Approx(double(expected)).epsilon(tolerance).margin(tolerance); }

P random_partials(Random& random, double min, double max) {
  return {random.within(min, max), {random.within(-1, 1), random.within(-1, 1), random.within(-1, 1)}};
}
long double moved(const P& x, std::size_t direction, long double by) { return x.value + x.partial[direction] * by; }

}  // namespace

TEST_CASE("partial derivatives are those that differences show") {
  Random random(3);
  functions::each_of_one([&](const char* name, double min, double max, auto f) {
    for (int i = 0; i < tries; ++i) {
      const P x = random_partials(random, min, max), seen = f(x);
      for (std::size_t d = 0; d < 3; ++d) {
        CAPTURE(name, x.value, x.partial[d], d);
        CHECK(seen.value == near(f(moved(x, d, 0)), rounding));
        CHECK(seen.partial[d] == near(difference([&](long double h) { return f(moved(x, d, h)); }), difference_tolerance));
      }
    }
  });
  functions::each_of_two([&](const char* name, double min, double max, auto f) {
    for (int i = 0; i < tries; ++i) {
      const P x = random_partials(random, min, max), y = random_partials(random, min, max), seen = f(x, y);
      for (std::size_t d = 0; d < 3; ++d) {
        CAPTURE(name, x.value, x.partial[d], y.value, y.partial[d], d);
        CHECK(seen.value == near(f(moved(x, d, 0), moved(y, d, 0)), rounding));
        CHECK(seen.partial[d] == near(difference([&](long double h) { return f(moved(x, d, h), moved(y, d, h)); }), difference_tolerance));
      }
    }
  });
}

TEST_CASE("a variable has the derivative one by itself and zero by the others") {
  for (int d = 0; d < 3; ++d) {
    const P x = P::variable(4.0, d);
    CHECK(x.value == 4.0);
    for (std::size_t k = 0; k < 3; ++k) CHECK(x.partial[k] == (int(k) == d ? 1.0 : 0.0));
  }
  const P c = 2.5;
  CHECK(c.value == 2.5);
  CHECK(c.partial == std::array<double, 3>{0, 0, 0});
}

TEST_CASE("the gradient of a polynomial is that of calculus") {
  const P x = P::variable(2, 0), y = P::variable(3, 1), z = P::variable(5, 2);
  const P f = x * x * y - 4.0 * z / x + y * z;  // by x: 2xy + 4z/x^2, by y: x^2 + z, by z: y - 4/x
  CHECK(f.value == Approx(12 - 10 + 15).epsilon(rounding));
  CHECK(f.partial[0] == Approx(12 + 5).epsilon(rounding));
  CHECK(f.partial[1] == Approx(4 + 5).epsilon(rounding));
  CHECK(f.partial[2] == Approx(3 - 2).epsilon(rounding));
}

TEST_CASE("abs, smaller and larger of partials follow the branch of the value") {
  const P a(-1, {1, 2, 3}), b(2, {4, 5, 6});
  CHECK(abs(a).partial == (-a).partial);
  CHECK(smaller(a, b).partial == a.partial);
  CHECK(smaller(b, a).partial == a.partial);
  CHECK(larger(a, b).partial == b.partial);
  CHECK(choose(false, a, b).partial == b.partial);
}
