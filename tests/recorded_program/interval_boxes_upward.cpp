// Boxes give what the program gives on the interval scalar, whatever their number.
#include <array>
#include <catch2/catch.hpp>
#include <core/program/evaluate.hpp>
#include <core/program/intervals/boxes.hpp>
#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>
#include <random>
#include <vector>

using namespace pmreport;
using namespace pmreport::program;

namespace {

constexpr int inputs = 3;

// Of every operation, on any earlier steps; masks where masks belong. Constants now and then, zero and negative ones too.
Program any_program(std::mt19937_64& random, int length) {
  std::vector<Step> steps;
  std::vector<int> numbers, masks;
  const auto one_of = [&](const std::vector<int>& from) { return from[random() % from.size()]; };
  for (int i = 0; i < inputs; ++i) {
    numbers.push_back(static_cast<int>(steps.size()));
    steps.push_back({Operation::input, i, 0, 0, 0});
  }
  while (static_cast<int>(steps.size()) < length) {
    const int number = static_cast<int>(steps.size());
    const auto operation = static_cast<Operation>(random() % (static_cast<unsigned>(Operation::max) + 1));
    if (operation == Operation::input) continue;
    Step s{operation, 0, 0, 0, 0};
    if (operation == Operation::constant) {
      const double some[] = {0, -0.0, 1, -1, 0.1, -2.5, 3, 1e-3};
      s.constant = some[random() % std::size(some)];
    } else {
      const bool of_masks = operation == Operation::both || operation == Operation::either || operation == Operation::opposite;
      if ((of_masks || operation == Operation::choose) && masks.empty()) continue;
      const auto any = [&] { return one_of(of_masks ? masks : numbers); };
      s.a = operation == Operation::choose ? one_of(masks) : any();
      if (operands_of(operation) > 1) s.b = any();
      if (operands_of(operation) > 2) s.c = any();
    }
    (gives_mask(operation) ? masks : numbers).push_back(number);
    steps.push_back(s);
  }
  const std::vector<int> outputs{numbers.back(), one_of(numbers), one_of(numbers), one_of(numbers), numbers[1], numbers.back()};
  return Program(steps, inputs, outputs);
}

std::vector<Bounds> any_boxes(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<double> symmetric(-1, 1), share(0, 1);
  std::vector<Bounds> out(inputs * count);
  for (Bounds& b : out) {
    b.low = 3 * symmetric(random);
    b.high = random() % 8 == 0 ? b.low : b.low + std::exp2(-20 * share(random));
    if (random() % 32 == 0) b = {};
  }
  return out;
}

std::vector<Bounds> one_by_one(const Program& program, std::size_t count, const std::vector<Bounds>& in) {
  std::vector<Bounds> out(program.outputs().size() * count);
  Evaluator<Interval> evaluator(program);
  round_upward([&] {
    std::vector<Interval> q(inputs), r(program.outputs().size());
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t i = 0; i < q.size(); ++i) q[i] = Interval(in[i * count + k]);
      evaluator.run(q, r);
      for (std::size_t o = 0; o < r.size(); ++o) out[o * count + k] = r[o].bounds();
    }
  });
  return out;
}

}  // namespace

TEST_CASE("many boxes at a time have the bounds of each alone, on random programs") {
  std::mt19937_64 random(17);
  int bounded = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Program program = any_program(random, 4 + static_cast<int>(random() % 60));
    const std::array<std::size_t, 6> counts{1, 7, 8, 64, 257, 1000};
    const std::size_t count = counts[random() % counts.size()];
    const std::vector<Bounds> in = any_boxes(random, count);
    Boxes boxes(program);
    std::vector<Bounds> out(program.outputs().size() * count);
    boxes.run(count, in.data(), out.data());
    CAPTURE(trial, count);
    const std::vector<Bounds> expected = one_by_one(program, count, in);
    CHECK(out == expected);
    for (const Bounds& b : out) bounded += b.bounded() ? 1 : 0;
    boxes.run(count, in.data(), out.data());  // what was left in the registers does not matter
    CHECK(out == expected);
  }
  CHECK(bounded > 10000);
}

TEST_CASE("a program too long for the cache runs in short blocks") {
  std::vector<Step> steps{{Operation::input, 0, 0, 0, 0}, {Operation::input, 1, 0, 0, 0}, {Operation::input, 2, 0, 0, 0}};
  for (int i = 0; i < 500; ++i) steps.push_back({Operation::add, i, i + 1, 0, 0});
  for (int i = 0; i < 500; ++i) steps.push_back({Operation::max, 3 + i, static_cast<int>(steps.size()) - 1, 0, 0});  // all stay alive
  const std::vector<int> outputs{static_cast<int>(steps.size()) - 1};
  const Program program(steps, inputs, outputs);
  std::mt19937_64 random(2);
  const std::vector<Bounds> in = any_boxes(random, 100);
  std::vector<Bounds> out(100);
  Boxes(program).run(100, in.data(), out.data());
  CHECK(out == one_by_one(program, 100, in));
}

TEST_CASE("a program of nothing, and one of constants alone, have boxes too") {
  Boxes(Program()).run(5, nullptr, nullptr);
  const std::vector<Step> steps{{Operation::constant, 0, 0, 0, 0.1}, {Operation::constant, 0, 0, 0, -1}, {Operation::sqrt, 1, 0, 0, 0}};
  const std::vector<int> outputs{0, 2};
  std::vector<Bounds> out(6);
  Boxes(Program(steps, 0, outputs)).run(3, nullptr, out.data());
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(out[k] == Bounds::exactly(0.1));
    CHECK(out[3 + k] == Bounds{});
  }
}
