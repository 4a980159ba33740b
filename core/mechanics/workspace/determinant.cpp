// The determinant of G by its minors of three rows and columns (Laplace): no division, so that it is as good over intervals as at a pose.
#include <core/mechanics/workspace/pose_limits.hpp>

#include <core/program/recorder.hpp>

#include <array>

namespace pmreport::mechanics {

program::Program determinant_program(const Machine& machine) {
  program::Recorder recorder(*machine.program());
  const std::size_t first = machine.layout().size();
  const auto g = [&](int row, int column) { return recorder.output(static_cast<int>(first) + 6 * row + column); };
  const auto minor = [&](int row, const std::array<int, 3>& c) {
    const auto two = [&](int a, int b) { return g(row + 1, a) * g(row + 2, b) - g(row + 1, b) * g(row + 2, a); };
    return g(row, c[0]) * two(c[1], c[2]) - g(row, c[1]) * two(c[0], c[2]) + g(row, c[2]) * two(c[0], c[1]);
  };
  Recorded sum(0.0);
  for (int a = 0; a < 6; ++a)
    for (int b = a + 1; b < 6; ++b)
      for (int c = b + 1; c < 6; ++c) {
        std::array<int, 3> rest{};
        std::size_t n = 0;
        for (int k = 0; k < 6; ++k)
          if (k != a && k != b && k != c) rest[n++] = k;
        const Recorded term = minor(0, {a, b, c}) * minor(3, rest);
        // The sign of the permutation that puts columns a, b, c first.
        (a + b + c) % 2 == 1 ? sum += term : sum -= term;
      }
  const std::array outputs{sum};
  return recorder.finish(outputs);
}

}  // namespace pmreport::mechanics
