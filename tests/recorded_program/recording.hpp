// Functions as programs, recorded as a plugin or the host would.
#pragma once

#include <core/program/recorder.hpp>
#include <tests/pmreport/functions.hpp>

#include <array>
#include <vector>

namespace recording {

using namespace pmreport;
using program::Operation;
using program::Program;
using program::Step;

// f of so many inputs: from a vector of numbers to a vector of numbers.
template <class F>
Program recorded(int inputs, F&& f) {
  program::Recorder recorder(inputs);
  std::vector<Recorded> x;
  for (int i = 0; i < inputs; ++i) x.push_back(recorder.input(i));
  const std::vector<Recorded> y = f(x);
  return recorder.finish(y);
}
template <class F>
Program recorded_of_one(F&& f) {
  return recorded(1, [&](const auto& x) { return std::vector<Recorded>{f(x[0])}; });
}
template <class F>
Program recorded_of_two(F&& f) {
  return recorded(2, [&](const auto& x) { return std::vector<Recorded>{f(x[0], x[1])}; });
}

// Of three numbers, with every operation that there is, outputs that are inputs, constants and the same once more.
struct Everything {
  static constexpr int inputs = 3;
  template <class T>
  std::vector<T> operator()(const std::vector<T>& q) const {
    const T &x = q[0], &y = q[1], &z = q[2];
    const T s = sin(x) * cos(y) + z * z, a = sqrt(x * x + y * y + z * z + 0.5);
    const auto before = x < y && !(y < z);
    const auto behind = z < y || !(y < 0.1);
    return {s,
            a,
            x / a,
            1.0 / a,
            atan2(s, y),
            hypot(s, z),
            tan(0.3 * x) - s,
            asin(0.2 * sin(s)),
            acos(0.2 * cos(z)),
            abs(s - 0.3),
            smaller(s, y),
            larger(s, y) * x,
            choose(x < 0.3 * y, z * y, y / (z * z + 1.0)),
            -s * a / (s * s + 3.0),
            choose(before, z * y, T(2.0)),
            choose(behind, 1.0 + z * y, x),
            y,
            T(3.0),
            s,
            sqrt(y * y + 1.0) * sin(y)};
  }
};
inline Program everything() { return recorded(Everything::inputs, Everything()); }

inline std::vector<double> random_numbers(functions::Random& random, std::size_t count, double size = 2) {
  std::vector<double> out(count);
  for (double& x : out) x = random.within(-size, size);
  return out;
}

}  // namespace recording
