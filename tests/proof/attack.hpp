// A proof held against the motion that it is about, at many instants, in extended precision. Nothing of the prover is used: values, rates
// and accelerations come from the recorded geometry by the Taylor arithmetic of pmreport/jet.hpp on long doubles; the sign of det G from
// its factors; what should be claimed, from the topology.
#pragma once

#include <core/analysis/proof/proof.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/recorded/motion_program.hpp>
#include <tests/proof/law.hpp>

#include <string>
#include <vector>

namespace pmreport::test {

struct Attack {
  int random = 500;   // instants spread over the motion; as many more about the times that the proof names
  int dense = 20000;  // instants, evenly, at which the side of det G is looked at
  unsigned seed = 1;
  // Of rounding in the oracle and the law, relative to the largest magnitude of a quantity over the motion; rates and accelerations
  // lose more digits near the end of a limb's reach.
  long double tolerance = 1e-15L, of_rates = 1e-14L, of_accelerations = 1e-12L;
};

constexpr std::size_t most_told_of_attacks = 8;
// What contradicts the proof, a sentence each, that many at most; empty: nothing was found.
std::vector<std::string> contradictions(const mechanics::Machine& machine, const mechanics::MotionProgram& program,
                                        const analysis::MotionProof& proof, const Law& law, const Attack& attack = {});
std::vector<std::string> contradictions(const mechanics::Machine& machine, const analysis::MotionProof& proof, const Law& law,
                                        const Attack& attack = {});

// The same by the plugin itself, `place` and `jacobian` on doubles, and the host's joint motions, at so many random instants: claims that
// hold, and brackets of values.
std::vector<std::string> contradictions_by_plugin(const mechanics::Machine& machine, const analysis::MotionProof& proof, const Law& law,
                                                  int instants, unsigned seed);

std::string joined(const std::vector<std::string>& sentences);

}  // namespace pmreport::test
