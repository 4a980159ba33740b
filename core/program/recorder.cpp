#include <core/program/recorder.hpp>

namespace pmreport::program {

// The host's list also has the operations that are no longer the contract's: under their own numbers.
Recorder::Recorder(const Program& start) : start_(start), steps_(start.steps().size() + most_recorded) {
  list_ = {sizeof(pm_recording), steps_.data(), steps_.size(), start.steps().size(), nullptr};
  for (std::size_t i = 0; i < start.steps().size(); ++i) {
    const Step& s = start.steps()[i];
    steps_[i] = {static_cast<pm_operation>(s.operation), s.a, s.b, s.c, s.constant};
  }
}

Recorded Recorder::step(int number) const {
  const pm_step& s = steps_[static_cast<std::size_t>(number)];
  return s.operation == PM_OP_CONSTANT ? Recorded(s.constant) : Recorded(list_, number);
}

Program Recorder::finish(std::span<const Recorded> outputs) {
  std::vector<int> numbers;
  for (const Recorded& x : outputs) numbers.push_back(x.step(list_));
  std::vector<Step> steps;
  for (std::size_t i = 0; i < std::min(list_.count, steps_.size()); ++i) {
    const pm_step& s = steps_[i];
    steps.push_back({static_cast<Operation>(s.operation), s.a, s.b, s.c, s.constant});
  }
  if (list_.count > steps_.size()) throw ProgramError("more operations than there is room for");
  return Program(steps, start_.inputs(), numbers);
}

}  // namespace pmreport::program
