// Groups of numbers that lose the divisors they share keep their ratios.
#include <catch2/catch.hpp>
#include <core/program/common_divisors.hpp>
#include <core/program/evaluate.hpp>
#include <core/program/recorder.hpp>

#include <algorithm>
#include <array>

using namespace pmreport;
using program::Operation, program::Program;

namespace {

std::vector<double> at(const Program& p, const std::vector<double>& in) {
  std::vector<double> out(p.outputs().size());
  program::Evaluator<double>(p).run(in, out);
  return out;
}

bool divides(const Program& p) {
  return std::ranges::any_of(p.steps(), [](const program::Step& s) { return s.operation == Operation::divide; });
}

}  // namespace

TEST_CASE("a unit vector and its moment become a vector and its moment, without a division or a root") {
  program::Recorder r(5);
  const Recorded x = r.input(0), y = r.input(1), length = sqrt(x * x + y * y);
  const Recorded nx = x / length, ny = y / length, moment = r.input(2) * ny - r.input(3) * nx;
  const std::array outputs{nx, -ny, moment, Recorded(0.0)};
  const Program p = program::without_common_divisors(r.finish(outputs), 4);
  CHECK_FALSE(divides(p));
  CHECK(at(p, {3, 4, 5, 6, 0}) == std::vector<double>{3, -4, 5 * 4 - 6 * 3, 0});
  CHECK(p.inputs() == 5);
}

TEST_CASE("what only some of a group are divided by stays, and so does what another group is divided by") {
  program::Recorder r(3);
  const Recorded x = r.input(0), y = r.input(1), d = r.input(2);
  const std::array outputs{x / d, y + 1.0, x / d, y / d};
  const Program p = program::without_common_divisors(r.finish(outputs), 2);
  CHECK(at(p, {3, 5, 2}) == std::vector<double>{1.5, 6, 3, 5});
}

TEST_CASE("divisors of divisors go one after the other, and a factor on either side of a product does") {
  program::Recorder r(4);
  const Recorded x = r.input(0), y = r.input(1), a = r.input(2), b = r.input(3);
  const std::array outputs{x / a / b, y * (x / b / a), (x - y) / (a * b) * 2.0};
  const Program p = program::without_common_divisors(r.finish(outputs), 2);  // of three outputs the last group is one
  const std::vector<double> out = at(p, {3, 5, 2, 7});
  CHECK(out[0] == 3);
  CHECK(out[1] == 15);
  CHECK(out[2] == -4);
}
