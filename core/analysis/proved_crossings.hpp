// Where a motion meets a singular surface, by its samples and by proof, told once.
#pragma once

#include <core/analysis/crossings.hpp>
#include <core/analysis/proof/proof.hpp>

#include <vector>

namespace pmreport::analysis {

// What the samples found and the proof confirms gets the interval in which it is proved to happen, one meeting a crossing. Crossings that
// the proof alone finds, as two within one step, are added, in order; a touch of the samples that was such a pair goes. What the proof only
// leaves open, a touch or a G without bound, is added nowhere: it is not decided.
void match_with_proof(std::vector<Crossing>& crossings, const MotionProof& proof, const mechanics::Trajectory& trajectory);

}  // namespace pmreport::analysis
