// A list of steps in which every operation stands once.
#pragma once

#include <core/program/program.hpp>

#include <span>
#include <unordered_map>
#include <vector>

namespace pmreport::program {

class Builder {
 public:
  explicit Builder(std::size_t expected = 256) { steps_.reserve(expected), numbers_.reserve(expected); }  // so many steps, more or fewer

  // The number of the step that gives what `s` says, whose operands are steps of this list: an old one, or a new one at the end. Folded as
  // Program tells. Masks that are known fold too, and then are constants 0 and 1 to choose, both, either, opposite alone.
  int add(Step s);
  int constant(double x) { return add({Operation::constant, 0, 0, 0, x}); }
  int input(int i) { return add({Operation::input, i}); }
  int add(Operation o, int a, int b = 0, int c = 0) { return add(Step{o, a, b, c}); }

  std::span<const Step> steps() const { return steps_; }
  const Step& step(int i) const { return steps_[static_cast<std::size_t>(i)]; }

 private:
  struct Hash {
    std::size_t operator()(const Step& s) const;
  };
  struct Same {
    bool operator()(const Step& x, const Step& y) const;
  };
  bool is_constant(int i) const { return step(i).operation == Operation::constant; }
  bool is(int i, double x) const { return is_constant(i) && step(i).constant == x; }
  int known(const Step& s);  // an older step that gives the same, or -1
  int append(const Step& s);

  std::vector<Step> steps_;
  std::unordered_map<Step, int, Hash, Same> numbers_;
};

}  // namespace pmreport::program
