// A program on intervals, many boxes at a time.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <core/program/program.hpp>

#include <memory>

namespace pmreport::program {

// Rounds upward within, and gives back the rounding mode that it found. Keeps its buffers: one a thread. The vectors are those of the
// processor that it runs on; the digits are those of Evaluator<Interval>, the same on all, but that the library's tan, asin, acos and atan2
// may be computed otherwise on a processor that multiplies and adds at once.
class Boxes {
 public:
  explicit Boxes(const Program& program);
  ~Boxes();
  Boxes(Boxes&&) noexcept;

  // Box k has input i between the bounds in[i * count + k], and then, wherever in it, output o between out[o * count + k]. An output is
  // bounded only where all that it takes has a value throughout the box.
  void run(std::size_t count, const Bounds* in, Bounds* out);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace pmreport::program
