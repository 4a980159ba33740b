// A motion of sines in every coordinate, known at every instant and over every span: for proofs, without a scenario.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <tests/proof/law.hpp>

#include <vector>

namespace pmreport::test {

struct Sine {
  double middle, amplitude, frequency, phase;  // middle + amplitude sin(frequency t + phase)
};

// The same in extended precision.
Law law_of(std::vector<Sine> sines);
// From 0 to `duration` [s] with so many samples.
mechanics::Trajectory sine_motion(std::vector<Sine> sines, double duration, int samples);

// Each coordinate about home with a share of its box, in three frequencies.
std::vector<Sine> three_frequencies(const mechanics::Machine& machine, double share, double duration);

}  // namespace pmreport::test
