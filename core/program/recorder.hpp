// Recording on top of a program: the host's own geometry, written over the scalar as a plugin's is, continues the list.
#pragma once

#include <core/program/program.hpp>
#include <pmreport/recorded.hpp>

#include <memory>
#include <span>
#include <vector>

namespace pmreport::program {

class Recorder {
 public:
  explicit Recorder(const Program& start);
  explicit Recorder(int inputs) : Recorder(Program({}, inputs, {})) {}
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  Recorded input(int i) { return Recorded::input(list_, i); }
  Recorded output(int o) const { return step(start_.outputs()[static_cast<std::size_t>(o)]); }  // of the program started from
  Recorded step(int s) const;                                                                   // likewise
  static constexpr std::size_t most_recorded = 1 << 14;                                         // on top of the program

  // The program of these numbers. Throws ProgramError: more steps than there is room for.
  Program finish(std::span<const Recorded> outputs);

 private:
  Program start_;
  std::vector<pm_step> steps_;
  mutable pm_recording list_{};
};

}  // namespace pmreport::program
