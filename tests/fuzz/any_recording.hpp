// What a plugin records, as a row of choices makes it, and a box of poses to try it on.
#pragma once

#include <core/program/intervals/boxes.hpp>
#include <core/program/program.hpp>
#include <tests/fuzz/choices.hpp>

#include <cmath>
#include <iterator>
#include <vector>

namespace fuzz {

namespace program = pmreport::program;
using program::Bounds;

// Steps on earlier ones of the right kind, but for some that are not.
inline std::vector<pm_step> any_steps(Choices& choices, int inputs) {
  constexpr std::size_t most = 60;
  constexpr double some[] = {0, 1, -1, 0.5, 2, -0.0, 1e-3, 3, 1e8, 1e-300, 1e300};
  std::vector<pm_step> out;
  std::vector<int> numbers, masks;
  for (int i = 0; i < inputs; ++i) numbers.push_back(i), out.push_back({PM_OP_INPUT, i, 0, 0, 0});
  while (choices.more() && out.size() < most) {
    const std::size_t kind = choices.of(64);
    pm_step s{static_cast<pm_operation>(kind % PM_OP_COUNT), 0, 0, 0, 0};
    if (kind == 63) {
      s = {choices.take<std::int8_t>(), choices.take<std::int8_t>(), choices.take<std::int8_t>(), choices.take<std::int8_t>(),
           choices.take<double>()};
    } else if (s.operation == PM_OP_CONSTANT) {
      const std::size_t which = choices.of(std::size(some) + 1);
      s.constant = which < std::size(some) ? some[which] : choices.take<double>();
    } else if (s.operation == PM_OP_INPUT) {
      s.a = static_cast<int>(choices.of(static_cast<std::size_t>(inputs)));
    } else {
      const bool of_masks = s.operation >= PM_OP_AND && s.operation <= PM_OP_NOT, chooses = s.operation == PM_OP_CHOOSE;
      if ((of_masks || chooses) && masks.empty()) continue;
      const auto any = [&](const std::vector<int>& from) { return from[choices.of(from.size())]; };
      s.a = any(of_masks || chooses ? masks : numbers);
      s.b = any(of_masks ? masks : numbers);
      s.c = chooses ? any(numbers) : 0;
    }
    (s.operation >= PM_OP_LESS && s.operation <= PM_OP_NOT ? masks : numbers).push_back(static_cast<int>(out.size()));
    out.push_back(s);
  }
  return out;
}

// A box and two poses in it.
struct Box {
  std::vector<Bounds> bounds;
  std::vector<double> first, second;

  Box(Choices& choices, std::size_t inputs) {
    for (std::size_t i = 0; i < inputs; ++i) {
      const double middle = choices.take<std::int8_t>() / 16.0, half = std::ldexp(1.0, -static_cast<int>(choices.of(40)));
      const Bounds b{middle - half, middle + half};
      bounds.push_back(choices.once_in(8) ? Bounds::exactly(middle) : b);
      for (std::vector<double>* pose : {&first, &second})
        pose->push_back(std::lerp(bounds.back().low, bounds.back().high, choices.take<std::uint8_t>() / 255.0));
    }
  }
  std::vector<Bounds> of(const program::Program& p) const { return of(p, bounds); }
  static std::vector<Bounds> of(const program::Program& p, const std::vector<double>& pose) {
    std::vector<Bounds> in;
    for (const double x : pose) in.push_back(Bounds::exactly(x));
    return of(p, in);
  }

 private:
  static std::vector<Bounds> of(const program::Program& p, const std::vector<Bounds>& in) {
    std::vector<Bounds> out(p.outputs().size());
    program::Boxes(p).run(1, in.data(), out.data());
    return out;
  }
};

}  // namespace fuzz
