// Programs as text.
#include <tests/recorded_program/recording.hpp>

#include <catch2/catch.hpp>
#include <core/program/print.hpp>

using namespace recording;

namespace {

Program leg() {
  return recorded(2, [](const auto& x) {
    // One operation a line: C++ takes the operands of one in any order.
    Recorded l = x[0] * x[0];
    const Recorded z = x[1] - 0.1;
    l += z * z;
    l = sqrt(l);
    auto mask = l < 0.5;
    const auto far = !(x[1] < 2.0);
    mask = mask || far;
    const Recorded shorter = -l, angle = atan2(x[1], x[0]) / 3.0;
    return std::vector<Recorded>{l, choose(mask, shorter, angle), Recorded(1.0 / 3.0), x[0]};
  });
}

}  // namespace

TEST_CASE("a program as text has a line a step, and what each output is") {
  CHECK(print(leg()) ==
        "v2 = square(x0)\n"
        "v4 = x1 - 0.1\n"
        "v5 = square(v4)\n"
        "v6 = v2 + v5\n"
        "v7 = sqrt(v6)\n"
        "v9 = v7 < 0.5\n"
        "v11 = x1 < 2\n"
        "v12 = not v11\n"
        "v13 = v9 or v12\n"
        "v14 = -v7\n"
        "v15 = atan2(x1, x0)\n"
        "v17 = v15 / 3\n"
        "v18 = choose(v13, v14, v17)\n"
        "y0 = v7\n"
        "y1 = v18\n"
        "y2 = 0.3333333333333333\n"
        "y3 = x0\n");
}

TEST_CASE("inputs and outputs have their names where there are any") {
  const std::string inputs[] = {"x", "z"}, outputs[] = {"l1", "angle"};
  const std::string text = print(leg(), inputs, outputs);
  CHECK_THAT(text, Catch::Contains("v4 = z - 0.1\n"));
  CHECK_THAT(text, Catch::EndsWith("l1 = v7\nangle = v18\ny2 = 0.3333333333333333\ny3 = x\n"));
}
