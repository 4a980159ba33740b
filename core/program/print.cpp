#include <core/program/print.hpp>

#include <fmt/format.h>

namespace pmreport::program {

std::string print(const Program& program, std::span<const std::string> inputs, std::span<const std::string> outputs) {
  const std::span<const Step> steps = program.steps();
  const auto named = [](std::span<const std::string> names, int i, char letter) {
    return static_cast<std::size_t>(i) < names.size() ? names[static_cast<std::size_t>(i)] : fmt::format("{}{}", letter, i);
  };
  // Constants and inputs stand where they are used.
  const auto text = [&](int i) {
    const Step& s = steps[static_cast<std::size_t>(i)];
    if (s.operation == Operation::constant) return fmt::format("{}", s.constant);
    if (s.operation == Operation::input) return named(inputs, s.a, 'x');
    return fmt::format("v{}", i);
  };
  const auto expression = [&](const Step& s) {
    switch (s.operation) {
      case Operation::add:
        return fmt::format("{} + {}", text(s.a), text(s.b));
      case Operation::subtract:
        return fmt::format("{} - {}", text(s.a), text(s.b));
      case Operation::multiply:
        return fmt::format("{} * {}", text(s.a), text(s.b));
      case Operation::divide:
        return fmt::format("{} / {}", text(s.a), text(s.b));
      case Operation::negate:
        return fmt::format("-{}", text(s.a));
      case Operation::less:
        return fmt::format("{} < {}", text(s.a), text(s.b));
      case Operation::both:
        return fmt::format("{} and {}", text(s.a), text(s.b));
      case Operation::either:
        return fmt::format("{} or {}", text(s.a), text(s.b));
      case Operation::opposite:
        return fmt::format("not {}", text(s.a));
      default: {
        std::string out = fmt::format("{}({}", name_of(s.operation), text(s.a));
        if (operands_of(s.operation) > 1) out += ", " + text(s.b);
        if (operands_of(s.operation) > 2) out += ", " + text(s.c);
        return out + ")";
      }
    }
  };

  std::string out;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (operands_of(steps[i].operation) > 0) out += fmt::format("v{} = {}\n", i, expression(steps[i]));
  for (std::size_t o = 0; o < program.outputs().size(); ++o)
    out += fmt::format("{} = {}\n", named(outputs, static_cast<int>(o), 'y'), text(program.outputs()[o]));
  return out;
}

}  // namespace pmreport::program
