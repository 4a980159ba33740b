#include <tests/proof/sine_motion.hpp>

#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>

namespace pmreport::test {

namespace {

using program::Bounds, program::Interval;

// The angle to the second order of the span is exact: it is linear in time.
void bound(const Sine& s, Bounds time, mechanics::Bounded& out) {
  const Interval angle = Interval(time) * s.frequency + s.phase, sine = sin(angle), cosine = cos(angle);
  const double w = s.frequency;
  out.value = (sine * s.amplitude + s.middle).bounds();
  out.rate = (cosine * s.amplitude * w).bounds();
  out.acceleration = (-(sine * s.amplitude) * w * w).bounds();
}

}  // namespace

mechanics::Enclosure bounds_of(std::vector<Sine> sines) {
  return [sines = std::move(sines)](Bounds time, mechanics::Bounded* out) {
    program::round_upward([&] {
      for (std::size_t i = 0; i < sines.size(); ++i) bound(sines[i], time, out[i]);
    });
    return true;
  };
}

}  // namespace pmreport::test
