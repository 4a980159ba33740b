#include <core/program/batch.hpp>

#include <vector>

namespace pmreport::program {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

template <class F>
void for_operands(const Step& s, F&& f) {
  const int operands[] = {s.a, s.b, s.c};
  for (int k = 0; k < operands_of(s.operation); ++k) f(operands[k]);
}

}  // namespace

Split split(const Program& program, std::uint64_t inner) {
  std::vector<bool> inputs(index(program.inputs()));
  for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = i < 64 && (inner >> i & 1) != 0;
  return split(program, inputs);
}

Split split(const Program& program, const std::vector<bool>& inner) {
  const std::span<const Step> steps = program.steps();
  std::vector<bool> varies(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& s = steps[i];
    if (s.operation == Operation::input) varies[i] = inner[index(s.a)];
    for_operands(s, [&](int x) { varies[i] = varies[i] || varies[index(x)]; });
  }

  // What a pose needs of a row, from the outputs back. What costs nothing is made again, and comparisons, which cannot be handed over.
  const auto made_again = [](const Step& s) {
    return s.operation == Operation::constant || s.operation == Operation::input || gives_mask(s.operation);
  };
  std::vector<bool> needed(steps.size());
  std::vector<int> handed;
  for (const int o : program.outputs()) needed[index(o)] = true;
  for (std::size_t i = steps.size(); i-- > 0;) {
    if (!needed[i]) continue;
    if (varies[i] || made_again(steps[i]))
      for_operands(steps[i], [&](int x) { needed[index(x)] = true; });
    else
      handed.insert(handed.begin(), static_cast<int>(i));
  }

  std::vector<Step> inside(steps.begin(), steps.end());
  for (std::size_t n = 0; n < handed.size(); ++n)
    inside[index(handed[n])] = {Operation::input, program.inputs() + static_cast<int>(n), 0, 0, 0};
  return {Program(steps, program.inputs(), handed), Program(inside, program.inputs() + static_cast<int>(handed.size()), program.outputs())};
}

}  // namespace pmreport::program
