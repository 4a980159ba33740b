// Programs on many poses, and programs in two, are the program on one pose, to the last bit.
#include <tests/recorded_program/recording.hpp>

#include <catch2/catch.hpp>
#include <core/program/batch.hpp>
#include <core/program/batch_kernel.hpp>
#include <core/program/derivative.hpp>
#include <core/program/evaluate.hpp>

#include <bit>
#include <cmath>
#include <limits>

using namespace recording;
using functions::Random;

namespace {

// Zeros have signs here; of what is not a number the bits say nothing.
bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

std::vector<Program> programs() {
  const int by[] = {0, 2};
  return {everything(), program::partials(everything(), by), program::in_time(everything(), 2)};
}

// Numbers of `count` poses, some of them such as make zeros, infinities and what is no number.
std::vector<double> poses(Random& random, std::size_t numbers) {
  std::vector<double> out = random_numbers(random, numbers);
  for (std::size_t i = 0; i < numbers; i += 13) out[i] = i % 2 == 0 ? 0.0 : std::numeric_limits<double>::infinity();
  return out;
}

struct Difference {
  std::size_t numbers = 0;  // that differ
  std::size_t compared = 0;
};

}  // namespace

TEST_CASE("a batch of any number of poses gives the bits of one pose after another") {
  Random random(41);
  for (const Program& p : programs())
    for (const std::size_t count : {1, 7, 64, 512, 1000}) {
      const auto inputs = static_cast<std::size_t>(p.inputs()), outputs = p.outputs().size();
      const std::vector<double> in = poses(random, inputs * count);
      std::vector<double> out(outputs * count), q(inputs), one(outputs);
      program::Batch batch(p);
      batch.run(count, in.data(), out.data());
      program::Evaluator<double> evaluator(p);
      Difference d;
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t i = 0; i < inputs; ++i) q[i] = in[i * count + k];
        evaluator.run(q, one);
        for (std::size_t o = 0; o < outputs; ++o, ++d.compared) d.numbers += !same_bits(one[o], out[o * count + k]);
      }
      CAPTURE(p.steps().size(), count);
      CHECK(d.compared == count * outputs);
      CHECK(d.numbers == 0);
    }
}

TEST_CASE("a row, in which some inputs stay, gives the bits of its poses one after another, row after row") {
  Random random(42);
  constexpr std::size_t count = 300;
  for (const Program& p : programs())
    for (const std::uint64_t inner : {0b000u, 0b001u, 0b010u, 0b100u, 0b101u, 0b111u}) {
      const auto inputs = static_cast<std::size_t>(p.inputs()), outputs = p.outputs().size();
      program::Batch batch(p, inner);
      program::Evaluator<double> evaluator(p);
      Difference d;
      for (int row = 0; row < 3; ++row) {
        const std::vector<double> others = random_numbers(random, inputs), in = poses(random, 3 * count);
        std::vector<double> out(outputs * count), q(inputs), one(outputs);
        batch.run(count, others.data(), in.data(), out.data());
        for (std::size_t k = 0; k < count; ++k) {
          std::size_t place = 0;
          for (std::size_t i = 0; i < inputs; ++i) q[i] = inner >> i & 1 ? in[place++ * count + k] : others[i];
          evaluator.run(q, one);
          for (std::size_t o = 0; o < outputs; ++o, ++d.compared) d.numbers += !same_bits(one[o], out[o * count + k]);
        }
      }
      CAPTURE(p.steps().size(), inner);
      CHECK(d.compared == 3 * count * outputs);
      CHECK(d.numbers == 0);
    }
}

TEST_CASE("a program in two, the outer once and then the inner, gives the bits of the whole") {
  Random random(43);
  for (const Program& p : programs())
    for (const std::uint64_t inner : {0b000u, 0b001u, 0b010u, 0b100u, 0b101u, 0b111u}) {
      const program::Split two = program::split(p, inner);
      const auto inputs = static_cast<std::size_t>(p.inputs()), handed = two.outer.outputs().size();
      CAPTURE(p.steps().size(), inner);
      REQUIRE(two.inner.inputs() == p.inputs() + static_cast<int>(handed));
      REQUIRE(two.inner.outputs().size() == p.outputs().size());
      program::Evaluator<double> whole(p), outer(two.outer), inside(two.inner);
      std::vector<double> q = random_numbers(random, inputs + handed), one(p.outputs().size()), both(p.outputs().size());
      // A row: what is in `inner` changes from pose to pose, and the outer program has seen only the first of them.
      outer.run(std::span(q).first(inputs), std::span(q).last(handed));
      for (int pose = 0; pose < 20; ++pose) {
        for (std::size_t i = 0; i < inputs; ++i)
          if (inner >> i & 1) q[i] = random.within(-2, 2);
        whole.run(std::span(q).first(inputs), one);
        inside.run(q, both);
        for (std::size_t o = 0; o < one.size(); ++o) CHECK(same_bits(one[o], both[o]));
      }
    }
}

TEST_CASE("the inner program has no operation on numbers that a row decides") {
  const program::Split two = program::split(everything(), 0b001);
  const std::vector<std::uint64_t> on = [&] {
    std::vector<std::uint64_t> all = two.inner.dependence();
    return all;
  }();
  for (std::size_t i = 0; i < on.size(); ++i) {
    const Step& s = two.inner.steps()[i];
    if (program::operands_of(s.operation) == 0 || program::gives_mask(s.operation)) continue;
    CAPTURE(i, program::name_of(s.operation));
    CHECK((on[i] & 1) != 0);
  }
  const Program all = everything();
  CHECK(two.inner.steps().size() < all.steps().size());
}

TEST_CASE("all processors give the same bits") {
  Random random(44);
  constexpr std::size_t count = 77;
  const auto kernels = program::block_kernels();
  std::vector<std::vector<double>> arrays;
  for (int i = 0; i < 4; ++i) arrays.push_back(poses(random, count));
  for (double& x : arrays[3]) x = x > 0;
  for (int o = static_cast<int>(Operation::add); o <= static_cast<int>(Operation::max); ++o)
    for (int same = 0; same < 8; ++same) {
      const bool of_masks = o >= static_cast<int>(Operation::both) && o <= static_cast<int>(Operation::choose);
      const int first = of_masks ? 3 : 0, second = of_masks && o != static_cast<int>(Operation::choose) ? 3 : 1;
      const program::BlockStep step{program::Fused::none, static_cast<Operation>(o), 4, first, second, 2, (same & 1) != 0, (same & 2) != 0,
                                    (same & 4) != 0};
      std::vector<double> expected(count);
      for (std::size_t k = 0; k < kernels.size(); ++k) {
        std::vector<double> out(count);
        double* table[] = {arrays[0].data(), arrays[1].data(), arrays[2].data(), arrays[3].data(), out.data()};
        kernels[k](std::span(&step, 1), table, count);
        if (k == 0) expected = out;
        CAPTURE(program::name_of(step.operation), same, k);
        CHECK(std::ranges::equal(out, expected, same_bits));
      }
    }
}

TEST_CASE("a product that is added at once rounds twice, as two steps do, on all processors") {
  using program::Fused;
  Random random(45);
  constexpr std::size_t count = 77;
  std::vector<std::vector<double>> arrays;
  for (int i = 0; i < 3; ++i) arrays.push_back(poses(random, count));
  for (const Fused fused : {Fused::added, Fused::subtracted, Fused::subtracted_from})
    for (int same = 0; same < 8; ++same) {
      const program::BlockStep step{fused, Operation::add, 3, 0, 1, 2, (same & 1) != 0, (same & 2) != 0, (same & 4) != 0};
      std::vector<double> expected(count);
      for (std::size_t k = 0; k < count; ++k) {
        const double a = arrays[0][(same & 1) != 0 ? 0 : k], b = arrays[1][(same & 2) != 0 ? 0 : k], c = arrays[2][(same & 4) != 0 ? 0 : k];
        const double product = b * c;
        expected[k] = fused == Fused::added ? a + product : fused == Fused::subtracted ? a - product : product - a;
      }
      for (const program::BlockKernel kernel : program::block_kernels()) {
        std::vector<double> out(count);
        double* table[] = {arrays[0].data(), arrays[1].data(), arrays[2].data(), out.data()};
        kernel(std::span(&step, 1), table, count);
        CAPTURE(static_cast<int>(fused), same);
        CHECK(std::ranges::equal(out, expected, same_bits));
      }
    }
}
