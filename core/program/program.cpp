#include <core/program/program.hpp>

#include <core/assertion.hpp>

#include <fmt/format.h>

#include <cmath>
#include <core/program/builder.hpp>

namespace pmreport::program {

namespace {

struct Form {
  const char* name;
  int operands;
  bool of_masks;  // its operands are masks; of choose and settled the first alone
  bool mask;      // its value is one
};
constexpr Form forms[] = {
    {"constant", 0, false, false}, {"input", 0, false, false},  {"add", 2, false, false},    {"subtract", 2, false, false},
    {"multiply", 2, false, false}, {"divide", 2, false, false}, {"negate", 1, false, false}, {"sqrt", 1, false, false},
    {"sin", 1, false, false},      {"cos", 1, false, false},    {"tan", 1, false, false},    {"asin", 1, false, false},
    {"acos", 1, false, false},     {"abs", 1, false, false},    {"atan2", 2, false, false},  {"hypot", 2, false, false},
    {"less", 2, false, true},      {"both", 2, true, true},     {"either", 2, true, true},   {"opposite", 1, true, true},
    {"choose", 3, true, false},    {"square", 1, false, false}, {"min", 2, false, false},    {"max", 2, false, false},
    {"settled", 2, true, false},   {"uncut", 3, false, false},
};
constexpr std::size_t operations = std::size(forms);
static_assert(operations == static_cast<std::size_t>(Operation::uncut) + 1);

const Form& form(Operation o) { return forms[static_cast<std::size_t>(o)]; }

// What every step must be, given those before it.
void demand_sound(const Step& s, std::size_t number, std::span<const Step> before, int inputs) {
  const auto wrong = [&](const std::string& what) { throw ProgramError(fmt::format("{} as step {}", what, number + 1)); };
  if (static_cast<std::size_t>(s.operation) >= operations)
    wrong(fmt::format("operation {}, which does not exist,", static_cast<int>(s.operation)));
  if (s.operation == Operation::constant && !std::isfinite(s.constant)) wrong("a constant that is not finite");
  if (s.operation == Operation::input && (s.a < 0 || s.a >= inputs)) wrong(fmt::format("coordinate {} of {}", s.a + 1, inputs));
  const int operands[] = {s.a, s.b, s.c};
  for (int k = 0; k < form(s.operation).operands; ++k) {
    if (operands[k] < 0 || static_cast<std::size_t>(operands[k]) >= number) wrong("an operation on a step that is not before it");
    const bool first_alone = s.operation == Operation::choose || s.operation == Operation::settled;
    const bool mask = form(s.operation).of_masks && (!first_alone || k == 0);
    if (gives_mask(before[static_cast<std::size_t>(operands[k])].operation) != mask)
      wrong(mask ? "a number in the place of a comparison" : "a comparison in the place of a number");
  }
}

// The step on operands by their numbers now.
Step renumbered(Step s, const std::vector<int>& now) {
  int* operands[] = {&s.a, &s.b, &s.c};
  for (int k = 0; k < operands_of(s.operation); ++k) *operands[k] = now[static_cast<std::size_t>(*operands[k])];
  return s;
}

// Hands the steps that the outputs need, and all that these need, to `add`, which gives their new numbers. Returns those of the outputs.
template <class Add>
std::vector<int> copy_needed(std::span<const Step> steps, std::span<const int> outputs, Add&& add) {
  std::vector<bool> needed(steps.size());
  for (const int o : outputs) needed[static_cast<std::size_t>(o)] = true;
  for (std::size_t i = steps.size(); i-- > 0;) {
    const int operands[] = {steps[i].a, steps[i].b, steps[i].c};
    for (int k = 0; needed[i] && k < operands_of(steps[i].operation); ++k) needed[static_cast<std::size_t>(operands[k])] = true;
  }
  std::vector<int> now(steps.size(), -1);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!needed[i]) continue;
    now[i] = add(renumbered(steps[i], now));
  }
  std::vector<int> out;
  for (const int o : outputs) out.push_back(now[static_cast<std::size_t>(o)]);
  return out;
}

}  // namespace

int operands_of(Operation o) { return form(o).operands; }
bool gives_mask(Operation o) { return form(o).mask; }
const char* name_of(Operation o) { return form(o).name; }

Program composed(const Program& outer, const Program& inner) {
  PMREPORT_ASSERT(inner.outputs().size() == static_cast<std::size_t>(outer.inputs()), "programs follow one another number by number");
  Builder list(inner.steps().size() + outer.steps().size());
  std::vector<int> first(inner.steps().size()), second(outer.steps().size());
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = list.add(renumbered(inner.steps()[i], first));
  for (std::size_t i = 0; i < second.size(); ++i) {
    const Step& s = outer.steps()[i];
    second[i] = s.operation == Operation::input ? first[static_cast<std::size_t>(inner.outputs()[static_cast<std::size_t>(s.a)])]
                                                : list.add(renumbered(s, second));
  }
  std::vector<int> outputs;
  for (const int o : outer.outputs()) outputs.push_back(second[static_cast<std::size_t>(o)]);
  return Program(list.steps(), inner.inputs(), outputs);
}

Program joined(const Program& first, const Program& second) {
  PMREPORT_ASSERT(first.inputs() == second.inputs(), "programs of the same numbers are joined");
  std::vector<Step> steps(first.steps().begin(), first.steps().end());
  std::vector<int> now, outputs(first.outputs().begin(), first.outputs().end());
  for (const Step& s : second.steps()) {
    now.push_back(static_cast<int>(steps.size()));
    steps.push_back(renumbered(s, now));
  }
  for (const int o : second.outputs()) outputs.push_back(now[static_cast<std::size_t>(o)]);
  return Program(steps, first.inputs(), outputs);
}

std::vector<Step> steps_of(std::span<const pm_step> recorded) {
  std::vector<Step> out;
  out.reserve(recorded.size());
  for (const pm_step& s : recorded) {
    if (s.operation < 0 || s.operation >= PM_OP_COUNT)
      throw ProgramError(fmt::format("operation {}, which this pmreport does not know", s.operation));
    out.push_back({static_cast<Operation>(s.operation), s.a, s.b, s.c, s.constant});
  }
  return out;
}

Program::Program(std::span<const Step> steps, int inputs, std::span<const int> outputs) : inputs_(inputs) {
  if (steps.size() > most_steps)
    throw ProgramError(fmt::format("{} operations, more than the {} that are looked at", steps.size(), most_steps));
  for (std::size_t i = 0; i < steps.size(); ++i) demand_sound(steps[i], i, steps, inputs);
  for (const int o : outputs) {
    if (o < 0 || static_cast<std::size_t>(o) >= steps.size()) throw ProgramError("a result that no step gives");
    if (gives_mask(steps[static_cast<std::size_t>(o)].operation)) throw ProgramError("a comparison as a result");
  }

  // What is needed, each once; and, since that leaves steps behind which nobody needs any more, of these again what is needed.
  Builder builder(steps.size());
  outputs_ = copy_needed(steps, outputs, [&](const Step& s) { return builder.add(s); });
  outputs_ = copy_needed(builder.steps(), outputs_, [&](const Step& s) {
    steps_.push_back(s);
    return static_cast<int>(steps_.size()) - 1;
  });
}

// Its steps are sound, and each stands once.
Program Program::slice(std::span<const int> outputs) const {
  std::vector<int> steps;
  for (const int o : outputs) steps.push_back(outputs_[static_cast<std::size_t>(o)]);
  Program out;
  out.inputs_ = inputs_;
  out.outputs_ = copy_needed(steps_, steps, [&](const Step& s) {
    out.steps_.push_back(s);
    return static_cast<int>(out.steps_.size()) - 1;
  });
  return out;
}

std::vector<std::uint64_t> Program::dependence() const {
  std::vector<std::uint64_t> out(steps_.size(), 0);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& s = steps_[i];
    if (s.operation == Operation::input) out[i] = std::uint64_t{1} << s.a;
    const int operands[] = {s.a, s.b, s.c};
    for (int k = 0; k < operands_of(s.operation); ++k) out[i] |= out[static_cast<std::size_t>(operands[k])];
  }
  return out;
}

}  // namespace pmreport::program
