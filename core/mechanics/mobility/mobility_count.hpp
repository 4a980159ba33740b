// How many degrees of freedom a mechanism has, found by rank.
#pragma once

#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

// With PHI the constraint rows of the generic model (generic_model.hpp) on the twists of the n moving bodies, P the six rows that show the
// twist of the platform and B those that show the actuator rates,
//     motions                       6 n - rank PHI                          (1)
//     idle, unseen by P and B       6 n - rank [PHI; P; B]                  (2)
//     freedoms                      (1) - (2)
//     redundant constraints         rows of PHI - rank PHI                  (3)
// Gruebler's count, 6 (links - joints - 1) + sum f - idle, knows no (3) and falls short by it.
struct Mobility {
  int bodies = 0;  // links, base included
  int joints = 0;
  int freedoms_sum = 0;  // of all joints
  int gruebler = 0;      // with the declared number of idle freedoms
  int rows = 0;          // of PHI
  int rank = 0;          // of PHI
  int idle = 0;          // (2)
  int freedoms = 0;
  int redundant = 0;  // (3)
};

// Of an assembled pose: `state.status` is PM_OK; its rates play no part. Ranks at linear::rank_tolerance, rotations per characteristic
// length.
Mobility mobility(const Machine& machine, const State& state);

}  // namespace pmreport::mechanics
