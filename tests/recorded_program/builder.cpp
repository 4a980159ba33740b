// What is written down once, and what needs not be written down.
#include <catch2/catch.hpp>
#include <core/program/builder.hpp>

#include <cmath>
#include <limits>

using namespace pmreport::program;
using O = Operation;

namespace {

struct List : Builder {
  int x = input(0), y = input(1);
  int c(double value) { return constant(value); }
  // The constant that a step came to.
  double value(int i) const {
    REQUIRE(step(i).operation == O::constant);
    return step(i).constant;
  }
  bool remains(int i) const { return step(i).operation != O::constant; }
};

}  // namespace

TEST_CASE("an operation on the same operands is the same step, in either order where the order does not matter") {
  List l;
  CHECK(l.input(0) == l.x);
  CHECK(l.c(0.1) == l.c(0.1));
  CHECK(l.c(0.0) != l.c(-0.0));
  CHECK(l.add(O::add, l.x, l.y) == l.add(O::add, l.y, l.x));
  CHECK(l.add(O::multiply, l.x, l.y) == l.add(O::multiply, l.y, l.x));
  CHECK(l.add(O::subtract, l.x, l.y) != l.add(O::subtract, l.y, l.x));
  CHECK(l.add(O::divide, l.x, l.y) != l.add(O::divide, l.y, l.x));
  CHECK(l.add(O::atan2, l.x, l.y) != l.add(O::atan2, l.y, l.x));
  CHECK(l.add(O::less, l.x, l.y) != l.add(O::less, l.y, l.x));
  const int m = l.add(O::less, l.x, l.y), n = l.add(O::less, l.y, l.x);
  CHECK(l.add(O::both, m, n) == l.add(O::both, n, m));
  CHECK(l.add(O::either, m, n) == l.add(O::either, n, m));
  CHECK(l.add(O::sin, l.x) == l.add({O::sin, l.x, 7, 8, 9.0}));  // what it does not use tells no two steps apart
}

TEST_CASE("what changes no number needs no operation") {
  List l;
  const int zero = l.c(0), one = l.c(1);
  CHECK(l.add(O::add, l.x, zero) == l.x);
  CHECK(l.add(O::add, zero, l.x) == l.x);
  CHECK(l.add(O::subtract, l.x, zero) == l.x);
  CHECK(l.add(O::multiply, l.x, one) == l.x);
  CHECK(l.add(O::multiply, one, l.x) == l.x);
  CHECK(l.add(O::divide, l.x, one) == l.x);
  CHECK(l.value(l.add(O::multiply, l.x, zero)) == 0);
  CHECK(l.add(O::negate, l.add(O::negate, l.x)) == l.x);
  CHECK(l.add(O::abs, l.add(O::square, l.x)) == l.add(O::square, l.x));
  CHECK(l.add(O::abs, l.add(O::abs, l.x)) == l.add(O::abs, l.x));
  CHECK(l.add(O::min, l.x, l.x) == l.x);
  CHECK(l.add(O::max, l.x, l.x) == l.x);
}

TEST_CASE("patterns become what they mean") {
  List l;
  const int zero = l.c(0), minus_x = l.add(O::negate, l.x);
  CHECK(l.add(O::multiply, l.x, l.x) == l.add(O::square, l.x));
  CHECK(l.add(O::subtract, zero, l.x) == minus_x);
  const int x_first = l.add(O::less, l.x, l.y), negative = l.add(O::less, l.x, zero), positive = l.add(O::less, zero, l.x);
  CHECK(l.add(O::choose, x_first, l.x, l.y) == l.add(O::min, l.x, l.y));
  CHECK(l.add(O::choose, x_first, l.y, l.x) == l.add(O::max, l.x, l.y));
  CHECK(l.add(O::choose, negative, minus_x, l.x) == l.add(O::abs, l.x));
  CHECK(l.add(O::choose, positive, l.x, minus_x) == l.add(O::abs, l.x));
  CHECK(l.step(l.add(O::choose, negative, l.x, minus_x)).operation == O::choose);  // -|x|, which nobody asks for
  CHECK(l.add(O::choose, x_first, l.y, l.y) == l.y);
}

TEST_CASE("masks that are known decide at once") {
  List l;
  const int two = l.c(2), three = l.c(3), yes = l.add(O::less, two, three), no = l.add(O::less, three, two);
  const int m = l.add(O::less, l.x, l.y);
  CHECK(l.add(O::choose, yes, l.x, l.y) == l.x);
  CHECK(l.add(O::choose, no, l.x, l.y) == l.y);
  CHECK(l.add(O::both, m, yes) == m);
  CHECK(l.add(O::both, no, m) == no);
  CHECK(l.add(O::either, no, m) == m);
  CHECK(l.add(O::either, m, yes) == yes);
  CHECK(l.add(O::opposite, yes) == no);
  CHECK(l.add(O::opposite, l.add(O::opposite, m)) == m);
  CHECK(l.add(O::both, m, m) == m);
  CHECK(l.add(O::either, m, m) == m);
}

TEST_CASE("constants fold where nothing is rounded") {
  List l;
  CHECK(l.value(l.add(O::add, l.c(0.5), l.c(0.25))) == 0.75);
  CHECK(l.value(l.add(O::subtract, l.c(0.1), l.c(0.1))) == 0);
  CHECK(l.value(l.add(O::multiply, l.c(3), l.c(0.125))) == 0.375);
  CHECK(l.value(l.add(O::multiply, l.c(0.1), l.c(-2))) == -0.2);
  CHECK(l.value(l.add(O::divide, l.c(3), l.c(4))) == 0.75);
  CHECK(l.value(l.add(O::divide, l.c(0), l.c(7))) == 0);
  CHECK(l.value(l.add(O::square, l.c(1.5))) == 2.25);
  CHECK(l.value(l.add(O::sqrt, l.c(2.25))) == 1.5);
  CHECK(l.value(l.add(O::negate, l.c(0.1))) == -0.1);
  CHECK(l.value(l.add(O::abs, l.c(-0.1))) == 0.1);
  CHECK(l.value(l.add(O::min, l.c(0.1), l.c(-3))) == -3);
  CHECK(l.value(l.add(O::max, l.c(0.1), l.c(-3))) == 0.1);
  CHECK(l.value(l.add(O::hypot, l.c(0), l.c(-0.1))) == 0.1);
  CHECK(l.value(l.add(O::sin, l.c(0))) == 0);
  CHECK(l.value(l.add(O::cos, l.c(0))) == 1);
  CHECK(l.value(l.add(O::acos, l.c(1))) == 0);
  CHECK(l.value(l.add(O::atan2, l.c(0), l.c(2))) == 0);
}

TEST_CASE("constants that would be rounded stay, and so do those of which no number follows") {
  constexpr double tiny = std::numeric_limits<double>::min(), huge = std::numeric_limits<double>::max();
  List l;
  CHECK(l.remains(l.add(O::add, l.c(0.1), l.c(0.2))));
  CHECK(l.remains(l.add(O::add, l.c(1), l.c(0x1p-53))));
  CHECK(l.remains(l.add(O::subtract, l.c(1), l.c(0x1p-60))));
  CHECK(l.remains(l.add(O::multiply, l.c(0.1), l.c(0.1))));
  CHECK(l.remains(l.add(O::multiply, l.c(tiny * 1.5), l.c(0x1p-52))));  // half of the smallest number is lost, and its error too
  CHECK(l.remains(l.add(O::divide, l.c(1), l.c(3))));
  CHECK(l.remains(l.add(O::square, l.c(0.1))));
  CHECK(l.remains(l.add(O::sqrt, l.c(2))));
  CHECK(l.remains(l.add(O::sin, l.c(1))));
  CHECK(l.remains(l.add(O::cos, l.c(1))));
  CHECK(l.remains(l.add(O::atan2, l.c(1), l.c(1))));
  CHECK(l.remains(l.add(O::add, l.c(huge), l.c(huge))));
  CHECK(l.remains(l.add(O::multiply, l.c(huge), l.c(2))));
  CHECK(l.remains(l.add(O::divide, l.c(1), l.c(0))));
  CHECK(l.remains(l.add(O::divide, l.c(0), l.c(0))));
  CHECK(l.remains(l.add(O::sqrt, l.c(-1))));
  CHECK(l.remains(l.add(O::acos, l.c(2))));
}
