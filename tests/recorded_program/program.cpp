// Lists of steps that are programs, and lists that are not.
#include <core/numbers.hpp>
#include <tests/fuzz/corpus.hpp>
#include <tests/fuzz/recorded_program.hpp>
#include <tests/recorded_program/recording.hpp>

#include <catch2/catch.hpp>
#include <core/program/evaluate.hpp>

#include <functional>
#include <limits>

using namespace recording;
using program::ProgramError;

namespace {

// Why these steps are no program; empty: they are one.
std::string refusal(const std::vector<Step>& steps, int inputs, const std::vector<int>& outputs) {
  try {
    Program(steps, inputs, outputs);
  } catch (const ProgramError& e) {
    return e.what();
  }
  return "";
}

constexpr Step x0{Operation::input, 0, 0, 0, 0}, x1{Operation::input, 1, 0, 0, 0};
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("what is no program is refused with a sentence that completes: the mechanism records") {
  struct Wrong {
    std::vector<Step> steps;
    std::vector<int> outputs;
    std::string sentence;
  };
  const Wrong all[] = {
      {{x0, {Operation::add, 0, 1, 0, 0}}, {1}, "an operation on a step that is not before it as step 2"},
      {{x0, {Operation::add, 2, 0, 0, 0}, x1}, {1}, "an operation on a step that is not before it as step 2"},
      {{x0, {Operation::sqrt, -1, 0, 0, 0}}, {1}, "an operation on a step that is not before it as step 2"},
      {{x0, {Operation::input, 2, 0, 0, 0}}, {1}, "coordinate 3 of 2 as step 2"},
      {{x0, {Operation::input, -1, 0, 0, 0}}, {1}, "coordinate 0 of 2 as step 2"},
      {{x0, {Operation::constant, 0, 0, 0, not_a_number}}, {0}, "a constant that is not finite as step 2"},
      {{{Operation::constant, 0, 0, 0, -infinity}, x0}, {1}, "a constant that is not finite as step 1"},
      {{x0, x1, {Operation::less, 0, 1, 0, 0}, {Operation::add, 0, 2, 0, 0}}, {3}, "a comparison in the place of a number as step 4"},
      {{x0, x1, {Operation::less, 0, 1, 0, 0}, {Operation::choose, 2, 2, 0, 0}}, {3}, "a comparison in the place of a number as step 4"},
      {{x0, x1, {Operation::both, 0, 1, 0, 0}}, {0}, "a number in the place of a comparison as step 3"},
      {{x0, {Operation::opposite, 0, 0, 0, 0}}, {0}, "a number in the place of a comparison as step 2"},
      {{x0, x1, {Operation::choose, 0, 0, 1, 0}}, {2}, "a number in the place of a comparison as step 3"},
      {{x0, {static_cast<Operation>(200), 0, 0, 0, 0}}, {0}, "operation 200, which does not exist, as step 2"},
      {{x0}, {1}, "a result that no step gives"},
      {{x0}, {-1}, "a result that no step gives"},
      {{x0, x1, {Operation::less, 0, 1, 0, 0}}, {2}, "a comparison as a result"},
  };
  for (const Wrong& wrong : all) {
    CAPTURE(wrong.sentence);
    CHECK(refusal(wrong.steps, 2, wrong.outputs) == wrong.sentence);
  }
  CHECK(refusal({x0, x1, {Operation::less, 0, 1, 0, 0}, {Operation::choose, 2, 1, 0, 0}}, 2, {3}) == "");
}

TEST_CASE("more steps than are looked at are refused, though nothing needs them: as many are not") {
  std::vector<Step> steps(Program::most_steps, x0);
  CHECK(refusal(steps, 1, {0}) == "");
  steps.push_back(x0);
  CHECK(refusal(steps, 1, {0}) == "65537 operations, more than the 65536 that are looked at");
}

TEST_CASE("an operation of a later contract is refused by its number") {
  const pm_step known{PM_OP_CHOOSE, 0, 0, 0, 0}, later{PM_OP_COUNT, 0, 0, 0, 0}, negative{-1, 0, 0, 0, 0};
  CHECK(program::steps_of({{known}}).front().operation == Operation::choose);
  CHECK_THROWS_WITH(program::steps_of({{later}}), "operation 21, which this pmreport does not know");
  CHECK_THROWS_WITH(program::steps_of({{negative}}), "operation -1, which this pmreport does not know");
}

TEST_CASE("a program has what its outputs need, and nothing else") {
  const Program p({{x0, {Operation::sin, 0, 0, 0, 0}, x1, {Operation::cos, 2, 0, 0, 0}, {Operation::tan, 1, 0, 0, 0}}}, 2, {{3}});
  REQUIRE(p.steps().size() == 2);
  CHECK(p.steps()[0] == x1);
  CHECK(p.steps()[1] == Step{Operation::cos, 0, 0, 0, 0});
  CHECK(p.inputs() == 2);
  const Program nothing;
  CHECK(nothing.steps().empty());
}

TEST_CASE("a slice gives the outputs that were asked for, in that order, and is smaller") {
  const Program all = everything();
  const int asked[] = {9, 2, 2, 0};
  const Program part = all.slice(asked);
  CHECK(part.steps().size() < all.steps().size());
  functions::Random random(31);
  const std::vector<double> q = random_numbers(random, 3);
  std::vector<double> whole(all.outputs().size()), few(4);
  program::Evaluator<double>(all).run(q, whole);
  program::Evaluator<double>(part).run(q, few);
  for (std::size_t i = 0; i < 4; ++i) CHECK(few[i] == whole[static_cast<std::size_t>(asked[i])]);
  std::vector<int> same(all.outputs().size());
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<int>(i);
  CHECK(all.slice(same) == all);
}

TEST_CASE("a step depends on the inputs that it is made of, masks included") {
  const Program p = recorded(3, [](const auto& x) {
    return std::vector<Recorded>{sin(x[0]) + x[2], choose(x[1] < 0.5, Recorded(2.0), Recorded(3.0)), Recorded(4.0) * x[2], Recorded(1.0)};
  });
  const std::vector<std::uint64_t> on = p.dependence();
  REQUIRE(on.size() == p.steps().size());
  const auto of_output = [&](std::size_t o) { return on[static_cast<std::size_t>(p.outputs()[o])]; };
  CHECK(of_output(0) == 0b101);
  CHECK(of_output(1) == 0b010);
  CHECK(of_output(2) == 0b100);
  CHECK(of_output(3) == 0);
}

TEST_CASE("no recording of the fuzzer's corpus, and none made of them, breaks a promise") {
  fuzz::check_promises("recorded_program", fuzz::broken_by_recorded_program);
}
