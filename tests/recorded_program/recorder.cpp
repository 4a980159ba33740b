// Recording on top of a program.
#include <tests/recorded_program/recording.hpp>

#include <catch2/catch.hpp>
#include <core/program/evaluate.hpp>

using namespace recording;

namespace {

std::vector<double> run(const Program& p, const std::vector<double>& q) {
  std::vector<double> out(p.outputs().size());
  program::Evaluator<double>(p).run(q, out);
  return out;
}

}  // namespace

TEST_CASE("what is recorded on top of a program continues it, with its inputs, its outputs and its constants") {
  const Program start = recorded(2, [](const auto& x) {
    return std::vector<Recorded>{sqrt(x[0] * x[0] + x[1] * x[1]), x[1] * 2.0, Recorded(0.25), smaller(x[0], x[1])};
  });
  program::Recorder recorder(start);
  CHECK(recorder.output(2).is_constant());
  CHECK_FALSE(recorder.output(0).is_constant());
  const std::vector<Recorded> more = {recorder.output(0) - recorder.input(0), recorder.output(1) + recorder.output(2), recorder.output(3),
                                      Recorded(7.0)};
  const Program p = recorder.finish(more);
  CHECK(p.inputs() == 2);
  const std::vector<double> y = run(p, {3, 4});
  CHECK(y == std::vector<double>{2, 8.25, 3, 7});
}

TEST_CASE("what is computed on top a second time is there once") {
  const Program start = recorded(2, [](const auto& x) { return std::vector<Recorded>{sin(x[0]) * x[1]}; });
  program::Recorder recorder(start);
  const std::vector<Recorded> again = {recorder.output(0), sin(recorder.input(0)) * recorder.input(1)};
  const Program p = recorder.finish(again);
  CHECK(p.steps().size() == start.steps().size());
  CHECK(p.outputs()[0] == p.outputs()[1]);
}

TEST_CASE("more than can be recorded is refused when it is finished, whatever was asked for in the meantime") {
  program::Recorder recorder(1);
  Recorded x = recorder.input(0);
  for (std::size_t i = 0; i < Program::most_steps; ++i) x = x + 1.0;
  const std::vector<Recorded> out = {recorder.input(0)};
  CHECK_THROWS_WITH(recorder.finish(out), Catch::Contains("more operations than there is room for"));
}
