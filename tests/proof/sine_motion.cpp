#include <tests/proof/sine_motion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmreport::test {

mechanics::Enclosure bounds_of(std::vector<Sine> sines);  // in sine_motion_upward.cpp

mechanics::Trajectory sine_motion(std::vector<Sine> sines, double duration, int samples) {
  std::vector<double> times;
  for (int k = 0; k < samples; ++k) times.push_back(duration * k / (samples - 1));
  const int dof = static_cast<int>(sines.size());
  mechanics::Trajectory out = mechanics::sampled(
      [sines](double t, double* value, double* rate, double* acceleration) {
        for (const Sine& s : sines) {
          const double angle = t * s.frequency + s.phase;
          *value++ = s.amplitude * std::sin(angle) + s.middle;
          *rate++ = s.amplitude * std::cos(angle) * s.frequency;
          *acceleration++ = -s.amplitude * std::sin(angle) * s.frequency * s.frequency;
        }
        return true;
      },
      std::move(times), dof);
  out.over = bounds_of(std::move(sines));
  return out;
}

Law law_of(std::vector<Sine> sines) {
  return [sines = std::move(sines)](long double t, long double* value, long double* rate, long double* acceleration) {
    for (const Sine& s : sines) {
      const long double angle = t * s.frequency + s.phase, w = s.frequency;
      *value++ = s.amplitude * std::sin(angle) + s.middle;
      *rate++ = s.amplitude * std::cos(angle) * w;
      *acceleration++ = -s.amplitude * std::sin(angle) * w * w;
    }
  };
}

std::vector<Sine> three_frequencies(const mechanics::Machine& machine, double share, double duration) {
  std::vector<Sine> out;
  for (const Coordinate& c : machine.topology().coordinates) {
    const auto i = static_cast<double>(out.size());
    out.push_back({c.home, share * std::min(c.box.max - c.home, c.home - c.box.min),
                   2 * std::numbers::pi / duration * (1 + static_cast<double>(out.size() % 3)), i});
  }
  return out;
}

}  // namespace pmreport::test
