#include <core/scan/proof/apart.hpp>

#include <core/program/builder.hpp>

#include <algorithm>
#include <vector>

namespace pmreport::scan {

using program::Builder, program::Operation, program::Program, program::Step;

namespace {

// Steps that are never negative, as the squares of components are, and sums and roots of such.
std::vector<bool> never_negative(std::span<const Step> steps) {
  std::vector<bool> out(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& s = steps[i];
    const auto is = [&](int operand) { return static_cast<bool>(out[static_cast<std::size_t>(operand)]); };
    switch (s.operation) {
      case Operation::constant:
        out[i] = s.constant >= 0;
        break;
      case Operation::square:
      case Operation::sqrt:
      case Operation::abs:
      case Operation::hypot:
        out[i] = true;
        break;
      case Operation::add:
      case Operation::multiply:
        out[i] = is(s.a) && is(s.b);
        break;
      default:
        break;
    }
  }
  return out;
}

class Apart {
 public:
  explicit Apart(const Program& margins) : positive_(never_negative(margins.steps())), builder_(2 * margins.steps().size()) {
    std::vector<int> now(margins.steps().size());  // which step gives what step i gave
    std::vector<int> radicands;
    for (std::size_t i = 0; i < now.size(); ++i) {
      Step s = margins.steps()[i];
      const bool root = s.operation == Operation::sqrt && !positive_[static_cast<std::size_t>(s.a)];
      if (s.operation != Operation::input && s.operation != Operation::constant) {
        const int operands = operands_of(s.operation);
        if (operands > 0) s.a = now[static_cast<std::size_t>(s.a)];
        if (operands > 1) s.b = now[static_cast<std::size_t>(s.b)];
        if (operands > 2) s.c = now[static_cast<std::size_t>(s.c)];
      }
      if (root) {
        radicands.push_back(s.a);
        s.a = builder_.add(Operation::max, s.a, builder_.constant(0));
      }
      now[i] = builder_.add(s);
    }
    std::vector<int> more, more_of;
    for (const int o : margins.outputs()) {
      std::vector<int> parts;
      least_of(now[static_cast<std::size_t>(o)], parts);
      const int number = static_cast<int>(outputs_.size());
      outputs_.push_back(parts.front());
      part_of_.push_back(number);
      more.insert(more.end(), parts.begin() + 1, parts.end());
      more_of.resize(more.size(), number);
    }
    more.insert(more.end(), radicands.begin(), radicands.end());
    more_of.resize(more.size(), 0);
    for (std::size_t k = 0; k < more.size(); ++k)
      if (std::ranges::find(outputs_, more[k]) == outputs_.end()) {
        outputs_.push_back(more[k]);
        part_of_.push_back(more_of[k]);
      }
  }

  TakenApart taken(int inputs) const { return {Program(builder_.steps(), inputs, outputs_), part_of_}; }

 private:
  void least_of(int step, std::vector<int>& out) const {
    const Step& s = builder_.step(step);
    if (s.operation != Operation::min) {
      out.push_back(step);
      return;
    }
    least_of(s.a, out);
    least_of(s.b, out);
  }

  std::vector<bool> positive_;
  Builder builder_;
  std::vector<int> outputs_, part_of_;
};

}  // namespace

TakenApart taken_apart(const Program& margins) { return Apart(margins).taken(margins.inputs()); }

}  // namespace pmreport::scan
