// A program on any kind of number: a scalar T with the functions of pmreport/scalar.hpp, whose comparisons give masks of the type
// decltype(a < b).
#pragma once

#include <core/program/program.hpp>
#include <pmreport/scalar.hpp>

#include <span>
#include <vector>

namespace pmreport::program {

// Of numbers; an interval has its own (interval.hpp).
template <class Mask, class T>
const T& settled(const Mask&, const T& derivative) {
  return derivative;
}
template <class T>
const T& uncut(const T&, const T&, const T& derivative) {
  return derivative;
}

// Keeps its buffers: one a thread.
template <class T>
class Evaluator {
 public:
  using Mask = decltype(std::declval<const T&>() < std::declval<const T&>());

  explicit Evaluator(const Program& program)
      : program_(program), values_(program.steps().size()), masks_(program.steps().size(), Mask(T(0.0) < T(0.0))) {}

  // `in`: one number an input; `out`: one an output.
  void run(std::span<const T> in, std::span<T> out) {
    const std::span<const Step> steps = program_.steps();
    for (std::size_t i = 0; i < steps.size(); ++i) step(i, steps[i], in);
    for (std::size_t o = 0; o < out.size(); ++o) out[o] = value(program_.outputs()[o]);
  }

 private:
  const T& value(int i) const { return values_[static_cast<std::size_t>(i)]; }
  Mask mask(int i) const { return masks_[static_cast<std::size_t>(i)]; }

  void step(std::size_t i, const Step& s, std::span<const T> in) {
    T& x = values_[i];
    switch (s.operation) {
      case Operation::constant:
        x = T(s.constant);
        break;
      case Operation::input:
        x = in[static_cast<std::size_t>(s.a)];
        break;
      case Operation::add:
        x = value(s.a) + value(s.b);
        break;
      case Operation::subtract:
        x = value(s.a) - value(s.b);
        break;
      case Operation::multiply:
        x = value(s.a) * value(s.b);
        break;
      case Operation::divide:
        x = value(s.a) / value(s.b);
        break;
      case Operation::negate:
        x = -value(s.a);
        break;
      case Operation::sqrt:
        x = sqrt(value(s.a));
        break;
      case Operation::sin:
        x = sin(value(s.a));
        break;
      case Operation::cos:
        x = cos(value(s.a));
        break;
      case Operation::tan:
        x = tan(value(s.a));
        break;
      case Operation::asin:
        x = asin(value(s.a));
        break;
      case Operation::acos:
        x = acos(value(s.a));
        break;
      case Operation::abs:
        x = abs(value(s.a));
        break;
      case Operation::atan2:
        x = atan2(value(s.a), value(s.b));
        break;
      case Operation::hypot:
        x = hypot(value(s.a), value(s.b));
        break;
      case Operation::square:
        x = square(value(s.a));
        break;
      case Operation::min:
        x = smaller(value(s.a), value(s.b));
        break;
      case Operation::max:
        x = larger(value(s.a), value(s.b));
        break;
      case Operation::choose:
        x = choose(mask(s.a), value(s.b), value(s.c));
        break;
      case Operation::settled:
        x = settled(mask(s.a), value(s.b));
        break;
      case Operation::uncut:
        x = uncut(value(s.a), value(s.b), value(s.c));
        break;
      case Operation::less:
        masks_[i] = value(s.a) < value(s.b);
        break;
      case Operation::both:
        masks_[i] = mask(s.a) && mask(s.b);
        break;
      case Operation::either:
        masks_[i] = mask(s.a) || mask(s.b);
        break;
      case Operation::opposite:
        masks_[i] = !mask(s.a);
        break;
    }
  }

  const Program& program_;
  std::vector<T> values_;
  std::vector<Mask> masks_;  // vector<bool> for plain numbers
};

}  // namespace pmreport::program
