#include <core/program/common_divisors.hpp>

#include <core/program/builder.hpp>

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <vector>

namespace pmreport::program {

namespace {

// Numbers times `divisor`, a step of the same list; nothing where it is no divisor of one of them.
class Undivided {
 public:
  Undivided(Builder& builder, int divisor) : b_(builder), divisor_(divisor) {}

  std::optional<int> operator()(int step) {
    if (const auto found = known_.find(step); found != known_.end()) return found->second;
    const std::optional<int> out = of(step);
    known_.emplace(step, out);
    return out;
  }

 private:
  std::optional<int> of(int number) {
    const Step s = b_.step(number);
    switch (s.operation) {
      case Operation::constant:
        if (s.constant == 0) return number;
        return {};
      case Operation::divide:
        if (s.b == divisor_) return s.a;
        if (const auto a = (*this)(s.a)) return b_.add(Operation::divide, *a, s.b);
        return {};
      case Operation::negate:
        if (const auto a = (*this)(s.a)) return b_.add(Operation::negate, *a);
        return {};
      case Operation::add:
      case Operation::subtract:
        if (const auto a = (*this)(s.a))
          if (const auto b = (*this)(s.b)) return b_.add(s.operation, *a, *b);
        return {};
      case Operation::multiply:
        if (const auto a = (*this)(s.a)) return b_.add(Operation::multiply, *a, s.b);
        if (const auto b = (*this)(s.b)) return b_.add(Operation::multiply, s.a, *b);
        return {};
      default:
        return {};
    }
  }

  Builder& b_;
  int divisor_;
  std::unordered_map<int, std::optional<int>> known_;
};

// What a number is divided by, as sums and products show it.
void divisors_of(const Builder& b, int number, std::vector<bool>& seen, std::vector<int>& out) {
  if (seen[static_cast<std::size_t>(number)]) return;
  seen[static_cast<std::size_t>(number)] = true;
  const Step& s = b.step(number);
  switch (s.operation) {
    case Operation::divide:
      if (std::ranges::find(out, s.b) == out.end()) out.push_back(s.b);
      divisors_of(b, s.a, seen, out);
      return;
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
      divisors_of(b, s.b, seen, out);
      [[fallthrough]];
    case Operation::negate:
      divisors_of(b, s.a, seen, out);
      return;
    default:
      return;
  }
}

}  // namespace

Program without_common_divisors(const Program& program, std::size_t group) {
  Builder builder(2 * program.steps().size());
  std::vector<int> now;
  for (Step s : program.steps()) {
    int* operands[] = {&s.a, &s.b, &s.c};
    for (int k = 0; k < operands_of(s.operation); ++k) *operands[k] = now[static_cast<std::size_t>(*operands[k])];
    now.push_back(builder.add(s));
  }
  std::vector<int> outputs;
  for (const int o : program.outputs()) outputs.push_back(now[static_cast<std::size_t>(o)]);

  const auto undivided = [&](std::vector<int>& numbers) {
    std::vector<int> divisors;
    std::vector<bool> seen(builder.steps().size());
    for (const int n : numbers) divisors_of(builder, n, seen, divisors);
    for (const int d : divisors) {
      Undivided times(builder, d);
      std::vector<int> out;
      for (const int n : numbers)
        if (const auto x = times(n)) out.push_back(*x);
      if (out.size() < numbers.size()) continue;
      numbers = out;
      return true;
    }
    return false;
  };
  for (std::size_t first = 0; first < outputs.size(); first += group) {
    const auto begin = outputs.begin() + static_cast<std::ptrdiff_t>(first),
               end = begin + static_cast<std::ptrdiff_t>(std::min(group, outputs.size() - first));
    std::vector<int> numbers(begin, end);
    while (undivided(numbers)) {
    }
    std::ranges::copy(numbers, begin);
  }
  return Program(builder.steps(), program.inputs(), outputs);
}

}  // namespace pmreport::program
